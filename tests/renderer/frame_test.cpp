// What a frame is made of: what nobody asks for is not drawn, and one geometry feeds many resolves.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "renderer/view.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Frame : public StudioTest {
protected:
  /// The passes of the third frame of a run.
  std::vector<std::string> passes(const char* rig, const std::vector<ModeRun>& modes, Wanted wanted) {
    FrameResult result;
    for (int frame = 0; frame < 3; ++frame)
      result = studio->renderer.render(studio->frame(rig, frame, modes, {wanted}));
    std::vector<std::string> names;
    for (const PassReport& pass : result.passes) names.push_back(pass.name);
    return names;
  }
  static auto count(const std::vector<std::string>& names, std::string_view name) {
    return std::ranges::count(names, name);
  }
};

TEST_F(Frame, OffHasNoMotionAndNoResolve) {
  const std::vector<std::string> names = passes("drive", {run_of("off")}, {Output::display});
  EXPECT_EQ(count(names, "motion"), 0);
  EXPECT_EQ(count(names, "g-buffer"), 1);
  for (const std::string& name : names) EXPECT_FALSE(name.starts_with("taa"));
}

TEST_F(Frame, ModesThatShareAJitterShareGeometryAndLight) {
  const std::vector<std::string> names =
      passes("drive", {run_of("blend"), run_of("gdk-clamp"), run_of("grand-tour")}, {Output::display, 2});
  EXPECT_EQ(count(names, "g-buffer"), 1);
  EXPECT_EQ(count(names, "light"), 1);
  EXPECT_EQ(count(names, "taa blend"), 1);
  EXPECT_EQ(count(names, "taa gdk-clamp"), 1);
  EXPECT_EQ(count(names, "taa grand-tour"), 1);
  EXPECT_EQ(count(names, "tone map"), 1) << "only what is wanted is tone-mapped";
}

TEST_F(Frame, OffCostsNothingUntilItIsWanted) {
  const std::vector<ModeRun> modes{run_of("off"), run_of("blend")};
  EXPECT_EQ(count(passes("drive", modes, {Output::display, 1}), "g-buffer"), 1);
  EXPECT_EQ(count(passes("drive", modes, {Output::display, 0}), "g-buffer"), 2);
}

TEST_F(Frame, ShadowsOfWhatRestsAreDrawnOnce) {
  const std::vector<std::string> still = passes("still", {run_of("blend")}, {Output::display});
  EXPECT_EQ(count(still, "shadows of what rests"), 0);
  EXPECT_EQ(count(still, "shadows of what moves"), 0);
  EXPECT_EQ(count(passes("pass", {run_of("blend")}, {Output::display}), "shadows of what moves"), 1);
}

TEST_F(Frame, ACutDrawsTheShadowsOfWhatRestsAgain) {
  FrameInput input = studio->frame("still", 0, {run_of("off")}, {{Output::display}});
  studio->renderer.render(input);
  input.now.eye += glm::dvec3(0.013, 0.007, -0.011); // where it rounds otherwise
  input.cut = true;
  const FrameResult after = studio->renderer.render(input);
  EXPECT_EQ(std::ranges::count(after.passes, "shadows of what rests", &PassReport::name), 1);
}

TEST_F(Frame, OneShadowMapServesEveryJitter) {
  const std::vector<std::string> names =
      passes("pass", {run_of("off"), run_of("blend")}, {Output::display, 0});
  EXPECT_EQ(count(names, "g-buffer"), 2);
  EXPECT_EQ(count(names, "shadows of what moves"), 1);
}

TEST_F(Frame, ShadowsFollowWhatRestsElsewhereAfterACut) {
  const auto frozen = [&](int instant) {
    FrameInput input = studio->frame("pass", instant, {run_of("off")}, {{Output::sun_visibility}});
    input.before = input.now;
    input.cut = true;
    return input;
  };
  studio->renderer.render(frozen(12));
  const FrameResult after = studio->renderer.render(frozen(30));
  Renderer fresh(studio->device, studio->data.shaders, studio->staged.scene);
  EXPECT_EQ(after.delivered[0].image.values, fresh.render(frozen(30)).delivered[0].image.values);
}

