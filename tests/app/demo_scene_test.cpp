#include "app/demo/demo_scene.h"

#include <sys/stat.h>

#include "app/failure.h"
#include "tests/app/device_test.h"
#include "tests/app/triangle_model.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class DemoSceneTest : public DeviceTest {
protected:
  void TearDown() override {
    if (!device) return;
    for (const std::string& message : device->validation_messages()) ADD_FAILURE() << message;
  }

  DemoScene load(const fs::path& file) {
    if (!device) device.emplace(DeviceRequest{.validate = true});
    DemoState state = default_demo_state();
    state.scene = file.string();
    return load_demo_scene(*device, state);
  }
  /// Why it is not loaded, or "loaded".
  std::string fault(const fs::path& file) {
    return fault_of([&] { load(file); }).value_or("loaded");
  }
  static Image drawn(const DemoScene& scene, int frame) {
    const Rig& rig = *find_rig("drive");
    const auto at = [&](int index) { return rig.at(scene.context, index * seconds_per_frame); };
    FrameInput input{.now = at(frame), .before = at(std::max(frame - 1, 0)), .index = uint64_t(frame)};
    input.cut = frame == 0;
    input.width = 64, input.height = 36;
    input.modes = {{"blend", settings_for_mode("blend").taa}};
    input.wanted = {{Output::display}};
    return scene.renderer->render(input).delivered[0].picture;
  }

  std::optional<Device> device;
};

TEST_F(DemoSceneTest, AModelDrivesOnTheAsphalt) {
  const DemoScene scene = load(folder.file("model.gltf", model({2, 1, 4}, {0, 0, 0}).dump()));
  EXPECT_GE(scene.renderer->scene().vehicle, 0);
  EXPECT_GT(scene.renderer->scene().nodes.size(), 3u); // the road is there
  EXPECT_EQ(scene.context.vehicle.high.z, 2);
}

TEST_F(DemoSceneTest, WhatIsNoSceneIsRefusedInASentence) {
  const fs::path fifo = folder.path / "fifo.glb";
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  fs::create_directory(folder.path / "folder.glb");
  EXPECT_NE(fault(fifo).find("fifo.glb: is not a regular file"), std::string::npos) << fault(fifo);
  const fs::path nested = folder.path / "folder.glb";
  EXPECT_NE(fault(nested).find("folder.glb: is not a regular file"), std::string::npos) << fault(nested);
  const fs::path none = folder.path / "none.glb";
  EXPECT_NE(fault(none).find("none.glb: cannot be opened"), std::string::npos) << fault(none);
  const fs::path broken = folder.file("broken.glb", "glTF, but not for long");
  EXPECT_NE(fault(broken).find("broken.glb: "), std::string::npos) << fault(broken);
  EXPECT_NE(fault(folder.path / "\xff.glb").find("UTF-8"), std::string::npos);
}

TEST_F(DemoSceneTest, WhatIsShownGoesOnWithItsHistoryAfterAFault) {
  const fs::path file = folder.file("model.gltf", model({2, 1, 4}, {0, 0, 0}).dump());
  const DemoScene scene = load(file), undisturbed = load(file);
  for (int frame = 0; frame < 2; ++frame) drawn(scene, frame), drawn(undisturbed, frame);
  EXPECT_NE(fault(folder.file("broken.glb", "glTF")), "loaded");
  const Image picture = drawn(scene, 2), expected = drawn(undisturbed, 2);
  EXPECT_EQ(picture.rgba, expected.rgba);
}

TEST_F(DemoSceneTest, AllFilesOfASceneAreWatched) {
  nlohmann::json content = model({2, 1, 4}, {0, 0, 0});
  content["buffers"][0]["uri"] = "points.bin";
  folder.file("points.bin", std::string(36, '\1'));
  DemoScene scene = load(folder.file("model.gltf", content.dump()));
  FileWatch::Time now{1h};
  EXPECT_FALSE(scene.files.changed(now += 1s));
  folder.file("points.bin", std::string(36, '\2'));
  EXPECT_FALSE(scene.files.changed(now += 1s));
  EXPECT_TRUE(scene.files.changed(now += 1s));
}

TEST(DemoDrop, TheSceneIsAmongItsPictures) {
  EXPECT_EQ(scene_among({"/a/b.png", "/a/c.GLTF", "/a/d.glb"}), "/a/c.GLTF");
  EXPECT_EQ(scene_among({"/a/b.png", "/a/c.bin"}), "/a/b.png");
  EXPECT_EQ(short_name("/a/b.glb"), "b.glb");
  EXPECT_EQ(short_name("/a/b/"), "b");
}

TEST(DemoDrop, OnlyALostDeviceIsThrownOn) {
  EXPECT_EQ(fault_of([] {}), std::nullopt);
  EXPECT_EQ(fault_of([] { throw Failure(Exit::input_refused, "no"); }), "no");
  EXPECT_EQ(fault_of([] { throw GpuError(GpuFault::out_of_memory, "full"); }), "full");
  EXPECT_EQ(fault_of([] { throw std::bad_alloc(); }), "out of memory; something smaller may do");
  EXPECT_THROW(fault_of([] { throw GpuError(GpuFault::lost, "lost"); }), GpuError);
}

} // namespace
} // namespace unghost
