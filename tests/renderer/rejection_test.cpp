// What each cause of rejection and each blend makes of a pixel, against numbers worked out by hand.
#include <cmath>
#include <functional>

#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

constexpr float was = 9, is = 1, kept = 0.9f * was + 0.1f * is; // by an average of a tenth
constexpr float unknown = 1e9f, not_a_number = std::numeric_limits<float>::quiet_NaN();

/// An average and nothing else, of the pixel's own history.
ModeRun averaging(Reject reject) {
  ModeRun run = run_of("blend");
  run.taa.policy.reject = reject, run.taa.policy.history = HistoryFilter::nearest;
  run.taa.near_m = 5, run.taa.far_m = 10;
  return run;
}

class Causes : public ResolveBenchTest {
protected:
  /// A pixel in the middle of a picture that was `was` and is `is`, by both resolvers.
  float middle_of(ModeRun run, const Inputs& before, const Inputs& now) {
    std::vector<ModeRun> runs = {run, run};
    runs[1].taa.resolver = Resolver::naive;
    bench.resolve(before, runs, true);
    const auto results = bench.resolve(now, runs, false);
    const size_t middle = size_t(now.width) * (now.height / 2) + now.width / 2;
    EXPECT_EQ(results[0][middle], results[1][middle]);
    return results[0][middle].x;
  }
  /// The same where the pictures differ in one thing.
  float middle_of(Reject reject, const std::function<void(Inputs& before, Inputs& now)>& change) {
    Inputs before, now;
    before.colours.assign(before.colours.size(), glm::vec3(was));
    now.colours.assign(now.colours.size(), glm::vec3(is));
    change(before, now);
    return middle_of(averaging(reject), before, now);
  }
};

void moves(Inputs& inputs, float x) { inputs.motion.assign(inputs.motion.size(), {x, 0}); }
void lies_at(Inputs& inputs, float metres) { inputs.depth.assign(inputs.depth.size(), 0.1f / metres); }

TEST_F(Causes, NearAndMovingFadesBetweenItsThresholds) {
  const auto at = [&](float metres, float px, uint8_t tag) {
    return middle_of(Reject::near_moving, [=](Inputs& before, Inputs& now) {
      moves(now, px), lies_at(now, metres);
      now.tags.assign(now.tags.size(), tag), before.tags = now.tags;
    });
  };
  EXPECT_NEAR(at(4, 2, 0), is, 0.02) << "nearer than near";
  EXPECT_NEAR(at(7.5f, 2, 0), (1 - 0.55f) * was + 0.55f * is, 0.03) << "half-way";
  EXPECT_NEAR(at(11, 2, 0), kept, 0.02) << "beyond far";
  EXPECT_NEAR(at(4, 0.5f, 0), kept, 0.02) << "not moving";
  EXPECT_NEAR(at(4, 2, 1), kept, 0.02) << "tagged";
}

TEST_F(Causes, MotionThatDiffersFromLastFrames) {
  const auto with = [&](Reject reject, float before_px, float now_px) {
    return middle_of(reject,
                     [=](Inputs& before, Inputs& now) { moves(before, before_px), moves(now, now_px); });
  };
  const float drawn = (1 / 16.0f - 0.001f) * 10; // one pixel of sixteen
  EXPECT_NEAR(with(Reject::velocity, 1, 2), (1 - drawn) * kept + drawn * is, 0.03);
  EXPECT_NEAR(with(Reject::velocity, 2, 2), kept, 0.02);
  EXPECT_NEAR(with(Reject::velocity, -2, 2), is, 0.02) << "the other way";
  EXPECT_NEAR(with(Reject::motion_length, 0, 4), is, 0.02);
  EXPECT_NEAR(with(Reject::motion_length, -2, 2), kept, 0.02) << "as long, the other way";
  EXPECT_NEAR(with(Reject::speed, 1, 1), kept, 0.02);
  EXPECT_NEAR(with(Reject::speed, 1, 3), is, 0.02);
  EXPECT_NEAR(with(Reject::speed, 3, 1), is, 0.02) << "it was fast";
}

TEST_F(Causes, DepthThatWasNotThere) {
  const auto with = [&](float was_at, float expected, float is_at) {
    return middle_of(Reject::depth, [=](Inputs& before, Inputs& now) {
      lies_at(before, was_at), lies_at(now, is_at);
      now.expected_depth.assign(now.expected_depth.size(), expected);
    });
  };
  constexpr float sky = std::numeric_limits<float>::infinity();
  EXPECT_NEAR(with(10, 10, 10), kept, 0.02);
  EXPECT_NEAR(with(10, 10.5f, 10.5f), kept, 0.02) << "within a tenth";
  EXPECT_NEAR(with(5, 10, 10), is, 0.02) << "something nearer hid it";
  EXPECT_NEAR(with(sky, sky, sky), kept, 0.02);
  EXPECT_NEAR(with(5, sky, sky), is, 0.02) << "sky that something hid";
  EXPECT_NEAR(with(sky, 5, 5), is, 0.02);
}

