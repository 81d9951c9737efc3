// One pixel of what a resolve reads is no number, or none that belongs there, in one frame.
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "app/interruption.h"
#include "app/measure/display.h"
#include "app/measure/flip.h"
#include "app/measure/stability/matrix.h"
#include "app/measure/stability_table.h"

namespace unghost {
namespace {

constexpr uint32_t width = 160, height = 48, frames_before = 4, frames_after = 32;
constexpr int reach = 3; // pixels: nothing beyond may ever change
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float faults[] = {std::numeric_limits<float>::quiet_NaN(), infinite, -infinite, -1, 65504, 1e30f};

/// A picture with texture, a little other in every frame, as a jittered one is.
ResolveInputs picture(uint32_t frame) {
  ResolveInputs inputs(width, height);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const uint32_t hash = (x * 73856093u ^ y * 19349663u ^ frame * 83492791u) * 2654435769u;
      const float noise = float(hash >> 8) / float(1u << 24);
      const float texture = 0.25f + 0.2f * std::sin(float(x) * 0.7f) * std::sin(float(y) * 0.5f);
      inputs.colours[inputs.at(x, y)] = glm::vec3(1, 0.8f, 0.6f) * (texture + 0.05f * noise);
      inputs.depth[inputs.at(x, y)] = 0.01f + 0.001f * std::sin(float(x + y));
      inputs.expected_depth[inputs.at(x, y)] = 0.1f / inputs.depth[inputs.at(x, y)];
    }
  return inputs;
}

/// Puts a value where it does not belong; an answer is a fault of the history.
using Fault = std::function<std::optional<HistoryFault>(ResolveInputs&, size_t pixel, float value)>;

/// Each far enough from the others for none to be near two.
uint32_t column_of(size_t fault) { return 14 + 26 * uint32_t(fault); }

std::string text_of(size_t fault) {
  return std::isfinite(faults[fault]) ? value_text(double(faults[fault])) : std::to_string(faults[fault]);
}

using Frames = std::vector<std::vector<std::vector<glm::vec3>>>; // by frame, by mode

Frames frames_of(StabilityBench& bench, std::span<const ModeRun> modes, const Fault* fault) {
  Frames frames;
  for (uint32_t frame = 0; frame <= frames_before + frames_after; ++frame) {
    throw_if_interrupted();
    ResolveInputs inputs = picture(frame);
    std::vector<HistoryFault> of_history;
    for (size_t i = 0; i < std::size(faults) && fault != nullptr && frame == frames_before; ++i)
      if (const auto one = (*fault)(inputs, inputs.at(column_of(i), height / 2), faults[i]))
        of_history.push_back(*one);
    auto results = bench.resolve.resolve(inputs, modes, frame == 0, of_history);
    if (frame >= frames_before) frames.push_back(std::move(results));
  }
  return frames;
}

FloatImage image_of(const std::vector<glm::vec3>& colours) {
  FloatImage image{.width = width, .height = height, .channels = 3, .values = {}};
  for (const glm::vec3& c : colours) image.values.insert(image.values.end(), {c.x, c.y, c.z});
  return image;
}

/// Of the fault that is nearest.
size_t fault_beside(size_t pixel) {
  size_t nearest = 0;
  const auto off = [&](size_t fault) { return std::abs(int(pixel % width) - int(column_of(fault))); };
  for (size_t fault = 1; fault < std::size(faults); ++fault)
    if (off(fault) < off(nearest)) nearest = fault;
  return nearest;
}

bool is_near(size_t pixel) {
  const int x = int(pixel % width) - int(column_of(fault_beside(pixel))),
            y = int(pixel / width) - int(height / 2);
  return std::abs(x) <= reach && std::abs(y) <= reach;
}

/// Of one frame after the faults, which is the first one itself.
void compare(Survival& survived, const std::vector<glm::vec3>& now, const std::vector<glm::vec3>& clean,
             size_t frame) {
  for (size_t i = 0; i < now.size(); ++i) {
    const bool finite = std::isfinite(now[i].x) && std::isfinite(now[i].y) && std::isfinite(now[i].z);
    if ((finite || frame == 0) && (now[i] == clean[i] || is_near(i))) continue;
    return worsen(survived, infinite,
                  text_of(fault_beside(i)) + ", " + std::to_string(frame) +
                      " frames later: " + (finite ? "changed at " : "not finite at ") +
                      std::to_string(i % width) + ", " + std::to_string(i / width));
  }
}

/// What is no number counts as nothing: at most it takes its own weight from a pixel, not the history's, too.
void compare_next(Survival& survived, const std::vector<glm::vec3>& next,
                  const std::vector<glm::vec3>& clean) {
  constexpr float most = 0.6f; // half of each frame is the largest weight that a mode has
  for (size_t fault = 0; fault < std::size(faults); ++fault) {
    const size_t pixel = size_t(height / 2) * width + column_of(fault);
    if (std::isfinite(faults[fault]) ||
        glm::distance(next[pixel], clean[pixel]) <= most * glm::length(clean[pixel]))
      continue;
    worsen(survived, infinite, text_of(fault) + " is still seen a frame later");
  }
}

/// Where two pictures differ most.
std::string worst_place(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  size_t worst = 0;
  for (size_t i = 1; i < a.size(); ++i)
    if (glm::distance(a[i], b[i]) > glm::distance(a[worst], b[worst])) worst = i;
  return a == b ? "nowhere" : "most of " + text_of(fault_beside(worst));
}

std::vector<Survival> survive(StabilityBench& bench, std::span<const ModeRun> modes, const Fault& fault) {
  std::vector<Survival> survived(modes.size());
  const Frames clean = frames_of(bench, modes, nullptr), hurt = frames_of(bench, modes, &fault);
  for (size_t mode = 0; mode < modes.size(); ++mode) {
    for (size_t frame = 0; frame < hurt.size(); ++frame)
      compare(survived[mode], hurt[frame][mode], clean[frame][mode], frame);
    compare_next(survived[mode], hurt[1][mode], clean[1][mode]);
    const double left = mean_flip(seen(displayed(image_of(clean.back()[mode]), 0)),
                                  seen(displayed(image_of(hurt.back()[mode]), 0)));
    worsen(survived[mode], left, worst_place(clean.back()[mode], hurt.back()[mode]));
  }
  return survived;
}

} // namespace

std::vector<Survival> survive_bad_colours(StabilityBench& bench, std::span<const ModeRun> modes) {
  return survive(bench, modes, [](ResolveInputs& inputs, size_t pixel, float value) {
    inputs.colours[pixel] = glm::vec3(value);
    return std::nullopt;
  });
}

std::vector<Survival> survive_bad_motion(StabilityBench& bench, std::span<const ModeRun> modes) {
  return survive(bench, modes, [](ResolveInputs& inputs, size_t pixel, float value) {
    inputs.motion[pixel] = glm::vec2(value);
    return std::nullopt;
  });
}

std::vector<Survival> survive_bad_depth(StabilityBench& bench, std::span<const ModeRun> modes) {
  return survive(bench, modes, [](ResolveInputs& inputs, size_t pixel, float value) {
    inputs.depth[pixel] = inputs.expected_depth[pixel] = value;
    return std::nullopt;
  });
}

std::vector<Survival> survive_bad_history(StabilityBench& bench, std::span<const ModeRun> modes) {
  return survive(bench, modes, [](ResolveInputs&, size_t pixel, float value) {
    return HistoryFault{.pixel = pixel, .value = value};
  });
}

} // namespace unghost
