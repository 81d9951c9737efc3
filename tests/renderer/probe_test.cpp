// What is told of one pixel is what whole images and plain arithmetic say of it.
#include <cmath>
#include <limits>

#include "app/measure/rectification.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Probe : public StudioTest {
protected:
  static constexpr uint32_t width = 160, height = 90;

  static FrameInput small(int index, const std::vector<ModeRun>& modes, const ProbeInput& probe) {
    FrameInput input = studio->frame("drive", index, modes, {});
    input.width = width, input.height = height, input.probe = probe;
    return input;
  }
};

std::vector<ModeRun> all_rows() {
  std::vector<ModeRun> modes;
  for (const TaaMode& mode : taa_modes()) modes.push_back(run_of(mode.name));
  return modes;
}

constexpr Output brought[] = {Output::lit,    Output::resolved, Output::depth,
                              Output::motion, Output::tag,      Output::object};

/// Of the whole images, in the order of `brought`.
void expect_same(const ProbedPixel& pixel, const std::vector<Delivered>& whole, const std::string& where) {
  const auto value = [&](size_t image, int dx, int dy, uint32_t channel) {
    const FloatImage& of = whole[image].image;
    const int x = std::clamp(int(pixel.input.x) + dx, 0, int(of.width) - 1),
              y = std::clamp(int(pixel.input.y) + dy, 0, int(of.height) - 1);
    return of.values[(size_t(y) * of.width + size_t(x)) * of.channels + channel];
  };
  for (int i = 0; i < 9; ++i)
    for (uint32_t c = 0; c < 3; ++c)
      EXPECT_EQ(pixel.colours[size_t(i)][int(c)], value(0, i % 3 - 1, i / 3 - 1, c)) << where << " " << i;
  for (uint32_t c = 0; c < 3; ++c) EXPECT_EQ(pixel.resolved[int(c)], value(1, 0, 0, c)) << where;
  EXPECT_EQ(pixel.depth_m, value(2, 0, 0, 0)) << where;
  for (uint32_t c = 0; c < 2; ++c) EXPECT_EQ(pixel.motion_px[int(c)], value(3, 0, 0, c)) << where;
  EXPECT_EQ(float(pixel.tag), value(4, 0, 0, 0)) << where;
  EXPECT_EQ(float(pixel.object), value(5, 0, 0, 0)) << where;
}

TEST_F(Probe, IsThePixelOfTheWholeImages) {
  const std::vector<ModeRun> modes = {run_of("off"), run_of("grand-tour"), run_of("holy-trail"),
                                      run_of("ac4"), run_of("ycocg-var")};
  const glm::uvec2 places[] = {
      {0, 0},   {width - 1, 0}, {0, height - 1}, {width - 1, height - 1}, {width / 2, height / 2},
      {70, 60}, {0, 50}};
  int index = 0;
  size_t tagged = 0;
  for (size_t mode = 0; mode < modes.size(); ++mode)
    for (const glm::uvec2 at : places) {
      FrameInput input = small(index++, modes, {.mode = mode, .x = at.x, .y = at.y});
      for (const Output what : brought) input.wanted.push_back({what, mode});
      const FrameResult result = studio->renderer.render(input);
      ASSERT_TRUE(result.probe);
      EXPECT_EQ(result.probe->input, *input.probe);
      EXPECT_EQ(result.probe->mode, modes[mode]);
      expect_same(*result.probe, result.delivered, modes[mode].name + " " + std::to_string(index));
      tagged += result.probe->tag != 0;
    }
  EXPECT_GT(tagged, 0u);
}

TEST_F(Probe, OfAPictureOfOnePixelHasNineOfThatColour) {
  FrameInput input = studio->frame("drive", 0, {run_of("dop32")}, {});
  input.width = input.height = 1, input.probe = ProbeInput{};
  const ProbedPixel pixel = *studio->renderer.render(input).probe;
  for (const glm::vec3& colour : pixel.colours) EXPECT_EQ(colour, pixel.colours[4]);
  EXPECT_FALSE(pixel.history);
  EXPECT_EQ(pixel.weight, 1);
}

TEST_F(Probe, NothingIsBroughtWhereNothingIsProbed) {
  FrameInput input = small(0, {run_of("dop32")}, {});
  input.probe.reset();
  EXPECT_FALSE(studio->renderer.render(input).probe);
}

/// The rectified history, worked out again from the nine colours and the history as it was read.
double difference(const ProbedPixel& pixel, const Rectification& r) {
  const glm::dvec3 is(pixel.history->bounded);
  return glm::distance(is, r.bounded) / (glm::length(r.bounded) + glm::length(r.found) + 1e-3);
}

