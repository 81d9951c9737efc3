// How much of the frame goes into the average, which frame that is, and how sharply the history is read:
// against double precision, between the ends of each setting as at them.
#include <cmath>

#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Weights : public ResolveBenchTest {
protected:
  /// What `now` becomes after as many frames of `before` as histories count.
  std::vector<glm::vec3> after(const Inputs& before, const Inputs& now, const ModeRun& run) {
    for (int frame = 0; frame < 20; ++frame) bench.resolve(before, {run}, frame == 0);
    return bench.resolve(now, {run}, false)[0];
  }
};

Inputs filled_with(float colour) {
  Inputs inputs;
  inputs.colours.assign(inputs.colours.size(), glm::vec3(colour));
  return inputs;
}

/// unghost, of which no rejection, no bounds and no weighting of bright colours is left.
ModeRun by_speed() {
  ModeRun run = run_of("unghost");
  run.taa.policy.reject = Reject::nothing;
  run.taa.policy.rectify = Rectify::none;
  run.taa.policy.weighting = Weighting::none;
  return run;
}

double fast_share(const TaaSettings& taa, glm::dvec2 motion_px) {
  return std::min(1.0, glm::dot(motion_px, motion_px) / (double(taa.fast_px) * double(taa.fast_px)));
}

// A history of black and a frame of white: what comes out is the frame's weight.
TEST_F(Weights, SpeedAndZoomWeighTheFrame) {
  ModeRun run = by_speed();
  for (const auto& [alpha, fast_alpha, fast_px, zoom_weight] :
       {std::array{0.08f, 0.52f, 0.5f, 4.0f}, {0.2f, 0.7f, 2.0f, 0.0f}, {0.1f, 0.3f, 4.0f, 1.5f}}) {
    run.taa.alpha = alpha, run.taa.fast_alpha = fast_alpha, run.taa.fast_px = fast_px;
    run.taa.zoom_weight = zoom_weight;
    for (const glm::vec2 motion : {glm::vec2(0), {0.1f, 0}, {-0.2f, 0.15f}, {0.4f, 0.25f}, {1, -1}, {0, 3}})
      for (const double zoom : {0.0, 0.02, 0.1, 0.3, 0.9}) { // of which a key has steps of .02, up to .3
        Inputs now = filled_with(1);
        now.motion.assign(now.motion.size(), motion);
        now.expected_depth.assign(now.expected_depth.size(), float(10 * (1 + zoom)));
        const double expected =
            std::min(1.0, std::lerp(double(alpha), double(fast_alpha), fast_share(run.taa, motion)) +
                              double(zoom_weight) * std::min(zoom, 0.3));
        EXPECT_NEAR(after(filled_with(0), now, run)[now.at(8, 8)].x, expected, 1e-3)
            << fast_px << " " << motion.x << " " << motion.y << " " << zoom;
      }
  }
}

// What lies at x without jitter lies at x + jitter: of a ramp that is drawn so, the frame about the pixels'
// middles is the ramp where it is.
TEST_F(Weights, TheFrameAboutTheMiddleIsTheOneWithoutJitter) {
  ModeRun run = by_speed();
  run.taa.alpha = run.taa.fast_alpha = 1;
  const auto ramp = [](glm::dvec2 at) { return 4 + 0.3 * at.x - 0.17 * at.y; };
  for (const float rest : {0.0f, 0.3f, 1.0f})
    for (const float motion : {0.0f, 0.2f, 0.5f})
      for (const glm::vec2 jitter : {glm::vec2(0), {0.4f, 0}, {-0.25f, 0.35f}}) {
        run.taa.centred_rest = rest;
        Inputs now;
        now.jitter_px = jitter;
        now.motion.assign(now.motion.size(), {motion, 0});
        for (uint32_t i = 0; i < now.colours.size(); ++i)
          now.colours[i] = glm::vec3(ramp(glm::dvec2(i % 16, i / 16) - glm::dvec2(jitter)));
        const double share = std::lerp(double(rest), 1.0, fast_share(run.taa, {motion, 0})),
                     sampled = ramp(glm::dvec2(8, 8) - glm::dvec2(jitter)), middle = ramp({8, 8});
        EXPECT_NEAR(after(now, now, run)[now.at(8, 8)].x, std::lerp(sampled, middle, share), 6e-3)
            << rest << " " << motion << " " << jitter.x << " " << jitter.y;
      }
}

/// Keys 1981, (4), of which a is -c.
double keys(double far, double c) {
  far = std::abs(far);
  if (far < 1) return ((2 - c) * far - (3 - c)) * far * far + 1;
  return far < 2 ? c * (((5 - far) * far - 8) * far + 4) : 0;
}

TEST_F(Weights, ACubicIsAsSharpAsItIsSet) {
  ModeRun run = by_speed();
  run.taa.policy.history = HistoryFilter::catmull_rom_16;
  run.taa.policy.ringing = Ringing::kept;
  run.taa.policy.blend = Blend::constant;
  run.taa.alpha = 0;
  std::mt19937 random(5);
  Inputs before, now = filled_with(9);
  for (glm::vec3& colour : before.colours)
    colour = glm::vec3(half(glm::vec3(4 + any_number(random, false) / 64)));
  const glm::dvec2 motion(0.3, -0.4);
  now.motion.assign(now.motion.size(), glm::vec2(motion));
  for (const float c : {0.0f, 0.25f, 0.5f, 0.9f}) {
    run.taa.cubic = c;
    bench.resolve(before, {run}, true);
    const std::vector<glm::vec3> read = bench.resolve(now, {run}, false)[0];
    double sum = 0;
    for (int y = 5; y < 12; ++y)
      for (int x = 5; x < 12; ++x)
        sum += before.colours[before.at(uint32_t(x), uint32_t(y))].x * keys(x - 8 - motion.x, c) *
               keys(y - 8 - motion.y, c);
    EXPECT_NEAR(read[now.at(8, 8)].x, sum, 6e-3) << c;
  }
}

} // namespace
} // namespace unghost
