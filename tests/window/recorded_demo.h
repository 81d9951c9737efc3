// The demo, and the paths that it records.
#pragma once

#include "tests/window/driven_demo.h"

namespace unghost {

/// The header and the pixels of a PNG, as they are compressed: alike where the pixels are.
inline std::string pixels_in(const std::string& png) {
  std::string pixels;
  for (size_t at = 8; at + 12 <= png.size();) {
    uint32_t length = 0;
    for (size_t i = 0; i < 4; ++i) length = length << 8 | uint8_t(png[at + i]);
    const std::string kind = png.substr(at + 4, 4);
    if (kind == "IHDR" || kind == "IDAT") pixels += png.substr(at + 8, length);
    at += 12 + size_t(length);
  }
  return pixels;
}

class RecordedDemo : public DrivenDemo {
protected:
  std::string pixels_of(const std::string& picture) const {
    return pixels_in(content_of(folder.path / picture));
  }
  void expect_same(const std::string& one, const std::string& other) const {
    EXPECT_GT(pixels_of(one).size(), 1000u) << one;
    EXPECT_TRUE(pixels_of(one) == pixels_of(other)) << one << " and " << other;
  }

  /// The program without a window, in the folder of the test, and validated.
  int without_window(const Words& more) const {
    Words words = {"env", "UNGHOST_VALIDATE=1", program()};
    words.insert(words.end(), more.begin(), more.end());
    words.push_back("--quiet");
    return exit_of(words, folder.path);
  }

  /// A key that changes nothing, as no pixel is picked.
  static uint64_t drawn(DemoRun& run) { return run.press("i", "pixel")["drawn"]; }
  static void draw_more(DemoRun& run, uint64_t frames) {
    const uint64_t from = drawn(run);
    EXPECT_TRUE(comes_true([&] { return drawn(run) >= from + frames; }));
  }

  static void take(DemoRun& run, const std::string& picture) {
    run.window().press("F12");
    EXPECT_EQ(run.expect_event(picture)["event"], "screenshot");
  }

  /// Takes the picture of the last frame.
  static void pause(DemoRun& run) {
    run.press("p", "pause");
    take(run, "unghost-1.png");
  }

  /// The same, and ends the recording; the name of its file.
  static std::string end(DemoRun& run) {
    pause(run);
    run.window().press("o");
    const std::string said = run.expect_event("recorded")["message"];
    return said.substr(0, said.find(": "));
  }
};

} // namespace unghost
