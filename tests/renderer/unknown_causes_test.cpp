// What no key tells of: a lamp that the light channel does not know, and a sprite that has no id. What
// unghost-safe leaves of such a ghost is no more than what a clip alone does.
#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

constexpr uint32_t side = 48;
constexpr int fill = 16, frames = 24; // all, and those that count come after the fill

/// Noisy ground that rests.
Inputs ground() {
  Inputs inputs(side, side);
  std::mt19937 random(3);
  for (glm::vec3& colour : inputs.colours) {
    const float grey = 0.2f + 0.15f * float(random() % 1000) / 1000;
    colour = glm::vec3(grey, 0.97f * grey, 0.9f * grey);
  }
  return inputs;
}

/// Frame by frame.
using Film = std::vector<Inputs>;

/// A bright square crosses the picture, three pixels a frame.
Film sprite() {
  Film film(frames, ground());
  for (int frame = 0; frame < frames; ++frame)
    for (int y = 16; y < 28; ++y)
      for (int x = 0; x < 12; ++x) {
        const int at = x + 3 * (frame - fill);
        if (at >= 0 && at < int(side))
          film[size_t(frame)].colours[size_t(y) * side + size_t(at)] = {1.2f, 1, 0.6f};
      }
  return film;
}

/// A lamp shines on a disc while the histories fill, and then it does not.
Film lamp(float times) {
  Film film(frames, ground());
  for (int frame = 0; frame < fill; ++frame)
    for (int i = 0; i < int(side * side); ++i) {
      const glm::vec2 off(i % int(side) - 24, i / int(side) - 24);
      film[size_t(frame)].colours[size_t(i)] *= 1 + (times - 1) * std::exp(-glm::dot(off, off) / 150);
    }
  return film;
}

class UnknownCauses : public ResolveBenchTest {
protected:
  /// The share of the ghost that stays, of what an average that gives up nothing leaves: trail's, over the
  /// frames after the fill.
  double trail(const Film& film, const ModeRun& run) {
    ModeRun none = run_of("blend");
    none.taa.policy.jitter = run.taa.policy.jitter;
    double left = 0, whole = 0;
    for (size_t frame = 0; frame < film.size(); ++frame) {
      const auto results = bench.resolve(film[frame], {run, none}, frame == 0);
      for (size_t i = 0; frame >= size_t(fill) && i < film[frame].colours.size(); ++i) {
        const glm::dvec3 now(film[frame].colours[i]), ghost = glm::dvec3(results[1][i]) - now;
        left += std::max(0.0, glm::dot(glm::dvec3(results[0][i]) - now, ghost)),
            whole += glm::dot(ghost, ghost);
      }
    }
    return left / whole;
  }
  /// By how much more than a clip alone the safe row leaves.
  double over_a_clip(const Film& film) {
    return trail(film, run_of("unghost-safe")) / trail(film, run_of("rgb"));
  }
};

TEST_F(UnknownCauses, ASpriteWithoutAnIdLeavesNoMoreThanAClipDoes) {
  EXPECT_LT(over_a_clip(sprite()), 1.1);
  EXPECT_GT(trail(sprite(), run_of("unghost")), 0.5) << "which is not so where nothing bounds it";
}

TEST_F(UnknownCauses, ALampThatNoChannelKnowsLeavesNoMoreThanAClipDoes) {
  for (const float times : {3.0f, 0.3f}) EXPECT_LT(over_a_clip(lamp(times)), 1.1) << times;
}

} // namespace
} // namespace unghost
