// Real models of other people, drawn. UNGHOST_MODELS names their folder.
#include <chrono>
#include <cstdlib>
#include <fstream>

#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

using Clock = std::chrono::steady_clock;

/// Two frames of the model alone: the second has whatever moves in motion.
void draw(Device& device, const DataFolders& data, const std::filesystem::path& file) {
  Staged staged = build_stage(file, data.assets / "asphalt.glb", {.stage = Stage::none});
  const RigContext context{.track_radius = staged.track_radius, .vehicle = staged.vehicle};
  Renderer renderer(device, data.shaders, std::move(staged.scene));
  for (int frame = 0; frame < 2; ++frame) {
    const Rig& rig = *find_rig("drive");
    const FrameInput input{.now = rig.at(context, frame * seconds_per_frame),
                           .before = rig.at(context, std::max(frame - 1, 0) * seconds_per_frame),
                           .index = uint64_t(frame),
                           .cut = frame == 0,
                           .width = 160,
                           .height = 90,
                           .modes = {run_of("grand-tour")},
                           .wanted = {{Output::resolved}}};
    const FrameResult result = renderer.render(input);
    for (const float value : result.delivered[0].image.values) ASSERT_TRUE(std::isfinite(value));
  }
}

TEST(ModelsDrawn, EveryValidOneIsDrawnInTenSecondsOrNamesTheExtensionItRequires) {
  const char* folder = std::getenv("UNGHOST_MODELS");
  if (folder == nullptr) GTEST_SKIP() << "UNGHOST_MODELS does not name a folder of models";
  std::ifstream index(std::filesystem::path(folder) / "index.json");
  Device device({.validate = true});
  const DataFolders data = find_data_folders();
  size_t drawn = 0, refused = 0;
  for (const nlohmann::json& model : nlohmann::json::parse(index)) {
    if (model.at("kind") != "valid") continue;
    SCOPED_TRACE(model.at("path").get<std::string>());
    const auto start = Clock::now();
    try {
      draw(device, data, std::filesystem::path(folder) / model.at("path").get<std::string>());
      ++drawn;
    } catch (const Failure& failure) {
      EXPECT_NE(std::string(failure.what()).find("/extensionsRequired"), std::string::npos) << failure.what();
      ++refused;
    }
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(10));
    EXPECT_EQ(device.validation_messages().size(), 0u) << device.validation_messages().front();
  }
  std::printf("%zu drawn, %zu require what is not there\n", drawn, refused);
  EXPECT_GT(drawn, 150u);
}

} // namespace
} // namespace unghost
