// Motion vectors against double precision on the CPU.
#include <cmath>
#include <map>

#include "renderer/pose.h"
#include "renderer/view.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Motion : public StudioTest {};

/// Where the surface that pixel (x, y) shows was last frame, minus where it is: from depth and object alone.
class Oracle {
public:
  Oracle(const Scene& scene, const FrameInput& input, glm::dvec2 jitter)
      : input_(input), jitter_(jitter), now_(pose(scene, input.now)), before_(pose(scene, input.before)) {}

  Projected before(uint32_t x, uint32_t y, double depth, uint32_t object) const {
    const glm::dvec3 world = position_world(x, y, depth);
    const glm::dmat4 moved = before_[object - 1] * glm::inverse(now_[object - 1]);
    return project(input_.before, moved * glm::dvec4(world, 1), input_.width, input_.height);
  }
  glm::dvec2 pixel(uint32_t x, uint32_t y) const { return glm::dvec2(x, y) + 0.5 - jitter_; }

private:
  glm::dvec3 position_world(uint32_t x, uint32_t y, double depth) const {
    const double down = std::tan(input_.now.vertical_fov / 2);
    const glm::dvec2 size(input_.width, input_.height);
    const glm::dvec2 ndc = pixel(x, y) / size * 2.0 - 1.0;
    const glm::dvec3 view(ndc.x * down * size.x / size.y * depth, -ndc.y * down * depth, -depth);
    return input_.now.eye + input_.now.camera * view;
  }

  const FrameInput& input_;
  glm::dvec2 jitter_;
  std::vector<glm::dmat4> now_, before_;
};

struct Deviation {
  double motion_px = 0, depth = 0; // the latter relative
  size_t moving_objects = 0, surfaces = 0;
};

Deviation deviation(Studio& studio, FrameInput input) {
  input.wanted = {{Output::motion}, {Output::depth}, {Output::object}, {Output::previous_depth}};
  const FrameResult result = studio.renderer.render(input);
  const auto& motion = result.delivered[0].image.values;
  const auto& depth = result.delivered[1].image.values;
  const auto& object = result.delivered[2].image.values;
  const auto& previous_depth = result.delivered[3].image.values;
  const TaaSettings& taa = input.modes[0].taa;
  const glm::dvec2 jitter = jitter_offset(taa.policy.jitter, input.index) * double(taa.jitter_scale);
  const Oracle oracle(studio.renderer.scene(), input, jitter);
  const std::vector<glm::dmat4> now = pose(studio.renderer.scene(), input.now),
                                before = pose(studio.renderer.scene(), input.before);
  Deviation worst;
  for (uint32_t y = 0; y < input.height; ++y)
    for (uint32_t x = 0; x < input.width; ++x) {
      const size_t i = size_t(y) * input.width + x;
      if (object[i] == 0) continue;
      const Projected expected = oracle.before(x, y, depth[i], uint32_t(object[i]));
      const glm::dvec2 found(motion[2 * i], motion[2 * i + 1]);
      worst.motion_px = std::max(worst.motion_px, glm::length(found - (expected.pixel - oracle.pixel(x, y))));
      worst.depth = std::max(worst.depth, std::abs(previous_depth[i] / expected.depth - 1));
      worst.moving_objects += now[size_t(object[i]) - 1] != before[size_t(object[i]) - 1];
      ++worst.surfaces;
    }
  return worst;
}

TEST_F(Motion, IsExactToTwoHundredthsOfAPixel) {
  for (const char* rig : {"drive", "rotate", "pass", "overhead"})
    for (const int frame : {1, 7, 40}) {
      SCOPED_TRACE(std::string(rig) + " " + std::to_string(frame));
      const Deviation worst = deviation(*studio, studio->frame(rig, frame, {run_of("blend")}, {}));
      EXPECT_LT(worst.motion_px, 0.02);
      EXPECT_LT(worst.depth, 1e-4);
      EXPECT_GT(worst.surfaces, 20'000u);
      if (std::string_view(rig) != "rotate") {
        EXPECT_GT(worst.moving_objects, 300u);
      }
    }
}

TEST_F(Motion, IsExactWhenTheCameraZooms) {
  FrameInput input = studio->frame("drive", 5, {run_of("blend")}, {});
  input.before.vertical_fov *= 1.1;
  EXPECT_LT(deviation(*studio, input).motion_px, 0.02);
}

TEST_F(Motion, IsZeroEverywhereWhenNothingMovesUnderJitter) {
  for (int frame = 1; frame < 5; ++frame) {
    const FrameInput input = studio->frame("still", frame, {run_of("blend")}, {{Output::motion}});
    ASSERT_NE(jitter_offset(Jitter::halton_8, input.index), glm::dvec2(0));
    const FrameResult result = studio->renderer.render(input);
    for (const float value : result.delivered[0].image.values) ASSERT_EQ(value, 0.0f);
  }
}

TEST_F(Motion, OfWhatWasBehindTheCameraIsFarOutsideThePicture) {
  FrameInput input = studio->frame("still", 1, {run_of("blend")}, {{Output::motion}, {Output::object}});
  input.before.camera = input.now.camera * glm::dquat(glm::angleAxis(3.1, glm::dvec3(0, 1, 0)));
  const FrameResult result = studio->renderer.render(input);
  for (size_t i = 0; i < result.delivered[1].image.values.size(); ++i) {
    const glm::vec2 motion(result.delivered[0].image.values[2 * i],
                           result.delivered[0].image.values[2 * i + 1]);
    ASSERT_GT(glm::length(motion), 320.0f);
  }
}

TEST_F(Motion, ACutHasNone) {
  FrameInput input = studio->frame("drive", 20, {run_of("grand-tour")}, {{Output::motion}});
  input.cut = true; // and `before` is where the frame before was
  const FrameResult result = studio->renderer.render(input);
  for (const float value : result.delivered[0].image.values) ASSERT_EQ(value, 0);
}

} // namespace
} // namespace unghost
