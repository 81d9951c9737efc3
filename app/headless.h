// Frames without a window, one by one from a cold start.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/commands.h"
#include "app/measure/film.h"
#include "app/pass_times.h"
#include "app/rigs.h"
#include "app/shot.h"
#include "renderer/gpu/device.h"
#include "renderer/renderer.h"

namespace unghost {

/// Frame `index` of a shot: a pure function. Frame 0 is a cut, where nothing has moved. One that is replayed
/// has modes of its own.
FrameInput frame_input(const Shot& shot, const RigContext& context, std::span<const ModeRun> modes,
                       uint32_t index);

/// A shot's scene on a device. The constructor loads it, says a banner where times are not a GPU's, and
/// throws Failure and GpuError.
class Headless {
public:
  Headless(const CommandLine& line, const Shot& shot, Console& console);
  ~Headless();

  using Wants = std::function<std::vector<Wanted>(uint32_t frame)>;
  using Take = std::function<void(uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result)>;
  /// Draws every frame of the shot; `take` gets those of which something is wanted. Throws Interrupted
  /// between two frames.
  void render(std::span<const ModeRun> modes, const Wants& wants, const Take& take);

  /// The same frames on demand, for measurements; `drawn` is told of each, its work in frames of one mode.
  /// Must not outlive this.
  Film film(std::function<void(double work)> drawn = {});

  std::vector<PassSummary> passes() const { return times_.summaries(); }
  /// device, driver, software, validation, debug_build.
  nlohmann::json facts() const;
  const DeviceFacts& device() const { return device_->facts(); }
  /// Says the timings that were asked for. Throws Failure(failed) where the validation layer complained.
  void finish() const;

private:
  void say_banner() const;
  FrameResult render_one(const FrameInput& input);
  void show_progress(uint32_t done) const;

  const CommandLine& line_;
  const Shot& shot_;
  Console& console_;
  RigContext context_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<Renderer> renderer_;
  PassTimes times_;
};

} // namespace unghost
