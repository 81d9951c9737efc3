// A resolve alone, on pictures made by hand: no scene, no camera, nothing but what it reads. For the matrix
// of stiff and extreme cases, and for tests.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/gpu/frame_report.h"
#include "renderer/settings.h"

namespace unghost {

class Device;

/// What a resolve reads of one frame, row by row. Motion and depth are as passes.h has them.
struct ResolveInputs {
  uint32_t width = 16, height = 16;
  std::vector<glm::vec3> colours;    // linear
  std::vector<glm::vec2> motion;     // pixels
  std::vector<float> depth;          // reversed, near plane 0.1 m
  std::vector<float> expected_depth; // metres
  std::vector<uint32_t> objects;     // OBJECT_ words of shaders/shared/taa_key.h
  std::vector<uint8_t> tags;
  std::vector<float> light; // that arrives, in FrameConstants::light_unit
  glm::vec2 jitter_px{0};   // where the frame was sampled: shaders/shared/frame.h
  uint32_t moved_ids = 0;   // bit i: something of that id moves, or did

  explicit ResolveInputs(uint32_t w = 16, uint32_t h = 16)
      : width(w), height(h), colours(size_t(w) * h, glm::vec3(0.5f)), motion(colours.size()),
        depth(colours.size(), 0.01f), expected_depth(colours.size(), 10), objects(colours.size(), 1),
        tags(colours.size()), light(colours.size(), 1) {}
  size_t at(uint32_t x, uint32_t y) const { return size_t(y) * width + x; }
};

/// Overwrites a pixel of what this frame leaves to the next: red, green and blue alike.
struct HistoryFault {
  size_t pixel = 0;
  float value = 0;
};

class ResolveAlone {
public:
  /// `shaders`: the folder with the compiled shaders.
  ResolveAlone(Device& device, const std::filesystem::path& shaders);
  ~ResolveAlone();

  /// Resolves one more frame with each of the runs: what each makes of it, as half floats hold it. Histories
  /// go on from the frame before by place in the list, unless `cut`. `faults`: of every mode that keeps its
  /// result.
  std::vector<std::vector<glm::vec3>> resolve(const ResolveInputs& inputs, std::span<const ModeRun> runs,
                                              bool cut, std::span<const HistoryFault> faults = {});
  /// The same, of which nothing is brought back.
  void advance(const ResolveInputs& inputs, std::span<const ModeRun> runs, bool cut);
  /// Of the last frame, in the order of the runs.
  const std::vector<UsedPipeline>& ran() const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace unghost
