// A pixel of a frame that was shown, asked about when that is over: what it says is what the frame would have
// said itself.
#include <cstdlib>

#include "app/demo/window.h"
#include "renderer/gpu/swapchain.h"
#include "tests/renderer/studio.h"
#include "tests/window/desk.h"

namespace unghost {
namespace {

constexpr uint32_t width = 160, height = 90;
/// From that frame on the second mode is another one, whose history begins there; a pixel of it is asked
/// about.
constexpr int changed = 7;

/// A display for this process.
struct Screen {
  Desk desk{Size{320, 240}};
  Screen() { setenv("DISPLAY", desk.display().c_str(), 1); }
};

/// A stage whose frames are shown in a window.
struct WindowStudio {
  Window window{width, height};
  Device device{{.validate = true, .window = window.surface_maker()}};
  Swapchain swapchain{device, window.pixels()};
  DataFolders data = find_data_folders();
  Staged staged = build_stage(data.assets / "asphalt.glb", data.assets / "asphalt.glb", {});
  Renderer renderer{device, data.shaders, staged.scene};

  FrameInput frame(int index, const std::optional<ProbeInput>& probe) const {
    const RigContext context{.track_radius = staged.track_radius, .vehicle = staged.vehicle};
    const auto at = [&](int of) { return find_rig("drive")->at(context, of * seconds_per_frame); };
    FrameInput input{.now = at(index), .before = at(std::max(index - 1, 0)), .index = uint64_t(index)};
    input.cut = index == 0;
    input.width = width, input.height = height;
    for (const char* mode : {"off", index < changed ? "grand-tour" : "ycocg-var", "ac4"})
      input.modes.push_back({mode, settings_for_mode(mode).taa});
    input.screen = ScreenInput{.width = width, .height = height};
    input.probe = probe;
    return input;
  }
  std::optional<FrameResult> show(const FrameInput& input) {
    if (const VkExtent2D now = window.pixels(); now.width != swapchain.extent().width) swapchain.resize(now);
    window.events(0);
    return renderer.show(input, swapchain);
  }
};

class ProbeAgain : public testing::Test {
protected:
  void SetUp() override {
    if (const std::string sentence = Desk::missing(); !sentence.empty()) GTEST_SKIP() << sentence;
    screen.emplace();
    studio.emplace();
  }
  void TearDown() override {
    if (!studio) return;
    for (const std::string& message : studio->device.validation_messages()) ADD_FAILURE() << message;
    studio.reset(); // before what it is shown on
  }

  std::optional<Screen> screen;
  std::optional<WindowStudio> studio;
};

void expect_same(const ProbedPixel& is, const ProbedPixel& expected, const std::string& where) {
  EXPECT_EQ(is.input, expected.input) << where;
  EXPECT_EQ(is.mode, expected.mode) << where;
  EXPECT_EQ(is.exposure, expected.exposure) << where;
  EXPECT_EQ(is.colours, expected.colours) << where;
  EXPECT_EQ(is.resolved, expected.resolved) << where;
  EXPECT_EQ(is.depth_m, expected.depth_m) << where;
  EXPECT_EQ(is.motion_px, expected.motion_px) << where;
  EXPECT_EQ(is.tag, expected.tag) << where;
  EXPECT_EQ(is.object, expected.object) << where;
  EXPECT_EQ(is.weight, expected.weight) << where;
  EXPECT_EQ(is.count, expected.count) << where;
  EXPECT_EQ(is.causes, expected.causes) << where;
  ASSERT_EQ(bool(is.history), bool(expected.history)) << where;
  if (!is.history) return;
  EXPECT_EQ(is.history->found, expected.history->found) << where;
  EXPECT_EQ(is.history->bounded, expected.history->bounded) << where;
  EXPECT_EQ(is.history->moved, expected.history->moved) << where;
  EXPECT_EQ(is.history->speaker, expected.history->speaker) << where;
  EXPECT_EQ(is.history->at_px, expected.history->at_px) << where;
}

/// Of a frame that comes `index`th; every mode in its turn, on the car and beside it.
ProbeInput pixel_of(int index) {
  return {.mode = size_t(index) % 3, .x = uint32_t(30 + 9 * (index % 12)), .y = uint32_t(40 + index % 20)};
}

TEST_F(ProbeAgain, SaysWhatTheFrameItselfSays) {
  constexpr int frames = 15;
  std::vector<ProbedPixel> asked; // of the frames themselves, which bring it when they land
  const auto take = [&](const std::optional<FrameResult>& landed) {
    if (landed && landed->probe) asked.push_back(*landed->probe);
  };
  for (int index = 0; index < frames + int(frames_in_flight); ++index)
    take(studio->show(studio->frame(index, pixel_of(index))));
  ASSERT_GE(asked.size(), size_t(frames));
  size_t with_history = 0, moving = 0;
  for (int index = 0; index < frames; ++index) {
    studio->show(studio->frame(index, {}));
    const auto other = studio->renderer.probe_again(pixel_of(index + 1)); // leaves behind what it found
    ASSERT_TRUE(other);
    const auto again = studio->renderer.probe_again(pixel_of(index));
    ASSERT_TRUE(again);
    expect_same(*again, asked[size_t(index)], std::to_string(index));
    with_history += bool(again->history);
    moving += again->motion_px != glm::vec2(0);
  }
  EXPECT_GT(with_history, 5u);
  EXPECT_GT(moving, 5u);
}

TEST_F(ProbeAgain, SaysNothingWhereNoSuchPixelWasShown) {
  EXPECT_FALSE(studio->renderer.probe_again({})) << "no frame was";
  studio->show(studio->frame(0, {}));
  EXPECT_TRUE(studio->renderer.probe_again({.mode = 2, .x = width - 1, .y = height - 1}));
  EXPECT_FALSE(studio->renderer.probe_again({.mode = 3}));
  EXPECT_FALSE(studio->renderer.probe_again({.x = width}));
  EXPECT_FALSE(studio->renderer.probe_again({.y = height}));
  FrameInput unshown = studio->frame(1, {});
  unshown.screen.reset();
  studio->renderer.render(unshown);
  EXPECT_FALSE(studio->renderer.probe_again({})) << "the last one was not";
}

} // namespace
} // namespace unghost
