// Pixels that a person picks in the real demo, and where the window marks them.
#include "tests/window/driven_demo.h"

namespace unghost {
namespace {

class DemoPick : public DrivenDemo {
protected:
  static void click(DemoRun& run, Spot at) {
    run.window().click(at);
    EXPECT_EQ(run.expect_event("pick")["event"], "mouse");
  }
  static void shift_click(DemoRun& run, Spot at) {
    run.window().hold("shift");
    run.window().click(at);
    run.window().let_go("shift");
    run.expect_event("pick");
  }
};

/// The middle of what is that colour in a part of the window, and was not before.
struct Mark {
  size_t pixels = 0;
  Spot low{1 << 20, 1 << 20}, high{-1, -1};

  Spot middle() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
};

constexpr Colour gold{255, 210, 60}, white{255, 255, 255};

bool is_near(const Colour& one, const Colour& other) {
  for (size_t i = 0; i < 3; ++i)
    if (std::abs(int(one[i]) - int(other[i])) > 40) return false;
  return true;
}

Mark mark_in(const Picture& now, const Picture& before, Spot corner, Size part, const Colour& colour) {
  Mark mark;
  for (int y = corner.y; y < corner.y + part.height; ++y)
    for (int x = corner.x; x < corner.x + part.width; ++x) {
      if (!is_near(now.at({x, y}), colour) || is_near(before.at({x, y}), colour)) continue;
      ++mark.pixels;
      mark.low = {std::min(mark.low.x, x), std::min(mark.low.y, y)};
      mark.high = {std::max(mark.high.x, x), std::max(mark.high.y, y)};
    }
  return mark;
}

TEST_F(DemoPick, AClickMarksAPixelAndOneWithShiftTakesTheMarkAway) {
  configure({{"rig", "still"}, {"shown", "off"}});
  DemoRun run = started();
  const Picture before = later_picture(run);
  const auto marked = [&] { return mark_in(run.window().picture(), before, {0, 0}, small, gold); };
  for (const Spot at : {Spot{100, 90}, {210, 70}}) {
    click(run, at);
    EXPECT_TRUE(comes_true([&] {
      const Spot is = marked().middle();
      return std::abs(is.x - at.x) <= 1 && std::abs(is.y - at.y) <= 1;
    })) << at.x;
  }
  shift_click(run, {160, 100});
  EXPECT_TRUE(comes_back(run, before));
  shift_click(run, {160, 100}); // where none is
  EXPECT_EQ(marked().pixels, 0u);
  expect_left_in_silence(run);
}

TEST_F(DemoPick, AGridMarksThePixelInEveryPictureAndInGoldWhereItWasClicked) {
  configure({{"rig", "still"},
             {"shown", "off"},
             {"compared", {"blend", "uncharted", "rgb"}},
             {"arrangement", "grid"}});
  DemoRun run = started({640, 360});
  run.press("p", "pause"); // or edges would flicker white
  const Picture before = silent_picture(run);
  const Size part{320, 180};
  constexpr Spot corners[] = {{0, 0}, {320, 0}, {0, 180}, {320, 180}};
  for (size_t clicked = 0; clicked < 4; ++clicked) {
    const Spot within{100 + 30 * int(clicked), 80 + 10 * int(clicked)};
    click(run, {corners[clicked].x + within.x, corners[clicked].y + within.y});
    const auto marked = [&](const Picture& now, size_t cell) {
      const auto of = [&](const Colour& colour) { return mark_in(now, before, corners[cell], part, colour); };
      const Spot is = of(cell == clicked ? gold : white).middle();
      return std::abs(is.x - corners[cell].x - within.x) <= 2 &&
             std::abs(is.y - corners[cell].y - within.y) <= 2 &&
             of(cell == clicked ? white : gold).pixels == 0;
    };
    EXPECT_TRUE(comes_true([&] {
      const Picture now = run.window().picture();
      return marked(now, 0) && marked(now, 1) && marked(now, 2) && marked(now, 3);
    })) << clicked;
  }
  run.press("p", "pause");
  expect_left_in_silence(run);
}

} // namespace
} // namespace unghost
