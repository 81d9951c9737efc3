// `unghost explain`: on a device, small; and what a frame's parts come to, of frames that are made up.
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/measure/frame_parts.h"
#include "app/measure/quantile.h"
#include "tests/app/device_test.h"
#include "tests/app/outcome.h"
#include "tests/app/triangle_model.h"

namespace unghost {
namespace {

using nlohmann::json;

/// Where everything is kept there are two passes more, and a longer one; without the short pass that is gone.
FrameResult made_up(const FrameInput& input) {
  const auto pass = [](const char* name, double ms, uint32_t constant) {
    return PassReport{.name = name, .ms = ms, .pipelines = {{.shader = name, .constants = {constant}}}};
  };
  FrameResult result;
  const bool all = input.settings.keep_all;
  const double slower = double(input.index % 2); // noise that no thing left out may be blamed for
  result.passes.push_back(pass("light", 10 + slower, 0));
  result.passes.push_back(all && input.left_out != "dilation" ? pass("taa", 7, 1) : pass("taa", 5, 0));
  if (all && input.left_out != "sharpen") result.passes.push_back(pass("sharpen", 3, 0));
  result.image_bytes = all ? (input.left_out == "sharpen" ? 60 : 100) : 40;
  if (!all) result.left_out = {{"sharpen", "sharpen is 0"}, {"dilation", "this row has none"}};
  return result;
}

TEST(FrameParts, AreSavedByWhatDiffersAlone) {
  uint64_t drawn = 0, kept = 0;
  const Film film{.at = [](uint32_t frame) { return FrameInput{.index = frame}; },
                  .draw =
                      [&](const FrameInput& input) {
                        FrameInput other = input;
                        kept += input.settings.keep_all;
                        other.index = ++drawn;
                        return made_up(other);
                      }};
  const FrameParts parts = take_apart(film, {.name = "off"}, 3, 4);
  ASSERT_EQ(parts.savings.size(), 2u);
  EXPECT_EQ(parts.savings[0].thing.what, "sharpen");
  EXPECT_EQ(parts.savings[0].bytes, 40);
  EXPECT_EQ(parts.savings[0].ms, std::vector<double>(4, 3.0));
  EXPECT_EQ(parts.savings[1].bytes, 0);
  EXPECT_EQ(parts.savings[1].ms, std::vector<double>(4, 2.0));
  EXPECT_EQ(parts.frame_ms.size(), 4u);
  EXPECT_EQ(parts.pass_ms.at(1), std::vector<double>(4, 5.0));
  EXPECT_EQ(kept, 3 + 4 * 2) << "a pass that is missing is not drawn to be timed";
}

class Explain : public DeviceTest {
protected:
  /// An unlit triangle by itself, small.
  Outcome explain(const Words& more) const {
    json unlit = model({1, 1, 1}, {0, 0, 0});
    unlit["extensionsUsed"] = {"KHR_materials_unlit"};
    unlit["materials"] = {{{"doubleSided", true}, {"extensions", {{"KHR_materials_unlit", json::object()}}}}};
    unlit["meshes"][0]["primitives"][0]["material"] = 0;
    const std::filesystem::path file = folder.file("triangle.gltf", unlit.dump());
    Words words{"explain", file.string(), "--set", "stage=none", "--size",
                "96x54",   "--frames",    "2",     "--rounds",   "1"};
    words.insert(words.end(), more.begin(), more.end());
    return outcome(words);
  }
};

TEST_F(Explain, SaysWhatAFrameIsMadeOfAndWithout) {
  const Outcome run = explain({"--mode", "gdk-clamp", "--rig", "still", "--json"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const json object = json::parse(run.out);
  uint64_t bytes = 0;
  for (const json& image : object.at("images")) bytes += image.at("bytes").get<uint64_t>();
  EXPECT_EQ(object.at("total_bytes"), bytes) << "each image once";
  EXPECT_LT(bytes, object.at("everything_bytes").get<uint64_t>());
  EXPECT_GT(object.at("total_ms").get<double>(), 0);
  EXPECT_EQ(object.at("draws"), 1);
  std::vector<std::string> passes;
  for (const json& pass : object.at("passes")) passes.push_back(pass.at("name"));
  EXPECT_EQ(passes, (std::vector<std::string>{"g-buffer", "light", "taa gdk-clamp", "tone map"}));
  EXPECT_GT(object.at("passes")[2].at("pipelines")[0].at("fetches").get<int>(), 1);
  bool found = false;
  for (const json& thing : object.at("left_out")) {
    EXPECT_FALSE(thing.at("why").get<std::string>().empty());
    EXPECT_TRUE(thing.at("bytes").is_number() && thing.at("ms").is_number());
    found = found ||
            (thing.at("what") == "sharpen" && thing.at("why") == "sharpen is 0" && thing.at("bytes") > 0);
  }
  EXPECT_TRUE(found);
  EXPECT_EQ(object.at("stillness"), (json{{"skippable", true}, {"after_frames", 64}}));
}

TEST_F(Explain, IsReadableInAHundredColumns) {
  const Outcome run = explain({"--rig", "rotate", "--mode", "dop32"});
  ASSERT_EQ(run.exit, 0) << run.err;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  EXPECT_NE(run.out.find("no frame can be skipped: the camera moves"), std::string::npos);
}

TEST_F(Explain, KeepsEverythingByItself) {
  const Outcome run = outcome({"explain", "--set", "keep-all=1"});
  EXPECT_EQ(run.exit, 2);
  EXPECT_NE(run.err.find("keep-all is not for it"), std::string::npos);
  EXPECT_EQ(outcome({"capture", "--set", "keep-all=0.5", "-o", "x.png"}).exit, 2);
}

} // namespace
} // namespace unghost
