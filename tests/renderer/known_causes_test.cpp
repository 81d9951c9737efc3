// Histories that are given up, or lit anew, for causes that the renderer knows.
#include "shaders/shared/taa_key.h"
#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

constexpr float albedo = 0.4f;

class KnownCauses : public ResolveBenchTest {
protected:
  /// Of a pixel in the middle: what the last of these frames becomes.
  float last_of(const std::vector<Inputs>& frames, const ModeRun& run) {
    std::vector<glm::vec3> result;
    for (size_t i = 0; i < frames.size(); ++i) result = bench.resolve(frames[i], {run}, i == 0).front();
    return result[frames.back().at(8, 8)].x;
  }
};

ModeRun without(Reject test) {
  ModeRun run = run_of("unghost");
  run.taa.policy.reject = Reject(uint32_t(run.taa.policy.reject) & ~uint32_t(test));
  return run;
}

Inputs lit(float light) {
  Inputs inputs;
  inputs.colours.assign(inputs.colours.size(), glm::vec3(albedo * light));
  inputs.light.assign(inputs.light.size(), light);
  return inputs;
}

/// As the G-buffer writes it.
uint32_t object(uint32_t node, uint32_t id) { return node | id << OBJECT_ID_SHIFT; }

Inputs covered_by(uint32_t word, float colour) {
  Inputs inputs;
  inputs.colours.assign(inputs.colours.size(), glm::vec3(colour));
  inputs.objects.assign(inputs.objects.size(), word);
  inputs.motion.assign(inputs.motion.size(), {2, 0}); // the picture moves
  return inputs;
}

TEST_F(KnownCauses, AHistoryIsLitAnewWhereAShadowFallsOrGoes) {
  for (const auto& [before, after] : {std::pair{1.0f, 0.3f}, {0.3f, 1.0f}, {1.0f, 2.5f}}) {
    std::vector<Inputs> frames(20, lit(before));
    frames.push_back(lit(after));
    const float ghost = albedo * (before - after);
    const float left = last_of(frames, run_of("unghost")) - albedo * after;
    EXPECT_LT(std::abs(left / ghost), 0.03) << before << " to " << after; // of what steps of light leave
    const float kept = last_of(frames, without(Reject::visibility)) - albedo * after;
    EXPECT_GT(kept / ghost, 0.8) << "the ghost is there without the test";
  }
}

TEST_F(KnownCauses, WhatAnotherObjectLeftIsGivenUp) {
  std::vector<Inputs> frames(20, covered_by(object(7, 1), 0.9f));
  frames.push_back(covered_by(object(8, 20), 0.1f));
  EXPECT_NEAR(last_of(frames, run_of("unghost")), 0.1f, 1e-3);
  EXPECT_GT(last_of(frames, without(Reject::moved_object)), 0.3f) << "the ghost is there without the test";
}

/// From an object on the left to one on the right, which then is all there is; a pixel of it comes from where
/// `share` of the history was the other's.
std::vector<Inputs> beside_another(float share, uint32_t moved_ids) {
  constexpr uint32_t left = 1, right = 2;
  constexpr float bright = 40, dark = 0.1f;
  Inputs both = covered_by(object(8, right), dark), one = both;
  both.motion.assign(both.motion.size(), {0, 0});
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x <= 6; ++x) {
      both.objects[both.at(x, y)] = object(7, left);
      both.colours[both.at(x, y)] = glm::vec3(bright);
    }
  one.motion.assign(one.motion.size(), {-1 - share, 0});
  one.moved_ids = moved_ids;
  std::vector<Inputs> frames(20, both);
  frames.push_back(one);
  return frames;
}

TEST_F(KnownCauses, OfTwoThatRestMostOfAHistoryHasToBeTheOthers) {
  const ModeRun unghost = run_of("unghost");
  EXPECT_GT(last_of(beside_another(0.3f, 0), unghost), 0.5f) << "kept";
  EXPECT_NEAR(last_of(beside_another(0.7f, 0), unghost), 0.1f, 1e-3);
}

TEST_F(KnownCauses, OfWhatMovesNoLeakIsTooSmallToBeGivenUp) {
  const ModeRun unghost = run_of("unghost");
  EXPECT_GT(last_of(beside_another(1.0f / 64, 0), unghost), 0.11f) << "both rest";
  for (const uint32_t mover : {1u, 2u})
    EXPECT_NEAR(last_of(beside_another(1.0f / 64, 1u << mover), unghost), 0.1f, 1e-3) << mover;
  EXPECT_GT(last_of(beside_another(1.0f / 512, 1u << 1), unghost), 0.101f) << "what floats leave is none";
}

TEST_F(KnownCauses, IdsThatCollideCostTheRejection) {
  std::vector<Inputs> frames(20, covered_by(object(7, 20), 0.9f));
  frames.push_back(covered_by(object(8, 20), 0.1f));
  const ModeRun without_test = without(Reject::moved_object);
  EXPECT_EQ(last_of(frames, run_of("unghost")), last_of(frames, without_test));
}

} // namespace
} // namespace unghost