/// What an average makes of the two, as a half float holds it.
double result_difference(const ProbedPixel& pixel) {
  const TaaPolicy& policy = pixel.mode.taa.policy;
  const glm::dvec3 mixed =
      from_working(policy, glm::mix(glm::dvec3(pixel.history->bounded),
                                    to_working(policy, glm::dvec3(pixel.mixed_in)), double(pixel.weight)));
  return glm::distance(mixed, glm::dvec3(pixel.resolved)) / (glm::length(mixed) + 1e-3);
}

TEST_F(Probe, EveryRowRectifiesAsPlainArithmeticDoes) {
  const std::vector<ModeRun> modes = all_rows();
  size_t moved = 0;
  for (int index = 0; index < int(6 * modes.size()); ++index) {
    const size_t mode = size_t(index) % modes.size(), round = size_t(index) / modes.size();
    const ProbeInput probe{.mode = mode, .x = uint32_t(25 + 20 * round), .y = uint32_t(30 + 5 * (round % 9))};
    FrameInput input = small(index, modes, probe);
    input.settings.light.sun_illuminance = index % 3 == 0 ? 0.3f : 1; // what a history may not keep up with
    const ProbedPixel pixel = *studio->renderer.render(input).probe;
    const TaaPolicy& policy = modes[mode].taa.policy;
    EXPECT_EQ(bool(pixel.history), policy.needs_history() && index > 0 && pixel.causes != Reject::off_screen)
        << modes[mode].name << index;
    if (!pixel.history) continue;
    Neighbourhood linear;
    std::ranges::copy(pixel.colours, linear.begin());
    const Rectification r = rectification_of(pixel.taa(), linear, glm::dvec3(pixel.history->found));
    EXPECT_LT(difference(pixel, r), 2e-5) << modes[mode].name << " " << index;
    moved += pixel.history->moved > 0;
    if (policy.rectify == Rectify::none) {
      EXPECT_EQ(pixel.history->moved, 0) << modes[mode].name;
    }
    if (pixel.causes == Reject::nothing) {
      EXPECT_LT(result_difference(pixel), 2e-3) << modes[mode].name << " " << index;
    }
  }
  EXPECT_GT(moved, 20u);
}

TEST_F(Probe, WeighsAsTheViewShows) {
  const std::vector<ModeRun> modes = {run_of("grand-tour"), run_of("holy-trail")};
  for (int index = 0; index < 12; ++index) {
    FrameInput input =
        small(index, modes, {.mode = size_t(index % 2), .x = uint32_t(30 + 8 * index), .y = 60});
    input.settings.view = View::weight;
    input.wanted = {{Output::display, input.probe->mode}};
    const FrameResult result = studio->renderer.render(input);
    const uint8_t shown = result.delivered[0].picture.rgba[4 * (size_t(60) * width + input.probe->x)];
    EXPECT_NEAR(shown, 255 * double(result.probe->weight), 1) << index;
  }
}

TEST(Volume, OfThreeAxesHasTheCornersOfABox) {
  const std::vector<Slab> box = {{{1, 0, 0}, 1, 2}, {{0, 1, 0}, -1, 3}, {{0, 0, 1}, 0, 4}};
  const std::vector<glm::dvec3> corners = corners_of(box);
  EXPECT_EQ(corners.size(), 24u) << "each of eight ends three edges";
  for (const glm::dvec3& corner : corners)
    for (int i = 0; i < 3; ++i) {
      const Slab& slab = box[size_t(i)];
      EXPECT_NEAR(std::min(std::abs(corner[i] - slab.low), std::abs(corner[i] - slab.high)), 0, 1e-6);
    }
}

// Euler's: as many corners and faces as edges and two; every corner of so irregular a volume ends three
// edges.
TEST(Volume, OfManyAxesHasCornersOnThreeOfItsFaces) {
  std::vector<Slab> ball;
  for (const glm::dvec3& axis : shipped_axes("dop32")) ball.push_back({axis, -1, 1});
  const std::vector<glm::dvec3> corners = corners_of(ball);
  EXPECT_EQ(corners.size(), 3u * 60) << "32 faces, 90 edges, 60 corners";
  for (const glm::dvec3& corner : corners) {
    EXPECT_NEAR(outside_of(ball, corner), 0, 1e-6);
    EXPECT_GE(glm::length(corner), 1);
  }
}

} // namespace
} // namespace unghost