// With dilation depths are those of who speaks, now as last frame: a silhouette at rest is not rejected.
TEST_F(Causes, DepthOfASilhouetteAtRestIsAsExpected) {
  Inputs picture;
  picture.colours.assign(picture.colours.size(), glm::vec3(was));
  for (size_t i = 0; i < picture.depth.size(); ++i) {
    const bool near = i % picture.width < picture.width / 2;
    picture.depth[i] = near ? 0.1f / 2 : 0.1f / 50, picture.expected_depth[i] = near ? 2.0f : 50.0f;
  }
  Inputs next = picture;
  next.colours.assign(next.colours.size(), glm::vec3(is));
  ModeRun run = averaging(Reject::depth);
  run.taa.policy.dilation = Dilation::closest_depth;
  EXPECT_NEAR(middle_of(run, picture, next), kept, 0.02) << "just beside it";
}

TEST_F(Causes, AnotherObjectOrTagIsNoHistory) {
  EXPECT_NEAR(
      middle_of(Reject::object, [](Inputs&, Inputs& now) { now.objects.assign(now.objects.size(), 2); }), is,
      0.02);
  EXPECT_NEAR(middle_of(Reject::object, [](Inputs&, Inputs&) {}), kept, 0.02);
  EXPECT_NEAR(middle_of(Reject::tag, [](Inputs&, Inputs& now) { now.tags.assign(now.tags.size(), 200); }), is,
              0.02);
  EXPECT_NEAR(middle_of(Reject::tag,
                        [](Inputs& before, Inputs& now) {
                          before.tags.assign(before.tags.size(), 200), now.tags = before.tags;
                        }),
              kept, 0.02);
}

// The tags of the first frame are those of who speaks, as all later ones are.
TEST_F(Causes, ASilhouetteOfTagsAtRestIsKeptFromTheFirstFrameOn) {
  Inputs picture;
  picture.colours.assign(picture.colours.size(), glm::vec3(was));
  for (size_t i = 0; i < picture.depth.size(); ++i)
    if (i % picture.width < picture.width / 2) picture.depth[i] = 0.05f, picture.tags[i] = 1;
  Inputs next = picture;
  next.colours.assign(next.colours.size(), glm::vec3(is));
  ModeRun run = averaging(Reject::tag);
  run.taa.policy.dilation = Dilation::closest_depth;
  EXPECT_NEAR(middle_of(run, picture, next), kept, 0.02) << "just beside it";
}

TEST_F(Causes, WhereNothingWasThereIsNoHistory) {
  const auto with = [&](Reject reject, float px) {
    return middle_of(reject, [=](Inputs&, Inputs& now) { moves(now, px); });
  };
  EXPECT_NEAR(with(Reject::off_screen, 100), is, 0.02);
  EXPECT_NEAR(with(Reject::nothing, 100), kept, 0.02) << "the edge goes on";
  EXPECT_NEAR(with(Reject::nothing, unknown), is, 0.02);
  EXPECT_NEAR(with(Reject::nothing, not_a_number), is, 0.02);
}

TEST_F(Causes, ACountingAverageWeighsAllFramesAlike) {
  ModeRun run = averaging(Reject::off_screen);
  run.taa.policy.blend = Blend::counting, run.taa.alpha = 0.01f;
  double sum = 0;
  for (int n = 0; n < 8; ++n) {
    Inputs inputs;
    inputs.colours.assign(inputs.colours.size(), glm::vec3(float(n % 3)));
    sum += n % 3;
    EXPECT_NEAR(bench.resolve(inputs, {run}, n == 0)[0][40].x, sum / (n + 1), 2e-3) << n;
  }
}

TEST_F(Causes, AnAttenuatedAverageTrustsWhatWasRectified) {
  Inputs before, now;
  before.colours.assign(before.colours.size(), glm::vec3(was));
  for (size_t i = 0; i < now.colours.size(); ++i) now.colours[i] = glm::vec3(i % 2 == 0 ? 1.0f : 3.0f);
  ModeRun run = averaging(Reject::off_screen);
  run.taa.policy.rectify = Rectify::box_clamp, run.taa.policy.blend = Blend::attenuated;
  const size_t middle = 8 * 16 + 8; // which is 1
  const float weight = 0.1f * (1 - 0.75f);
  EXPECT_NEAR(middle_of(run, before, now), (1 - weight) * 3 + weight * now.colours[middle].x, 0.02);
}

