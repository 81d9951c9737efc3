// Shaders that change while a renderer has them.
#include <sstream>

#include "app/paths.h"
#include "app/rigs.h"
#include "app/stage.h"
#include "renderer/gpu/sha256.h"
#include "renderer/renderer.h"
#include "tests/app/child.h"
#include "tests/app/device_test.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class ShaderReload : public DeviceTest {
protected:
  void SetUp() override {
    DeviceTest::SetUp();
    if (IsSkipped()) return;
    fs::copy(data.shaders, shaders);
    device.emplace(DeviceRequest{.validate = true});
    Staged staged = build_stage(data.assets / "asphalt.glb", data.assets / "asphalt.glb", {});
    now = find_rig("drive")->at({.track_radius = staged.track_radius, .vehicle = staged.vehicle}, 0);
    renderer.emplace(*device, shaders, std::move(staged.scene));
    before = drawn();
  }
  void TearDown() override {
    if (!device) return;
    for (const std::string& message : device->validation_messages()) ADD_FAILURE() << message;
  }

  std::vector<uint8_t> drawn() {
    const FrameInput input{.now = now,
                           .before = now,
                           .cut = true,
                           .width = 64,
                           .height = 36,
                           .modes = {{"off", settings_for_mode("off").taa}},
                           .wanted = {{Output::display}}};
    return renderer->render(input).delivered[0].picture.rgba;
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(shaders / name, std::ios::binary) << content;
  }
  void write_built(const std::string& name, const std::string& content) const {
    write(name, content);
    std::istringstream lines(content_of(shaders / "sums.txt"));
    std::string sums;
    for (std::string sum, file; lines >> sum >> file;)
      sums += (file == name ? Sha256::hex(content) : sum) + "  " + file + "\n";
    write("sums.txt", sums);
  }
  std::string refusal() {
    try {
      renderer->reload_shaders();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "reloaded";
  }
  /// The tone map's, with a quarter of the light.
  std::string darker() const {
    std::string source = content_of(fs::path(UNGHOST_SHADER_SOURCES) / "tonemap.comp");
    const std::string exposure = "* frame.exposure";
    source.insert(source.find(exposure) + exposure.size(), " * 0.25");
    const fs::path changed = folder.file("tonemap.comp", source), spirv = folder.path / "tonemap.spv";
    EXPECT_EQ(exit_of({UNGHOST_GLSLANG, "-V", "--quiet", "--target-env", "vulkan1.2",
                       "-I" UNGHOST_SHADER_SOURCES, "-o", spirv.string(), changed.string()}),
              0);
    return content_of(spirv);
  }

  const std::string tone_map = "tonemap.comp.spv";
  const DataFolders data = find_data_folders();
  const fs::path shaders = folder.path / "shaders";
  std::optional<Device> device;
  std::optional<Renderer> renderer;
  Instant now;
  std::vector<uint8_t> before;
};

TEST_F(ShaderReload, OneThatIsNotWhatWasBuiltIsRefusedAndTheOldOnesDraw) {
  const std::string built = content_of(shaders / tone_map);
  std::string damaged = built;
  damaged[damaged.size() / 2] ^= 1;
  write(tone_map, damaged);
  EXPECT_NE(refusal().find("tonemap.comp.spv is not what was built"), std::string::npos) << refusal();
  EXPECT_EQ(drawn(), before);
  fs::remove(shaders / tone_map);
  EXPECT_NE(refusal().find("tonemap.comp.spv is missing"), std::string::npos) << refusal();
  EXPECT_EQ(drawn(), before);
  write_built(tone_map, "no SPIR-V, for all that it is what was built");
  EXPECT_NE(refusal().find("cannot be specialized"), std::string::npos) << refusal();
  EXPECT_EQ(drawn(), before);
  fs::remove(shaders / "sums.txt");
  EXPECT_NE(refusal().find("sums.txt is missing"), std::string::npos) << refusal();
  EXPECT_EQ(drawn(), before);
}

TEST_F(ShaderReload, AnotherOneDrawsAnotherPictureAndTheFirstOneTheFirst) {
  const std::string built = content_of(shaders / tone_map);
  write_built(tone_map, darker());
  EXPECT_EQ(drawn(), before) << "nobody has asked for it yet";
  EXPECT_EQ(refusal(), "reloaded");
  const std::vector<uint8_t> dark = drawn();
  ASSERT_EQ(dark.size(), before.size());
  for (size_t i = 0; i < dark.size(); ++i) ASSERT_LE(dark[i], before[i]) << i;
  EXPECT_NE(dark, before);
  write_built(tone_map, built);
  EXPECT_EQ(refusal(), "reloaded");
  EXPECT_EQ(drawn(), before);
}

TEST_F(ShaderReload, AfterItNoFrameReadsTheFolder) {
  EXPECT_EQ(refusal(), "reloaded");
  fs::remove_all(shaders);
  EXPECT_EQ(drawn(), before);
}

} // namespace
} // namespace unghost
