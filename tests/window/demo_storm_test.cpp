// Much that a person could do to the real demo, at random.
#include "tests/app/triangle_model.h"
#include "tests/window/driven_demo.h"

#include <random>

namespace unghost {
namespace {

using nlohmann::json;

class DemoStorm : public DrivenDemo {};

/// What a person could do, chosen by a number; the same for the same seed.
class Storm {
public:
  Storm(const DeskWindow& window, std::vector<std::filesystem::path> files, uint32_t seed)
      : window_(window), files_(std::move(files)), random_(seed) {}

  void one() {
    switch (below(12)) {
    case 0:
      window_.resize({1 + below(400), 1 + below(300)});
      break;
    case 1:
      minimised_ = !minimised_;
      if (minimised_)
        window_.minimise();
      else
        window_.restore();
      break;
    case 2:
      window_.drag(spot(), spot(), Milliseconds(4));
      break;
    case 3:
      window_.scroll(below(2) == 0 ? 2 : -2);
      break;
    case 4:
      window_.move_mouse(spot());
      break;
    case 5:
    case 6:
      window_.press(std::to_string(below(10)));
      break;
    case 7:
      if (!minimised_)
        window_.drop({files_[size_t(below(int(files_.size())))]}); // else there is nothing to see
      break;
    default:
      window_.press(keys[size_t(below(int(keys.size())))]);
    }
  }

  void calm() {
    window_.restore();
    window_.resize({200, 120});
  }

private:
  // of every row but the one that leaves
  static inline const Words keys = {"Return",  "z",    "x",       "c",       "r",           "f",
                                    "space",   "t",    "g",       "Tab",     "v",           "b",
                                    "n",       "p",    "shift+n", "period",  "BackSpace",   "k",
                                    "shift+v", "Home", "l",       "F11",     "F12",         "h",
                                    "u",       "w",    "e",       "shift+a", "bracketleft", "bracketright"};

  int below(int end) { return int(random_() % uint32_t(end)); }
  Spot spot() { return {below(200), below(120)}; }

  const DeskWindow& window_;
  const std::vector<std::filesystem::path> files_;
  std::mt19937 random_;
  bool minimised_ = false;
};

TEST_F(DemoStorm, FiveHundredThingsDoneToItLeaveItSilentAndClean) {
  constexpr uint32_t seed = 20260611;
  constexpr int operations = 500;
  SCOPED_TRACE("seed " + std::to_string(seed));
  desk.emplace(Size{400, 300}); // where it fills the screen, too, it draws fast
  configure({});
  DemoRun run = started({200, 120});
  const std::string scene = glb(model({4, 3, 5}, {0, 0, 0}));
  Storm storm(run.window(),
              {folder.file("scene.glb", scene), folder.file("half.glb", scene.substr(0, scene.size() / 2)),
               folder.path / "gone.glb"},
              seed);
  size_t events = 0, drops = 0;
  for (int i = 0; i < operations; ++i) {
    SCOPED_TRACE("operation " + std::to_string(i));
    storm.one();
    while (const auto event = run.next_event(Milliseconds(0))) { // or it would wait until somebody reads
      ++events;
      drops += event->value("event", "") == "drop";
    }
  }
  storm.calm();
  while (run.next_event(Milliseconds(1500))) ++events; // what a slow one has not answered yet
  EXPECT_GT(events, 100u);                             // a minimised window has no keys
  EXPECT_GT(drops, 5u);
  let_frames_pass(run); // what follows the mouse is told as of the last frame, of another size maybe
  const json calm = run.press("Tab", "movement");
  EXPECT_GT(calm["drawn"], 1); // how many more depends on the machine
  expect_left_in_silence(run);
  EXPECT_EQ(started({200, 120}).ready()["state"], calm["state"]);
}

} // namespace
} // namespace unghost
