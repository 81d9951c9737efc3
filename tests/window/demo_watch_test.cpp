// The demo with --watch: files that change under it.
#include "tests/window/watched_demo.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class DemoWatch : public WatchedDemo {
protected:
  void SetUp() override {
    WatchedDemo::SetUp();
    if (!IsSkipped()) fs::copy(folder_of_this_program() / "shaders", shaders);
  }
};

TEST_F(DemoWatch, ABrokenSceneIsToldAndTheOldOneStays) {
  DemoRun run(*desk, watching("blend", "drive"));
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
  DemoRun run(*desk, watching("blend", "drive"));
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

TEST_F(DemoWatch, AProgramThatWasCopiedWatchesCompiledShadersAndSaysSo) {
  DemoRun run(*desk, watching("blend", "drive"));
  EXPECT_EQ(run.leave(), 0);
  EXPECT_EQ(run.talk(),
            "--watch: the program is not where it was built, and watches compiled shaders only\n");
}

} // namespace
} // namespace unghost
