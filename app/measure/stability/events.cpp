// What a history cannot know: an object that jumps, appears or stops, a camera that turns round. On flat
// colours without jitter whatever a picture shows beside the frame itself is a ghost.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "app/interruption.h"
#include "app/measure/stability/block_world.h"
#include "app/measure/stability/matrix.h"

namespace unghost {
namespace {

constexpr uint32_t width = 96, height = 54, before_event = 6;

struct Event {
  const char* name;
  Instant (*at)(int frame); // the event is between -1 and 0
};

Instant jumps(int frame) { return block_instant({}, glm::dvec3(frame < 0 ? -1.2 : 1.2, 0, 0)); }
Instant appears(int frame) { return block_instant({}, glm::dvec3(0, frame < 0 ? -3 : 0, 0)); }
Instant stops(int frame) { return block_instant({}, glm::dvec3(0.15 * std::min(frame, 0), 0, 0)); }
Instant comes_from_behind(int frame) { return block_instant({}, glm::dvec3(0, 0, frame < 0 ? 9 : 0)); }
Instant turns_round(int frame) {
  Instant instant = block_instant({}, {});
  if (frame < 0) instant.camera = instant.camera * glm::angleAxis(3.14159, glm::dvec3(0, 1, 0));
  return instant;
}
constexpr Event events[] = {{"jumps", jumps},
                            {"appears", appears},
                            {"stops", stops},
                            {"comes from behind the camera", comes_from_behind},
                            {"the camera turns round", turns_round}};

glm::vec3 colour_at(const FloatImage& image, uint32_t x, uint32_t y) {
  const float* c = &image.values[(size_t(y) * image.width + x) * 3];
  return {c[0], c[1], c[2]};
}

/// Pixels beside which nothing else is, and that show another colour than the frame has there.
size_t ghosts_in(const FloatImage& resolved, const FloatImage& aliased) {
  size_t count = 0;
  for (uint32_t y = 1; y + 1 < aliased.height; ++y)
    for (uint32_t x = 1; x + 1 < aliased.width; ++x) {
      const glm::vec3 here = colour_at(aliased, x, y);
      bool flat = true;
      for (uint32_t dy = 0; dy < 3; ++dy)
        for (uint32_t dx = 0; dx < 3; ++dx)
          flat = flat && glm::distance(colour_at(aliased, x + dx - 1, y + dy - 1), here) < 1e-3f;
      count += flat && !(glm::distance(colour_at(resolved, x, y), here) < 0.005f); // also what is no number
    }
  return count;
}

} // namespace

std::vector<Survival> survive_events(StabilityBench& bench, std::span<const ModeRun> modes) {
  std::vector<ModeRun> runs(modes.begin(), modes.end());
  for (ModeRun& run : runs) run.taa.policy.jitter = Jitter::none;
  runs.push_back({.name = "off", .taa = {}});
  std::vector<Survival> survived(modes.size());
  for (const Event& event : events) {
    std::vector<uint32_t> frames_with_ghosts(modes.size());
    for (int frame = -int(before_event); frame < int(frames_after_event); ++frame) {
      throw_if_interrupted();
      FrameInput input{.now = event.at(frame), .before = event.at(frame - 1)};
      input.index = uint64_t(frame + int(before_event)), input.cut = input.index == 0;
      input.width = width, input.height = height, input.modes = runs;
      for (size_t mode = 0; mode < runs.size() && frame >= 0; ++mode)
        input.wanted.push_back({Output::resolved, mode});
      const FrameResult result = bench.blocks.render(input);
      for (size_t mode = 0; mode < modes.size() && frame >= 0; ++mode)
        if (wrong_values(result.delivered[mode].image) > 0) worsen(survived[mode], INFINITY, event.name);
      for (size_t mode = 0; mode < modes.size() && frame >= 0; ++mode)
        frames_with_ghosts[mode] +=
            ghosts_in(result.delivered[mode].image, result.delivered.back().image) > 0;
    }
    for (size_t mode = 0; mode < modes.size(); ++mode)
      worsen(survived[mode], frames_with_ghosts[mode], event.name);
  }
  return survived;
}

} // namespace unghost
