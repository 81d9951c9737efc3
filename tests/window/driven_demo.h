// The demo itself, driven on a desk as a person drives it.
#pragma once

#include <algorithm>
#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "tests/app/own_copy.h"
#include "tests/window/demo_run.h"

namespace unghost {

/// The share of pixels of which a channel is plainly another. What is written at the window's upper and lower
/// edge (names of modes, what a key did) is not looked at.
inline double difference(const Picture& one, const Picture& other) {
  constexpr int edge = 44, plainly = 16;
  if (one.size != other.size) return 1;
  size_t differing = 0, all = 0;
  for (int y = edge; y < one.size.height - edge; ++y)
    for (int x = 0; x < one.size.width; ++x, ++all)
      for (size_t i = 0; i < 3; ++i)
        if (std::abs(int(one.at({x, y})[i]) - int(other.at({x, y})[i])) > plainly) {
          ++differing;
          break;
        }
  return double(differing) / double(all);
}

/// Where the window says what a key did.
inline std::vector<Colour> lowest_lines(const Picture& picture) {
  constexpr int lines = 44;
  return {picture.pixels.end() - std::ptrdiff_t(lines) * picture.size.width, picture.pixels.end()};
}

/// Suites of it are skipped where there can be no desk.
class DrivenDemo : public testing::Test {
protected:
  static constexpr Size small{320, 180};

  void SetUp() override {
    if (const std::string sentence = Desk::missing(); !sentence.empty()) GTEST_SKIP() << sentence;
    desk.emplace(Size{640, 480});
    configure({});
  }

  static std::string program() { return (folder_of_this_program() / "unghost").string(); }

  std::filesystem::path config_file() const { return desk->home() / "config" / "unghost" / "config.json"; }

  /// What the next run finds; without a panel, which takes longer to draw than the picture.
  void configure(nlohmann::json state) const {
    state.emplace("panel", false);
    std::filesystem::create_directories(config_file().parent_path());
    std::ofstream(config_file()) << state;
  }

  /// In the test's folder, and validated, wherever the test is started from.
  DemoRun started(Size size = small, const Words& more = {}) const {
    Words words = {"env",
                   "-C",
                   folder.path.string(),
                   program(),
                   "demo",
                   "--json",
                   "--size",
                   std::to_string(size.width) + "x" + std::to_string(size.height)};
    words.insert(words.end(), more.begin(), more.end());
    return DemoRun(*desk, words, {"UNGHOST_VALIDATE=1"});
  }

  static bool comes_true(const std::function<bool()>& condition) {
    for (const auto until = std::chrono::steady_clock::now() + patience;
         std::chrono::steady_clock::now() < until;) {
      if (condition()) return true;
      std::this_thread::sleep_for(Milliseconds(30));
    }
    return false;
  }
  static bool comes_to_differ(const DemoRun& run, const Picture& from, double share) {
    return comes_true([&] { return difference(run.window().picture(), from) > share; });
  }
  static bool comes_back(const DemoRun& run, const Picture& to) {
    return comes_true([&] { return difference(run.window().picture(), to) == 0; });
  }
  /// What the program tells of its state; where no pixel is picked, the key does nothing else.
  static nlohmann::json asked(DemoRun& run) { return run.press("i", "pixel"); }
  /// However long they take: between two answers lies a frame.
  static void let_frames_pass(DemoRun& run) {
    for (int answers = 0; answers < 4; ++answers) asked(run);
  }
  static Picture later_picture(DemoRun& run) {
    let_frames_pass(run);
    return run.window().picture();
  }

  /// Of a demo that is paused, with nothing said on it.
  static Picture silent_picture(DemoRun& run) {
    run.press("u", "only the picture");
    const std::vector<Colour> silent = lowest_lines(later_picture(run));
    run.press("u", "only the picture");
    EXPECT_TRUE(comes_true([&] { return lowest_lines(run.window().picture()) == silent; }));
    return run.window().picture();
  }

  /// With a code of 0, which a complaint of the validation layer or a leak would change, and without a word.
  static void expect_left_in_silence(DemoRun& run) {
    EXPECT_EQ(run.leave(), 0);
    EXPECT_EQ(run.talk(), "");
  }

  ScratchFolder folder; // where the program works
  std::optional<Desk> desk;
};

} // namespace unghost