TEST_F(Causes, AnAverageOfLogarithmsIsAGeometricMean) {
  ModeRun run = averaging(Reject::off_screen);
  run.taa.policy.weighting = Weighting::log;
  Inputs before, now;
  before.colours.assign(before.colours.size(), glm::vec3(was));
  now.colours.assign(now.colours.size(), glm::vec3(is));
  EXPECT_NEAR(middle_of(run, before, now), std::pow(was, 0.9) * std::pow(is, 0.1), 0.02);
}

// Of the input, not of the result: nothing is older than one frame.
TEST_F(Causes, TwoFramesAreHalfOfEach) {
  for (const char* mode : {"crytek-2x", "ac4"})
    for (int n = 0; n < 4; ++n) {
      Inputs inputs;
      inputs.colours.assign(inputs.colours.size(), glm::vec3(float(n * n)));
      const double expected = n == 0 ? 0 : (n * n + (n - 1) * (n - 1)) / 2.0;
      EXPECT_NEAR(bench.resolve(inputs, {run_of(mode)}, n == 0)[0][40].x, expected, 1e-2) << mode << n;
    }
}

// What the articles do where tags differ: the picture, blurred, and nothing of the history.
TEST_F(Causes, WhereTagsDifferTheHistoryIsGone) {
  Inputs before(16, 16), now(16, 16);
  std::mt19937 random(10);
  for (glm::vec3& colour : before.colours) colour = glm::vec3(9, 0, 9);
  for (glm::vec3& colour : now.colours) colour = half(glm::vec3(any_number(random, false)));
  now.tags[16 * 8 + 8] = 1;
  ModeRun run = run_of("uncharted");
  run.taa.policy.dilation = Dilation::centre;
  run.taa.policy.rectify = Rectify::none;
  bench.resolve(before, {run}, true);
  const auto result = bench.resolve(now, {run}, false)[0];
  double blurred = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      blurred += now.colours[size_t(16 * (8 + y) + 8 + x)].x * (2 - std::abs(x)) * (2 - std::abs(y)) / 16.0;
  EXPECT_NEAR(result[16 * 8 + 8].x, blurred, 1e-3 * blurred);
  EXPECT_NEAR(result[16 * 8 + 8].y, blurred, 1e-3 * blurred);
  EXPECT_NEAR(result[16 * 4 + 4].x, 0.9 * 9 + 0.1 * now.colours[16 * 4 + 4].x, 0.02);
}

// Nine taps through a sampler, as GPUs read it, are the sixteen loads but for the sampler's eight bits of a
// weight.
TEST_F(Causes, HistoriesByTapsAreThoseByLoads) {
  Inputs before, now;
  std::mt19937 random(3);
  for (glm::vec3& colour : before.colours)
    colour = half({1 + any_number(random, false) / 64, 1 + any_number(random, false) / 64, 1});
  moves(now, 0.3f);
  for (glm::vec2& motion : now.motion) motion.y = -0.6f;
  const auto read = [&](HistoryFilter filter, Ringing ringing) {
    ModeRun run = averaging(Reject::nothing);
    run.taa.policy.history = filter, run.taa.policy.ringing = ringing, run.taa.alpha = 0;
    bench.resolve(before, {run}, true);
    return bench.resolve(now, {run}, false)[0];
  };
  const auto loads = read(HistoryFilter::catmull_rom_16, Ringing::kept);
  const auto taps = read(HistoryFilter::catmull_rom_9, Ringing::kept);
  const auto clamped = read(HistoryFilter::catmull_rom_16, Ringing::clamped);
  const auto clamped_taps = read(HistoryFilter::catmull_rom_9, Ringing::clamped);
  const auto few = read(HistoryFilter::catmull_rom_5, Ringing::kept);
  double corners = 0;
  size_t rang = 0;
  for (int y = 2; y < 14; ++y)
    for (int x = 2; x < 14; ++x) {
      const size_t i = size_t(16 * y + x);
      EXPECT_NEAR(loads[i].x, taps[i].x, 0.02 * loads[i].x) << i;
      EXPECT_NEAR(clamped[i].x, clamped_taps[i].x, 0.02 * clamped[i].x) << i;
      corners += std::abs(few[i].x - loads[i].x) / loads[i].x / 144;
      float low = 1e30f, high = 0;
      for (const size_t texel : {i - 16, i - 15, i, i + 1}) // at +.3, -.6
        low = std::min(low, before.colours[texel].x), high = std::max(high, before.colours[texel].x);
      EXPECT_TRUE(clamped[i].x >= low * 0.998f && clamped[i].x <= high * 1.002f) << i;
      rang += loads[i].x < low || loads[i].x > high;
    }
  EXPECT_LT(corners, 0.05) << "the corners weigh little";
  EXPECT_GT(rang, 5u) << "and unclamped, it rings";
}

} // namespace
} // namespace unghost
