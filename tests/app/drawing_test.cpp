// Whole runs on a real device, small.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files.h"
#include "renderer/gpu/device.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

class DrawingTest : public testing::Test {
protected:
  void SetUp() override {
    try {
      for (const DeviceFacts& device : list_devices())
        if (device.usable) return;
    } catch (const GpuError& error) {
      GTEST_SKIP() << error.what();
    }
    GTEST_SKIP() << "no usable Vulkan device";
  }

  std::string file(const std::string& name) const { return (folder.path / name).string(); }
  std::vector<uint8_t> bytes(const std::string& name) const { return read_file(file(name), 1 << 26); }

  /// Runs a small drawing; it must be done.
  Outcome draw(Words words) const {
    words.insert(words.end(), {"--size", "96x54"});
    const Outcome drawn = outcome(words);
    EXPECT_EQ(drawn.exit, 0) << drawn.err;
    return drawn;
  }

  ScratchFolder folder;
};

TEST_F(DrawingTest, TheSameWordsAndThePicturesOwnGiveTheSameBytes) {
  const Words words = {"capture", "--frames", "4",     "--rig",     "rotate",
                       "--seed",  "3",        "--set", "alpha=0.2", "-q"};
  const auto with = [](Words all, const Words& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  draw(with(words, {"-o", file("a.png")}));
  draw(with(words, {"-o", file("b.png")}));
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
  EXPECT_EQ(outcome(Words{"capture", "--settings", file("a.png"), "-o", file("c.png"), "-q"}).exit, 0);
  EXPECT_EQ(bytes("a.png"), bytes("c.png"));
  const Outcome piped = draw(with(words, {"-o", "-"}));
  EXPECT_EQ(std::vector<uint8_t>(piped.out.begin(), piped.out.end()), bytes("a.png"));
}

TEST_F(DrawingTest, CaptureWritesSequencesAndBuffersAndSaysWhatItDid) {
  const Outcome drawn = draw({"capture", "--frames", "5", "--from", "3", "--sequence", file("s"), "--buffers",
                              file("b"), "-o", file("last.exr"), "--json", "--timings"});
  for (const char* name : {"s/00003.png", "s/00004.png", "b/00003.exr", "b/00004.exr", "last.exr"})
    EXPECT_GT(bytes(name).size(), 1000u) << name;
  EXPECT_FALSE(std::filesystem::exists(file("s/00002.png")));
  EXPECT_FALSE(std::filesystem::exists(file("s/00005.png")));
  const json said = json::parse(drawn.out);
  EXPECT_EQ(said.at("frames"), 5);
  EXPECT_EQ(said.at("size"), "96x54");
  EXPECT_EQ(said.at("file"), file("last.exr"));
  EXPECT_GT(said.at("passes").size(), 3u);
  EXPECT_GT(said.at("wall_s").get<double>(), 0);
  for (const char* key : {"mode", "rig", "seed", "device", "software", "settings"})
    EXPECT_TRUE(said.contains(key)) << key;
  EXPECT_NE(drawn.err.find("images MiB"), std::string::npos);
}

TEST_F(DrawingTest, QuietSaysNothing) {
  EXPECT_EQ(draw({"capture", "--frames", "1", "-o", file("a.png"), "-q"}).err, "");
}

TEST_F(DrawingTest, ComparisonsSayWhereTheModesDiffer) {
  const Outcome drawn =
      draw({"compare", "--frames", "6", "--modes", "blend,uncharted", "-o", file("g.png"), "--json"});
  const json said = json::parse(drawn.out);
  EXPECT_EQ(said.at("windows").size(), 2u);
  EXPECT_EQ(said.at("modes").size(), 2u);
  EXPECT_EQ(outcome(Words{"compare", "--settings", file("g.png"), "-o", file("h.png"), "-q"}).exit, 0);
  EXPECT_EQ(bytes("g.png"), bytes("h.png"));
}

TEST_F(DrawingTest, AnotherSeedIsAnotherPicture) {
  draw({"capture", "--frames", "2", "-q", "--seed", "2", "-o", file("a.png")});
  draw({"capture", "--frames", "2", "-q", "--seed", "3", "-o", file("b.png")});
  EXPECT_NE(bytes("a.png"), bytes("b.png"));
}

TEST_F(DrawingTest, RefusalsHaveTheirExitCodesAndLeaveNothing) {
  EXPECT_EQ(outcome(Words{"capture", "/nowhere.glb", "-o", file("a.png")}).exit, 3);
  EXPECT_EQ(outcome(Words{"capture", "-o", file("a.png"), "--set", "stage=none"}).exit, 2);
  EXPECT_EQ(outcome(Words{"capture", "-o", file("a.png"), "--device", "no such device"}).exit, 4);
  EXPECT_EQ(folder.count(), 0u);
}

} // namespace
} // namespace unghost