TEST_F(Frame, APassSaysWhichImagesItReadsAndWrites) {
  FrameResult result;
  for (int frame = 0; frame < 2; ++frame)
    result = studio->renderer.render(studio->frame("drive", frame, {run_of("blend")}, {{Output::display}}));
  const auto resolve = std::ranges::find(result.passes, "taa blend", &PassReport::name);
  ASSERT_NE(resolve, result.passes.end());
  std::set<std::string> read, written;
  for (const PassImage& image : resolve->images) {
    EXPECT_GE(image.bytes, 320u * 180 * 4) << image.name;
    (image.reads ? read : written).insert(image.name);
  }
  EXPECT_EQ(read, (std::set<std::string>{"last frame's history 0", "lit", "motion"}));
  EXPECT_EQ(written, (std::set<std::string>{"history 0"}));
}

TEST_F(Frame, AnySizeAndAnotherOneEveryFrame) {
  constexpr std::pair<uint32_t, uint32_t> sizes[] = {{1, 1}, {1, 720}, {4097, 3}, {37, 23}, {1, 1}, {64, 36}};
  for (int frame = 0; frame < int(std::size(sizes)); ++frame) {
    FrameInput input = studio->frame("drive", frame, {run_of("grand-tour")}, {{Output::display}});
    std::tie(input.width, input.height) = sizes[frame];
    EXPECT_EQ(studio->renderer.render(input).delivered[0].picture.rgba.size(),
              size_t(input.width) * input.height * 4);
  }
}

TEST_F(Frame, AnEmptySceneIsASky) {
  Scene empty;
  empty.materials.push_back({});
  Renderer renderer(studio->device, studio->data.shaders, empty);
  const FrameInput input =
      studio->frame("still", 0, {run_of("grand-tour")}, {{Output::object}, {Output::lit}});
  const FrameResult result = renderer.render(input);
  for (const float id : result.delivered[0].image.values) ASSERT_EQ(id, 0.0f);
  for (const float value : result.delivered[1].image.values) ASSERT_GT(value, 0.0f);
}

TEST_F(Frame, ComparedModesAreThoseDrawnAlone) {
  const auto last = [&](const std::vector<ModeRun>& modes, size_t mode) {
    FrameResult result;
    for (int frame = 0; frame < 6; ++frame)
      result = studio->renderer.render(studio->frame("drive", frame, modes, {{Output::display, mode}}));
    return result.delivered[0].picture.rgba;
  };
  const std::vector<uint8_t> alone = last({run_of("grand-tour")}, 0);
  EXPECT_EQ(last({run_of("off"), run_of("blend"), run_of("grand-tour")}, 2), alone);
}

TEST_F(Frame, ACutLeavesNothingOfBefore) {
  const std::vector<ModeRun> modes{run_of("blend")};
  for (int frame = 0; frame < 4; ++frame) studio->renderer.render(studio->frame("rotate", frame, modes, {}));
  FrameInput cut = studio->frame("drive", 20, modes, {{Output::display}});
  cut.cut = true;
  cut.before = cut.now;
  const std::vector<uint8_t> after_cut = studio->renderer.render(cut).delivered[0].picture.rgba;
  Renderer fresh(studio->device, studio->data.shaders, studio->staged.scene);
  EXPECT_EQ(fresh.render(cut).delivered[0].picture.rgba, after_cut);
}

// Sectors of the road are turned into place one by one, which rounds: between them, too, is asphalt.
TEST_F(Frame, NoSkyIsSeenThroughTheRoad) {
  size_t holes = 0, pixels = 0;
  for (int index = 0; index < 64; index += 3) {
    FrameInput input = studio->frame("drive", index, {run_of("off")}, {{Output::depth}});
    input.width = 640, input.height = 360;
    const FloatImage depth = studio->renderer.render(input).delivered[0].image;
    for (size_t pixel = size_t(depth.width) * 200; pixel < depth.values.size(); ++pixel, ++pixels)
      holes += !std::isfinite(depth.values[pixel]);
  }
  EXPECT_LT(double(holes), 1e-6 * double(pixels)) << holes;
}

