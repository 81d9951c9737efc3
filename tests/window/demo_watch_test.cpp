// The demo with --watch: files that change under it.
#include <thread>

#include <gtest/gtest.h>

#include "tests/app/own_copy.h"
#include "tests/window/demo_run.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class DemoWatch : public testing::Test {
protected:
  void SetUp() override {
    if (const std::string sentence = Desk::missing(); !sentence.empty()) GTEST_SKIP() << sentence;
    desk.emplace(Size{640, 480});
    fs::copy(folder_of_this_program() / "shaders", shaders);
    program = copy_program(folder.path);
    fs::copy_file(folder.path / "assets" / "asphalt.glb", scene);
  }

  Words words() const {
    return {program.string(), "demo",    scene.string(), "--watch", "--json",
            "--size",         "320x180", "--mode",       "blend"};
  }
  /// As editors do it: another file takes its place.
  void replace(const fs::path& file, const std::string& content) const {
    fs::rename(folder.file("new", content), file);
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

  ScratchFolder folder;
  fs::path program, shaders = folder.path / "shaders", scene = folder.path / "scene.glb";
  std::optional<Desk> desk;
};

TEST_F(DemoWatch, ABrokenSceneIsToldAndTheOldOneStays) {
  DemoRun run(*desk, words());
  stand_still(run);
  const Picture before = resting(run);
  const std::string whole = content_of(scene);
  replace(scene, whole.substr(0, whole.size() / 2));
  const auto broken = run.expect_event("scene");
  EXPECT_EQ(broken["event"], "watch");
  EXPECT_NE(broken["message"].get<std::string>().find("scene.glb: "), std::string::npos) << broken;
  EXPECT_EQ(resting(run).pixels, before.pixels);
  replace(scene, whole);
  EXPECT_EQ(run.expect_event("scene")["message"], "scene.glb");
  EXPECT_NE(resting(run).at({160, 90}), (std::array<uint8_t, 3>{})) << "it is drawn again";
  run.press("p", "pause");
  EXPECT_EQ(run.leave(), 0) << run.talk();
}

TEST_F(DemoWatch, ADamagedShaderIsToldAndTheOldOnesDraw) {
  DemoRun run(*desk, words());
  stand_still(run);
  const Picture before = resting(run);
  const fs::path sums = shaders / "sums.txt", shader = shaders / "tonemap.comp.spv";
  const std::string built = content_of(shader);
  replace(shader, built.substr(0, built.size() - 4));
  replace(sums, content_of(sums));
  const auto damaged = run.expect_event("shaders");
  EXPECT_NE(damaged["message"].get<std::string>().find("is not what was built"), std::string::npos)
      << damaged;
  EXPECT_EQ(resting(run).pixels, before.pixels);
  replace(shader, built);
  replace(sums, content_of(sums));
  EXPECT_EQ(run.expect_event("shaders")["message"], "other shaders");
  run.press("p", "pause");
  EXPECT_EQ(run.leave(), 0) << run.talk();
}

} // namespace
} // namespace unghost
