// Recordings that end by other means than their key, and disks that do not take them.
#include "tests/app/triangle_model.h"
#include "tests/window/recorded_demo.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class DemoPathEnd : public RecordedDemo {
protected:
  static constexpr uint64_t no_room = 100; // bytes; a recording of one frame is more

  /// Some frames, and goes on.
  static void record(DemoRun& run) {
    run.press("o", "recording");
    draw_more(run, 5);
  }

  static std::string said_of(DemoRun& run, const std::string& action) {
    return run.expect_event(action)["message"];
  }
  static void expect_in(const std::string& said, const std::string& part) {
    EXPECT_NE(said.find(part), std::string::npos) << "no '" << part << "' in '" << said << "'";
  }

  fs::path other_scene() const { return folder.file("other.glb", glb(model({4, 3, 5}, {0, 0, 0}))); }
  static fs::path own() { return fs::canonical(folder_of_this_program() / "assets" / "asphalt.glb"); }
  static void drop(DemoRun& run, const fs::path& scene) {
    run.window().drop({scene});
    expect_in(said_of(run, "scene"), scene.filename());
  }

  std::string frames_of(const std::string& path) const {
    const json recording = json::parse(content_of(folder.path / path));
    return std::to_string(recording["frames"].size()) + " frames";
  }
  /// Whole: without a window it gives the picture that the window had.
  void expect_whole(const std::string& path) const {
    EXPECT_EQ(without_window({"capture", "--replay", path, "-o", "replayed.png"}), 0);
    expect_same("replayed.png", "unghost-1.png");
  }
};

TEST_F(DemoPathEnd, AnotherSceneEndsItAndAReplayBringsItsOwnBack) {
  configure({{"rig", "drive"}, {"shown", "blend"}});
  DemoRun run = started();
  record(run);
  pause(run);
  run.window().drop({other_scene()});
  const std::string said = said_of(run, "recorded");
  expect_in(said, "unghost-path-1.json: " + frames_of("unghost-path-1.json") + " (another scene)");
  run.expect_event("scene");
  run.press("p", "pause");
  draw_more(run, 3); // of the other scene
  EXPECT_FALSE(fs::exists(folder.path / "unghost-path-2.json"));
  run.press("shift+o", "replay");
  expect_in(said_of(run, "replayed"), "replayed " + frames_of("unghost-path-1.json"));
  take(run, "unghost-2.png");
  expect_same("unghost-2.png", "unghost-1.png");
  expect_left_in_silence(run);
  expect_whole("unghost-path-1.json");
}

TEST_F(DemoPathEnd, AReplayWhoseSceneIsGoneIsRefusedAndTheShownOneGoesOn) {
  DemoRun run = started();
  const fs::path other = other_scene();
  drop(run, other);
  record(run);
  run.window().press("o");
  run.expect_event("recorded");
  drop(run, own());
  run.press("p", "pause");
  const Picture before = later_picture(run);
  fs::remove(other);
  run.press("shift+o", "replay");
  expect_in(said_of(run, "refused"), "other.glb");
  EXPECT_EQ(later_picture(run).pixels, before.pixels);
  run.press("p", "pause");
  draw_more(run, 3);
  expect_left_in_silence(run);
}

TEST_F(DemoPathEnd, AnotherStageEndsIt) {
  configure({{"rig", "drive"}, {"shown", "blend"}, {"settings", {{"model-yaw", 90}}}});
  DemoRun run = started(small, {other_scene()});
  record(run);
  pause(run);
  run.press("shift+Delete", "everything"); // the stage among it
  const std::string said = said_of(run, "recorded");
  expect_in(said, "unghost-path-1.json: " + frames_of("unghost-path-1.json") + " (another stage)");
  EXPECT_EQ(run.expect_event("scene")["event"], "stage");
  run.press("shift+o", "replay"); // which brings that stage back
  EXPECT_EQ(run.expect_event("replayed")["state"]["settings"]["model-yaw"], 90);
  expect_left_in_silence(run);
  expect_whole("unghost-path-1.json");
}

TEST_F(DemoPathEnd, AnInterruptWritesItAsEscapeDoes) {
  DemoRun run = started();
  record(run);
  pause(run);
  run.interrupt();
  EXPECT_EQ(run.ended(), 128 + SIGINT);
  EXPECT_EQ(run.talk(), "unghost: interrupted\n");
  expect_whole("unghost-path-1.json");
}

TEST_F(DemoPathEnd, AnInterruptSaysWhatItCannotWrite) {
  DemoRun run = started();
  record(run);
  run.limit_files(no_room);
  run.interrupt();
  EXPECT_EQ(run.ended(), 128 + SIGINT);
  // and so much more that the file of what it says is full, too
  expect_in(run.talk(), "unghost: cannot write unghost-path-1.json: File too large; cannot write ");
  EXPECT_FALSE(fs::exists(folder.path / "unghost-path-1.json"));
}

TEST_F(DemoPathEnd, AFullDiskIsToldAndTheRecordingGoesOn) {
  DemoRun run = started();
  record(run);
  run.limit_files(no_room);
  run.window().press("o");
  const std::string said = said_of(run, "recorded");
  EXPECT_EQ(said, "cannot write unghost-path-1.json: File too large");
  EXPECT_EQ(folder.count(), 0u);
  draw_more(run, 5);
  run.limit_files({});
  EXPECT_EQ(end(run), "unghost-path-1.json");
  expect_left_in_silence(run);
  expect_whole("unghost-path-1.json"); // from its first frame to its last
}

TEST_F(DemoPathEnd, OneThatCouldNotBeWrittenWhereItEndedCanBeAskedForAgain) {
  DemoRun run = started();
  record(run);
  pause(run);
  const fs::path other = other_scene();
  run.limit_files(no_room);
  run.window().drop({other});
  expect_in(said_of(run, "recorded"), "cannot write unghost-path-1.json: File too large (another scene)");
  run.expect_event("scene");
  run.press("p", "pause");
  draw_more(run, 3); // which are no part of it
  run.limit_files({});
  run.window().press("o");
  const std::string said = said_of(run, "recorded");
  EXPECT_EQ(said, "unghost-path-1.json: " + frames_of("unghost-path-1.json") + " (another scene)");
  expect_left_in_silence(run);
  expect_whole("unghost-path-1.json");
}

TEST_F(DemoPathEnd, WhoLeavesIsHeldUpOnceWhereItWouldBeLost) {
  DemoRun run = started();
  record(run);
  pause(run);
  run.limit_files(no_room);
  run.window().press("Escape");
  EXPECT_EQ(said_of(run, "recorded"), "cannot write unghost-path-1.json: File too large");
  let_frames_pass(run);
  run.limit_files({});
  expect_left_in_silence(run);
  expect_whole("unghost-path-1.json");
}

TEST_F(DemoPathEnd, WhoLeavesAgainLosesItWithASentence) {
  DemoRun run = started();
  record(run);
  run.limit_files(no_room);
  run.window().press("Escape");
  run.expect_event("recorded");
  EXPECT_EQ(run.leave(), 1);
  EXPECT_TRUE(run.talk().starts_with("unghost: cannot write unghost-path-1.json: File too large"))
      << run.talk();
  EXPECT_FALSE(fs::exists(folder.path / "unghost-path-1.json"));
}

} // namespace
} // namespace unghost
