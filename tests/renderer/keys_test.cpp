// Keys, and what stays of them with a history: nothing is lost that fits, and no field spills into another.
#include "shaders/shared/taa_key.h"

#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "renderer/passes/gpu_scene.h"
#include "tests/renderer/lamp_scene.h"
#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

double light_of(float lightness) {
  const glm::vec2 fraction = light_fraction(lightness);
  return double(fraction.x) / double(fraction.y);
}

TEST(Lightness, IsLightsInverseAndRisesWithItWithoutAJump) {
  float before = lightness_of(0.99e-3f);
  for (double light = 1e-3; light <= 20; light *= 1.003) {
    const float lightness = lightness_of(float(light));
    EXPECT_NEAR(light_of(lightness) / light, 1, 1e-4) << light;
    EXPECT_GT(lightness, before) << light;
    EXPECT_LT(lightness - before, 0.002) << light; // .4 of .3%, where it is steepest
    before = lightness;
  }
  EXPECT_EQ(lightness_of(0), 0);
  EXPECT_LE(lightness_of(1e30f), 1);
  EXPECT_TRUE(std::isfinite(light_of(1)));
}

TEST(Lightness, StepsOfItStayWhatTheyAre) {
  for (uint32_t step = 0; step < KEY_LIGHT_STEPS; ++step) // the last is of whatever is brighter
    for (const bool changes : {false, true})
      EXPECT_EQ(light_word(float(light_of(float(step) / KEY_LIGHT_STEPS)), changes),
                step | (changes ? LIGHT_CHANGES : 0));
  for (const float bright : {60.0f, 1e6f, 1e30f}) EXPECT_EQ(light_word(bright, false), KEY_LIGHT_STEPS);
}

/// The bits of a key from `low` up to `high`, without that.
uint32_t field(uint32_t key, uint32_t low, uint32_t high) {
  return uint32_t((uint64_t(key) & ((uint64_t(1) << high) - 1)) >> low);
}

TEST(Keys, HoldEachFieldWhateverTheOthersAre) {
  for (const float depth : {0.0f, 1e-6f, 0.0123f, 0.5f, 0.99f, 1.0f})
    for (uint32_t id = 0; id <= OBJECT_IDS; ++id)
      for (const uint32_t glossy : {0u, OBJECT_GLOSSY})
        for (const uint32_t light : {0u, 1u, 64u, KEY_LIGHT_STEPS, LIGHT_CHANGES, LIGHT_CHANGES | 127u})
          for (uint32_t nearer = 0; nearer <= KEY_ZOOM_STEPS; ++nearer) {
            const uint32_t object = OBJECT_NODE | glossy | id << OBJECT_ID_SHIFT;
            const uint32_t key = key_of(depth, object, light, float(nearer) * KEY_ZOOM_STEP);
            const uint32_t rank = field(key, KEY_DEPTH_SHIFT, 32);
            const float kept = std::bit_cast<float>(rank << KEY_DEPTH_IN_FLOAT);
            ASSERT_LE(kept, depth);
            ASSERT_LE(depth - kept, depth / 64);
            ASSERT_EQ(field(key, KEY_ID_SHIFT, KEY_DEPTH_SHIFT), id);
            ASSERT_EQ(key & KEY_GLOSSY, glossy >> OBJECT_KEYED_SHIFT << KEY_OBJECT_SHIFT);
            ASSERT_EQ(field(key, KEY_LIGHT_SHIFT, KEY_OBJECT_SHIFT), light);
            ASSERT_EQ(field(key, 0, KEY_LIGHT_SHIFT), nearer);
          }
}

TEST(Keys, NearerIsGreaterAndZoomEndsWhereItsStepsDo) {
  uint32_t before = 0;
  for (float depth = 1e-6f; depth <= 1; depth *= 1.02f) {
    const uint32_t rank = key_of(depth, 0, 0, 0) >> KEY_DEPTH_SHIFT;
    EXPECT_GT(rank, before) << depth;
    before = rank;
  }
  constexpr float infinite = std::numeric_limits<float>::infinity();
  for (const float none : {0.0f, -0.5f, -infinite, NAN, 0.009f}) EXPECT_EQ(key_of(0, 0, 0, none), 0u) << none;
  for (const float most : {0.3f, 1.0f, infinite}) EXPECT_EQ(key_of(0, 0, 0, most), KEY_ZOOM_STEPS) << most;
}

class ObjectIds : public StudioTest {};

/// 20 boxes that slide, one of which carries another, and as many that rest, in turns.
Scene many_boxes() {
  Scene scene = plate_of({});
  for (int i = 0; i < 20; ++i) {
    const glm::vec3 at(float(i) - 10, 1, 0);
    slide(scene, add_box(scene, 0.3f, at), at, at + glm::vec3(0, 0, 1));
    add_box(scene, 0.3f, at + glm::vec3(0, 0, 3));
  }
  scene.nodes[add_box(scene, 0.2f, {0, 1, 0})].parent = 1;
  return scene;
}