// Each reads other images of the frame, and what nobody reads is not made.
TEST_F(Frame, EveryViewIsDrawnWithAndWithoutAHistoryAndShowsSomethingElse) {
  std::set<std::vector<uint8_t>> pictures;
  for (const Answer& view : answers<View>())
    for (const char* mode : {"off", "grand-tour"}) {
      std::vector<uint8_t> picture;
      for (int index = 0; index < 3; ++index) {
        FrameInput input = studio->frame("drive", index, {run_of(mode)}, {{Output::display}});
        input.settings.view = View(view.value);
        picture = studio->renderer.render(input).delivered[0].picture.rgba;
      }
      if (std::string_view(mode) == "grand-tour") pictures.insert(picture);
    }
  EXPECT_EQ(pictures.size(), answers<View>().size());
}

TEST_F(Frame, AgeCountsTheFramesThatAPixelHolds) {
  std::vector<int> ages; // of a pixel in the middle of a still picture
  for (int index = 0; index < 9; ++index) {
    FrameInput input = studio->frame("still", index, {run_of("blend"), run_of("crytek-2x")},
                                     {{Output::display, 0}, {Output::display, 1}});
    input.cut = index == 0 || index == 5;
    if (index != 1) input.settings.view = View::age;
    const FrameResult result = studio->renderer.render(input);
    const auto frames = [&](size_t mode) {
      const double grey = result.delivered[mode].picture.rgba[4 * (90 * 320 + 160)] / 255.0;
      return int(std::lround(std::exp2(6 * grey) - 1));
    };
    if (index != 1) ages.push_back(frames(0));
    EXPECT_TRUE(index == 1 || frames(1) <= 2) << "two frames hold no more";
  }
  // one; not looked at in the second, so that the third begins to count; a cut at the sixth
  EXPECT_EQ(ages, (std::vector<int>{1, 2, 3, 4, 1, 2, 3, 4}));
}

// Off-screen red, tag green, near and moving violet, all else grey: where the views of a cause have it alone,
// so has this one.
TEST_F(Frame, RejectedHasAColourACause) {
  std::map<View, std::vector<uint8_t>> pictures;
  for (const View view : {View::rejected, View::tag_rejected, View::near_moving})
    for (int index = 0; index < 4; ++index) {
      FrameInput input = studio->frame("drive", index, {run_of("grand-tour")}, {{Output::display}});
      input.settings.view = view;
      pictures[view] = studio->renderer.render(input).delivered[0].picture.rgba;
    }
  size_t tags = 0, near = 0;
  for (size_t i = 0; i < pictures[View::rejected].size(); i += 4) {
    const auto marked = [&](View view) {
      const uint8_t* shown = &pictures[view][i];
      return shown[0] != shown[1] || shown[1] != shown[2];
    };
    const uint8_t* shown = &pictures[View::rejected][i];
    const int red = shown[0], green = shown[1], blue = shown[2];
    if (marked(View::near_moving)) {
      near += 1;
      EXPECT_TRUE(blue > green && red > green) << i;
    } else if (marked(View::tag_rejected)) {
      tags += 1;
      EXPECT_TRUE(green > red && green > blue) << i;
    } else {
      EXPECT_TRUE(red >= green || !marked(View::rejected)) << i; // off-screen
    }
  }
  EXPECT_GT(tags, 10u);
  EXPECT_GT(near, 100u);
}

/// The mean difference of neighbours across, in 8 bits.
double contrast(const Image& picture) {
  double sum = 0;
  for (size_t i = 4; i < picture.rgba.size(); i += 4)
    sum += std::abs(int(picture.rgba[i]) - int(picture.rgba[i - 4]));
  return sum / double(picture.rgba.size() / 4);
}

