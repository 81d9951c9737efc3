// Files dropped on the real demo's window, as a file manager drops them.
#include "tests/app/triangle_model.h"
#include "tests/window/driven_demo.h"
#include "tests/window/file_drop.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class DemoDrops : public DrivenDemo {
protected:
  static std::string message_of(const nlohmann::json& event) {
    EXPECT_EQ(event["event"], "drop");
    return event["message"];
  }
  static void stand_still(DemoRun& run) {
    run.press("u", "only the picture");
    run.press("p", "pause");
  }
};

TEST(UriList, IsWhatFileManagersSend) {
  EXPECT_EQ(uri_list({"/a b/\xc3\xa4%41.glb", "/c-d_e.~1"}),
            "file:///a%20b/%C3%A4%2541.glb\r\nfile:///c-d_e.~1\r\n");
}

TEST_F(DemoDrops, ASceneIsDrawnInPlaceOfTheOneThatWasThere) {
  configure({{"rig", "still"}, {"shown", "off"}});
  const fs::path scene = folder.file("my car \xc3\xa4 %41.glb", glb(model({4, 3, 5}, {0, 0, 0})));
  const fs::path picture = folder.file("beside it.png", "no picture, and nobody asked for it");
  DemoRun run = started();
  stand_still(run);
  const Picture before = later_picture(run);
  run.window().drop({picture, scene});
  EXPECT_EQ(message_of(run.expect_event("scene")), scene.filename());
  EXPECT_TRUE(comes_to_differ(run, before, 0.02));
  run.window().drop({fs::canonical(folder_of_this_program() / "assets" / "asphalt.glb")});
  EXPECT_EQ(message_of(run.expect_event("scene")), "asphalt.glb");
  EXPECT_TRUE(comes_back(run, before));
  expect_left_in_silence(run);
}

TEST_F(DemoDrops, WhatShapedAModelIsNotKeptForASceneThatItDoesNotShape) {
  const fs::path scene = folder.file("car.glb", glb(model({4, 3, 5}, {0, 0, 0})));
  configure({{"settings", {{"model-yaw", 90}, {"speed", 0.5}}}});
  {
    DemoRun run = started(small, {scene});
    EXPECT_EQ(asked(run)["state"]["settings"]["model-yaw"], 90);
    expect_left_in_silence(run);
  }
  DemoRun run = started();
  EXPECT_EQ(asked(run)["state"]["settings"], nlohmann::json({{"speed", 0.5}}));
  expect_left_in_silence(run);
}

TEST_F(DemoDrops, WhatIsNoSceneIsToldAndTheOldOneGoesOn) {
  configure({{"rig", "still"}, {"shown", "off"}});
  DemoRun run = started();
  stand_still(run);
  const Picture before = later_picture(run);
  const std::string whole = glb(model({4, 3, 5}, {0, 0, 0}));
  const fs::path half = folder.file("half.glb", whole.substr(0, whole.size() / 2)),
                 text = folder.file("letter.txt", "Dear all,");
  for (const fs::path& bad : {half, text, folder.path / "gone.glb", folder.path}) {
    run.window().drop({bad});
    const std::string message = message_of(run.expect_event("scene"));
    EXPECT_TRUE(message.starts_with(bad.string() + ": ")) << message;
    EXPECT_EQ(later_picture(run).pixels, before.pixels) << message;
  }
  const uint64_t drawn = run.press("p", "pause")["drawn"];
  EXPECT_TRUE(comes_true([&] { return run.press("Tab", "movement")["drawn"] > drawn; }));
  expect_left_in_silence(run);
}

} // namespace
} // namespace unghost
