// The demo with --watch, in a folder of a test's own.
#pragma once

#include "tests/window/driven_demo.h"

namespace unghost {

class WatchedDemo : public DrivenDemo {
protected:
  void SetUp() override {
    DrivenDemo::SetUp();
    if (IsSkipped()) return;
    copy = copy_program(folder.path);
    std::filesystem::copy_file(folder.path / "assets" / "asphalt.glb", scene);
  }

  Words watching(const std::string& mode, const std::string& rig) const {
    return {copy.string(), "demo",   scene.string(), "--watch", "--json", "--size",
            "320x180",     "--mode", mode,           "--rig",   rig};
  }
  /// As editors do it: another file takes its place.
  void replace(const std::filesystem::path& file, const std::string& content) const {
    std::filesystem::rename(folder.file("new", content), file);
  }
  /// Nothing moves, and nothing is written over it.
  static void stand_still(DemoRun& run) {
    run.press("u", "only the picture");
    run.press("p", "pause");
  }
  static Picture resting(const DemoRun& run) {
    for (Picture last = run.window().picture();;) {
      std::this_thread::sleep_for(Milliseconds(400));
      Picture now = run.window().picture();
      if (now.pixels == last.pixels) return now;
      last = std::move(now);
    }
  }

  std::filesystem::path copy, shaders = folder.path / "shaders", scene = folder.path / "scene.glb";
};

} // namespace unghost
