// Real models of other people, drawn. UNGHOST_MODELS names their folder.
#include <cstdlib>
#include <ctime>
#include <fstream>

#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "renderer/scene/bounds.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

/// The pixels that the model covers in a small picture of two instants.
long covered_pixels(Renderer& renderer, const Instant& now, const Instant& before, bool cut) {
  const FrameInput input{.now = now,
                         .before = before,
                         .cut = cut,
                         .width = 160,
                         .height = 90,
                         .modes = {run_of("off")}, // what is resolved of it is proven elsewhere
                         .wanted = {{Output::resolved}, {Output::object}, {Output::motion}}};
  const FrameResult result = renderer.render(input);
  EXPECT_TRUE(std::ranges::all_of(result.delivered[0].image.values,
                                  [](float value) { return std::isfinite(value); }));
  return std::ranges::count_if(result.delivered[1].image.values, [](float node) { return node > 0; });
}

/// Two frames of the model alone: the second has whatever moves in motion. A pane with one side is looked at
/// from all round. Returns whether any of it is to be seen, or nothing where it has no geometry.
std::optional<bool> draw(Device& device, const DataFolders& data, const std::filesystem::path& file) {
  Staged staged = build_stage(file, data.assets / "asphalt.glb", {.stage = Stage::none});
  const bool has_geometry = !scene_bounds(staged.scene).empty();
  const RigContext context{.track_radius = staged.track_radius, .vehicle = staged.vehicle};
  Renderer renderer(device, data.shaders, std::move(staged.scene));
  const Rig &drive = *find_rig("drive"), &rotate = *find_rig("rotate");
  const Instant first = drive.at(context, 0), second = drive.at(context, seconds_per_frame);
  bool seen = covered_pixels(renderer, first, first, true) > 0;
  seen = covered_pixels(renderer, second, first, false) > 0 || seen;
  for (double time_s = 0; has_geometry && !seen && time_s < 6; time_s += 1.5) {
    const Instant around = rotate.at(context, time_s);
    seen = covered_pixels(renderer, around, around, true) > 0;
  }
  return has_geometry ? std::optional(seen) : std::nullopt;
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
    const std::clock_t start = std::clock();
    try {
      const auto seen =
          draw(device, data, std::filesystem::path(folder) / model.at("path").get<std::string>());
      // Two skins each that share joints or matrices: not seen, and why is not known yet.
      const std::string name = std::filesystem::path(model.at("path").get<std::string>()).stem().string();
      const bool open_question = name == "Instancing_08" || name == "Instancing_09";
      EXPECT_TRUE(open_question || seen.value_or(true)) << "none of it is to be seen";
      ++drawn;
    } catch (const Failure& failure) {
      EXPECT_NE(std::string(failure.what()).find("/extensionsRequired"), std::string::npos) << failure.what();
      ++refused;
    }
    // of processor time, so that other work on the machine decides nothing
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 10);
    EXPECT_EQ(device.validation_messages().size(), 0u) << device.validation_messages().front();
  }
  std::printf("%zu drawn, %zu require what is not there\n", drawn, refused);
  EXPECT_GT(drawn, 150u);
}

} // namespace
} // namespace unghost
