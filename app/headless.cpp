#include "app/headless.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "app/interruption.h"
#include "app/paths.h"
#include "app/stage.h"

namespace unghost {
namespace {

#ifdef NDEBUG
constexpr bool debug_build = false;
#else
constexpr bool debug_build = true;
#endif

} // namespace

FrameInput frame_input(const Shot& shot, const RigContext& context, std::span<const ModeRun> modes,
                       uint32_t index) {
  if (shot.replay) return frame_input(shot.replay->recording, context, index);
  const auto at = [&](uint32_t frame) {
    return Moment{.rig = shot.rig, .rig_frame = frame, .index = frame, .size = shot.size, .cut = frame == 0};
  };
  const Moment now = at(index), before = at(index == 0 ? 0 : index - 1);
  return frame_input(now, instant_of(now, context), instant_of(before, context), shot.settings,
                     {modes.begin(), modes.end()});
}

Headless::Headless(const CommandLine& line, const Shot& shot, Console& console)
    : line_(line), shot_(shot), console_(console) {
  const DataFolders folders = find_data_folders();
  device_ = std::make_unique<Device>(DeviceRequest{.which = line.device, .validate = line.validate});
  Staged staged = stage_scene(shot.scene, folders, shot.settings.stage, *device_);
  context_ = rig_context(staged, shot.seed, shot.settings);
  if (!console.quiet)
    for (const std::string& warning : staged.scene.warnings)
      console.err << shot.scene << ": " << warning << "\n";
  if (!console.quiet) say_banner();
  renderer_ = std::make_unique<Renderer>(*device_, folders.shaders, std::move(staged.scene));
}

Headless::~Headless() = default;

void Headless::say_banner() const {
  const DeviceFacts& facts = device_->facts();
  if (console_.verbose) console_.err << "device: " << facts.name << ", " << facts.driver << "\n";
  std::string why;
  const auto add = [&why](bool holds, const char* reason) {
    if (holds) why += (why.empty() ? "" : ", ") + std::string(reason);
  };
  add(facts.software, "a software device");
  add(line_.validate, "validation is on");
  add(debug_build, "a debug build");
  if (!why.empty()) console_.err << "times are not a GPU's: " << why << "\n";
}

FrameResult Headless::render_one(const FrameInput& input) {
  FrameResult result = renderer_->render(input);
  times_.note(result);
  throw_if_interrupted(); // and not after a picture is in its place
  return result;
}

void Headless::render(std::span<const ModeRun> modes, const Wants& wants, const Take& take) {
  for (uint32_t frame = 0; frame < shot_.frames; ++frame) {
    FrameInput input = frame_input(shot_, context_, modes, frame);
    input.wanted = wants(frame);
    FrameResult result = render_one(input);
    show_progress(frame + 1);
    if (!input.wanted.empty()) take(frame, input.wanted, result);
  }
}

Film Headless::film(std::function<void(double work)> drawn) {
  return {.at = [this](uint32_t frame) { return frame_input(shot_, context_, {}, frame); },
          .draw =
              [this, drawn](const FrameInput& input) {
                FrameResult result = render_one(input);
                if (drawn) drawn(work_of(input));
                return result;
              },
          .animated = !renderer_->scene().animations.empty()};
}

void Headless::show_progress(uint32_t done) const {
  if (!console_.terminal || console_.quiet) return;
  console_.err << "\rframe " << done << " of " << shot_.frames << (done == shot_.frames ? "\n" : "")
               << std::flush;
}

nlohmann::json Headless::facts() const {
  const DeviceFacts& facts = device_->facts();
  return {{"device", facts.name},
          {"driver", facts.driver},
          {"software", facts.software},
          {"validation", line_.validate},
          {"debug_build", debug_build}};
}

void Headless::finish() const {
  if (line_.timings) console_.err << times_.text();
  report_validation(console_.err, device_->validation_messages());
}

} // namespace unghost