TEST_F(ObjectIds, OfWhatMovesAreNoneOfWhatRests) {
  const Scene scene = many_boxes();
  const GpuScene gpu(studio->device, scene);
  std::vector<uint32_t> moving, resting;
  ASSERT_EQ(gpu.object_words.size(), scene.nodes.size());
  for (size_t i = 0; i < gpu.object_words.size(); ++i) {
    const uint32_t word = gpu.object_words[i], id = word >> OBJECT_ID_SHIFT;
    EXPECT_EQ(word & OBJECT_NODE, uint32_t(gpu.object_nodes[i] + 1));
    const bool moves = gpu.object_nodes[i] % 2 == 1;
    (moves ? moving : resting).push_back(id);
    EXPECT_GE(id, moves ? RESTING_IDS + 1 : 1) << i;
    EXPECT_LE(id, moves ? OBJECT_IDS : RESTING_IDS) << i;
  }
  ASSERT_EQ(moving.size(), 21u);
  EXPECT_EQ(moving.back(), moving.front()) << "carried";
  // as many as there are, before the first comes again
  const uint32_t moving_ids = OBJECT_IDS - RESTING_IDS;
  EXPECT_EQ(std::set(moving.begin(), moving.begin() + moving_ids).size(), moving_ids);
  EXPECT_EQ(std::set(resting.begin(), resting.begin() + RESTING_IDS).size(), RESTING_IDS);
}

/// What stays with a history, in half a float.
class KeptWithHistories : public ResolveBenchTest {
protected:
  /// All of the history as long as a mode that counts knows that it is old, and nothing else that is mixed.
  static ModeRun counting() {
    ModeRun run = run_of("unghost");
    run.taa.policy.rectify = Rectify::none;
    run.taa.policy.weighting = Weighting::none;
    run.taa.alpha = run.taa.fast_alpha = 0;
    return run;
  }
  static Inputs covered(uint32_t id, float colour, float light, uint32_t moved_ids = 0) {
    Inputs inputs;
    inputs.colours.assign(inputs.colours.size(), glm::vec3(colour));
    inputs.objects.assign(inputs.objects.size(), 1 | id << OBJECT_ID_SHIFT);
    inputs.light.assign(inputs.light.size(), light);
    inputs.moved_ids = moved_ids;
    return inputs;
  }
  /// Of a pixel in the middle: what the last becomes, after as many frames of `before`.
  float after(int frames, const Inputs& before, const Inputs& last) {
    for (int frame = 0; frame < frames; ++frame) bench.resolve(before, {counting()}, frame == 0);
    return bench.resolve(last, {counting()}, false)[0][last.at(8, 8)].x;
  }
};

constexpr uint32_t ends_of_ids[] = {0, 14, 15, OBJECT_IDS}; // of each half of the numbers
constexpr float brightest = 1000;                           // the last step

TEST_F(KeptWithHistories, TheAgeIsKnown) {
  for (const uint32_t id : ends_of_ids)
    for (const float light : {0.0f, 1.0f, brightest})
      for (const int frames : {1, 2, 8, 15, 16, 20}) {
        const float weight = frames < int(KEPT_AGES) ? 1.0f / float(frames + 1) : 0;
        EXPECT_NEAR(after(frames, covered(id, 0, light), covered(id, 1, light)), weight, 1e-3)
            << id << " " << light << " " << frames;
      }
}

TEST_F(KeptWithHistories, TheIdIsKnown) {
  for (const uint32_t id : ends_of_ids)
    for (const float light : {0.0f, brightest})
      for (const int frames : {1, 16}) {
        const uint32_t other = id == 7 ? 8 : 7, own = 1u << id, all = (1u << (OBJECT_IDS + 1)) - 1;
        const Inputs before = covered(id, 0, light);
        EXPECT_EQ(after(frames, before, covered(other, 1, light, own)), 1) << id << " moved away";
        EXPECT_LT(after(frames, before, covered(other, 1, light, all & ~own & ~(1u << other))), 0.6f)
            << id << " rests, and whatever else moved";
      }
}

// From one step to the one below, at either end of the steps and where their curve changes: the history is
// lit anew by just that much, and counts as fewer frames by as much.
TEST_F(KeptWithHistories, TheLightIsKnownToAStep) {
  for (const uint32_t id : ends_of_ids)
    for (const uint32_t step : {20u, 101u, 102u, 110u, KEY_LIGHT_STEPS - 1}) {
      const double was = light_of(float(step + 1) / KEY_LIGHT_STEPS),
                   is = light_of(float(step) / KEY_LIGHT_STEPS), change = is / was;
      const double weight = 1 / (KEPT_AGES * change + 1);
      EXPECT_NEAR(after(20, covered(id, 1, float(was)), covered(id, 0, float(is))), change * (1 - weight),
                  2e-3)
          << id << " " << step;
    }
}

} // namespace
} // namespace unghost