TEST_F(Frame, SharpeningAndMipBiasAddContrastAndNothingElse) {
  const auto picture = [&](float amount, float bias, float sun) {
    ModeRun run = run_of("off");
    run.taa.sharpen = amount, run.taa.mip_bias = bias;
    FrameInput input = studio->frame("drive", 5, {run}, {{Output::display}});
    input.settings.light.sun_illuminance = sun;
    if (sun == 0) input.settings.light.sky_luminance = 0;
    return studio->renderer.render(input).delivered[0].picture;
  };
  const double plain = contrast(picture(0, 0, 1));
  EXPECT_GT(contrast(picture(2, 0, 1)), 1.2 * plain);
  EXPECT_GT(contrast(picture(0, -2, 1)), 1.05 * plain);
  const Image dark = picture(0, 0, 0), sharp = picture(2, 0, 0); // but for what shines by itself
  for (size_t i = 0; i < dark.rgba.size(); ++i)
    ASSERT_TRUE(dark.rgba[i] != 0 || sharp.rgba[i] == 0) << "what is black stays black, " << i;
}

// Without its jitter a texture stands still: under the jitter only edges move.
TEST_F(Frame, TexturesCanStandStillUnderTheJitter) {
  const auto change = [&](TextureJitter texture_jitter) {
    ModeRun run = run_of("blend");
    run.taa.texture_jitter = texture_jitter;
    Image pictures[2];
    for (int i : {0, 1}) {
      FrameInput input = studio->frame("still", 0, {run}, {{Output::display}});
      input.index = uint64_t(i);
      input.settings.view = View::albedo;
      pictures[i] = studio->renderer.render(input).delivered[0].picture;
    }
    double sum = 0;
    for (size_t i = 0; i < pictures[0].rgba.size(); ++i)
      sum += std::abs(int(pictures[0].rgba[i]) - int(pictures[1].rgba[i]));
    return sum;
  };
  EXPECT_LT(change(TextureJitter::removed), 0.6 * change(TextureJitter::kept));
}

// One that is would leave a streak through a history that nothing bounds.
TEST_F(Frame, NothingIsBrighterThanTheSunsDisc) {
  const float disc = 60 * 5.2f; // sky.glsl, sun.cpp
  for (int index = 0; index < 48; index += 2) {
    FrameInput input = studio->frame("drive", index, {run_of("blend")}, {{Output::lit}});
    input.width = 960, input.height = 540;
    const FrameResult result = studio->renderer.render(input);
    EXPECT_LE(std::ranges::max(result.delivered[0].image.values), disc) << index;
  }
}

// The road beside the sill sees less of the sky than it does when the vehicle is elsewhere.
TEST_F(Frame, TheVehicleHidesTheSkyFromTheRoadBelowIt) {
  FrameInput input = studio->frame("still", 0, {run_of("off")}, {{Output::lit}});
  input.settings.light.sun_illuminance = 0;
  const auto road_at = [&](double left_m) { // mean of 5x5 pixels there
    const glm::dvec3 world = studio->at("still", 0).vehicle * glm::dvec4(left_m, 0, 0.3, 1);
    const glm::uvec2 place(project(input.now, world, input.width, input.height).pixel);
    const FrameResult result = studio->renderer.render(input);
    double sum = 0;
    for (uint32_t y = place.y - 2; y <= place.y + 2; ++y)
      for (uint32_t x = place.x - 2; x <= place.x + 2; ++x)
        sum += result.delivered[0].image.values[3 * (size_t(y) * input.width + x) + 1];
    return sum;
  };
  const double sill = studio->staged.vehicle.high.x + 0.1, beside = road_at(sill), away = road_at(sill + 3);
  input.now.vehicle[3] += glm::dvec4(0, 0, 40, 0);
  const double share = beside / road_at(sill);
  EXPECT_LT(share, 0.93);
  EXPECT_GT(share, 0.5);
  EXPECT_NEAR(away / road_at(sill + 3), 1, 0.02);
}

} // namespace
} // namespace unghost
