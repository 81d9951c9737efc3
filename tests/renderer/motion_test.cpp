// Motion vectors against double precision on the CPU.
#include <cmath>

#include "app/measure/stability/block_world.h"
#include "app/measure/stability/motion_oracle.h"
#include "renderer/view.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Motion : public StudioTest {};

MotionDeviation deviation(Studio& studio, FrameInput input, bool broken = false) {
  input.wanted = {{Output::motion}, {Output::depth}, {Output::object}, {Output::previous_depth}};
  FrameResult result = studio.renderer.render(input);
  if (broken)
    for (const size_t image : {0, 3})
      for (float& value : result.delivered[image].image.values) value = NAN;
  return motion_deviation(studio.renderer.scene(), input, jitter_of(input.modes[0].taa, input),
                          {.motion = result.delivered[0].image,
                           .depth = result.delivered[1].image,
                           .object = result.delivered[2].image,
                           .previous_depth = result.delivered[3].image});
}

TEST_F(Motion, IsExactToTwoHundredthsOfAPixel) {
  for (const char* rig : {"drive", "rotate", "pass", "overhead"})
    for (const int frame : {1, 7, 40}) {
      SCOPED_TRACE(std::string(rig) + " " + std::to_string(frame));
      const MotionDeviation worst = deviation(*studio, studio->frame(rig, frame, {run_of("blend")}, {}));
      EXPECT_LT(worst.motion_px, 0.02);
      EXPECT_LT(worst.depth, 1e-4);
      EXPECT_GT(worst.surfaces, 20'000u);
      if (std::string_view(rig) != "rotate") {
        EXPECT_GT(worst.moving, 300u);
      }
    }
}

TEST_F(Motion, ThatIsNoNumberIsAsWrongAsCanBe) {
  FrameInput input = studio->frame("drive", 5, {run_of("blend")}, {});
  for (const double turned : {0.0, 3.0}) { // what was behind the camera is judged by itself
    input.before.camera *= glm::angleAxis(turned, glm::dvec3(0, 1, 0));
    EXPECT_EQ(deviation(*studio, input, true).motion_px, INFINITY);
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

/// Why the host subtracts the camera in double: 1,000 km from the origin a float knows 6 cm.
TEST(MotionInFloats, IsPixelsOffFarFromTheOrigin) {
  const BlockWorld world{.side = 1, .origin = {1e6f, 0, -1e6f}};
  const Instant before = block_instant(world, {});
  Instant now = before, in_floats = before;
  now.eye += glm::dvec3(0.013, 0.002, 0.011);
  in_floats.eye = glm::dvec3(glm::vec3(now.eye));
  const glm::dvec3 corner = glm::dvec3(world.origin) + glm::dvec3(0.5, 1, 0.5);
  const glm::dvec2 exact = project(now, corner, 128, 72).pixel,
                   found = project(in_floats, corner, 128, 72).pixel;
  EXPECT_GT(glm::distance(exact, found), 0.02);
}

/// Why depth is reversed: beside 1 a float has no digits left for what is far.
TEST(MotionInFloats, DepthTheOtherWayRoundLosesTheDistance) {
  const float near_plane = 1e-4f;
  for (const float distance : {0.5f, 10.0f, 900.0f}) {
    const float reversed = near_plane / distance;
    volatile float usual = 1 - near_plane / distance; // rounded to a float, as an image holds it
    const float from_usual = usual < 1 ? near_plane / (1 - usual) : INFINITY;
    EXPECT_NEAR(near_plane / reversed / distance, 1, 1e-6);
    EXPECT_GT(std::abs(from_usual / distance - 1), 1e-5);
  }
}

} // namespace
} // namespace unghost
