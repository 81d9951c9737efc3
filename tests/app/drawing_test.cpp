// Whole runs on a real device, small.
#include <cmath>
#include <map>
#include <sstream>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files.h"
#include "app/png_file.h"
#include "tests/app/device_test.h"
#include "tests/app/outcome.h"
#include "tests/app/triangle_model.h"

namespace unghost {
namespace {

using nlohmann::json;

class DrawingTest : public DeviceTest {
protected:
  std::string file(const std::string& name) const { return (folder.path / name).string(); }
  std::vector<uint8_t> bytes(const std::string& name) const { return read_file(file(name), 1 << 26); }

  /// Runs a small drawing; it must be done.
  Outcome draw(Words words) const {
    words.insert(words.end(), {"--size", "96x54"});
    const Outcome drawn = outcome(words);
    EXPECT_EQ(drawn.exit, 0) << drawn.err;
    return drawn;
  }
};

/// A file read back: every channel as floats, row by row.
struct Exr {
  int width = 0, height = 0;
  std::map<std::string, std::vector<float>> channels;
};

Exr read_exr(const std::string& path) {
  Imf::InputFile file(path.c_str());
  const Imath::Box2i window = file.header().dataWindow();
  Exr exr{
      .width = window.max.x - window.min.x + 1, .height = window.max.y - window.min.y + 1, .channels = {}};
  Imf::FrameBuffer frame;
  for (auto channel = file.header().channels().begin(); channel != file.header().channels().end();
       ++channel) {
    std::vector<float>& values = exr.channels[channel.name()];
    values.resize(size_t(exr.width) * size_t(exr.height));
    frame.insert(channel.name(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                            sizeof(float) * size_t(exr.width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return exr;
}

// The camera looks down the road: ground and car at a finite distance, and sky.
void expect_buffers(const Exr& exr) {
  EXPECT_EQ(exr.width, 96);
  EXPECT_EQ(exr.height, 54);
  std::vector<std::string> names;
  for (const auto& [name, values] : exr.channels) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"B", "G", "R", "Z", "motion.X", "motion.Y", "resolved.B",
                                             "resolved.G", "resolved.R", "tag"}));
  const std::vector<float>& depth = exr.channels.at("Z");
  for (const float metres : depth) ASSERT_GT(metres, 0);
  EXPECT_TRUE(std::isinf(depth.front()));
  EXPECT_LT(depth.back(), 100);
  EXPECT_GT(std::ranges::max(exr.channels.at("tag")), 0);
  for (const char* colour : {"R", "G", "B", "resolved.R", "resolved.G", "resolved.B"})
    for (const float value : exr.channels.at(colour))
      ASSERT_TRUE(value >= 0 && std::isfinite(value)) << colour;
}

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
  for (const char* name : {"s/00003.png", "s/00004.png"}) EXPECT_TRUE(is_png(bytes(name))) << name;
  for (const char* name : {"b/00003.exr", "b/00004.exr"}) expect_buffers(read_exr(file(name)));
  const Exr buffers = read_exr(file("b/00004.exr")), last = read_exr(file("last.exr"));
  EXPECT_EQ(last.channels.size(), 3u);
  for (const char* colour : {"R", "G", "B"})
    EXPECT_EQ(last.channels.at(colour), buffers.channels.at(std::string("resolved.") + colour)) << colour;
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

TEST_F(DrawingTest, APassCountsOnceAFrame) {
  const Outcome drawn =
      draw({"compare", "--frames", "3", "--modes", "all", "--timings", "-o", file("g.png")});
  const auto frames_of = [&](const std::string& pass) { // the number after the name, at a line's start
    const size_t place = drawn.err.find("\n" + pass + " ");
    return place == std::string::npos ? -1 : std::stoi(drawn.err.substr(place + pass.size() + 1));
  };
  EXPECT_EQ(frames_of("light"), 3) << drawn.err;
  EXPECT_EQ(frames_of("tone map"), 1) << drawn.err;
  std::istringstream lines(drawn.err);
  double sum = 0, whole = 0; // MiB, the last word of a line of the table
  for (std::string line; std::getline(lines, line);) {
    const double mib = std::atof(line.substr(line.find_last_of(' ') + 1).c_str());
    (line.starts_with("a frame") ? whole : sum) += mib;
  }
  EXPECT_GT(whole, 0) << drawn.err;
  EXPECT_LT(whole, sum) << "what is kept is another pass's in another frame\n" << drawn.err;
}

TEST_F(DrawingTest, ABenchSaysWhatEachModeAdds) {
  const Outcome run = draw({"bench", "--rounds", "3", "--modes", "off,gdk-clamp,dop32", "--json"});
  const json object = json::parse(run.out);
  EXPECT_EQ(object.at("rounds"), 3);
  EXPECT_GT(object.at("copy_ms").get<double>(), 0);
  EXPECT_EQ(object.at("rows").at(0).at("ms"), 0) << "off adds nothing";
  for (const size_t row : {1, 2}) {
    const json& one = object.at("rows").at(row);
    EXPECT_GT(one.at("resolve_ms").get<double>(), 0);
    EXPECT_GT(one.at("ms").get<double>(), one.at("resolve_ms").get<double>()) << "motion is part of it";
    EXPECT_LE(one.at("p05").get<double>(), one.at("p95").get<double>());
    EXPECT_GT(one.at("over_naive").get<double>(), 0);
    EXPECT_GT(one.at("over_copy").get<double>(), 0);
  }
  EXPECT_TRUE(object.at("rows").at(1).at("over_no_rejection").is_null());
}

TEST_F(DrawingTest, ABenchOfNothingIsZeroAndSharpeningCounts) {
  const json off = json::parse(draw({"bench", "--rounds", "2", "--modes", "off", "--json"}).out);
  EXPECT_EQ(off.at("rows").at(0).at("ms"), 0);
  const Outcome run =
      draw({"bench", "--rounds", "2", "--modes", "uncharted", "--set", "sharpen=2", "--timings", "--json"});
  EXPECT_NE(run.err.find("sharpen uncharted "), std::string::npos) << run.err;
  const json row = json::parse(run.out).at("rows").at(0);
  EXPECT_GT(row.at("over_no_rejection").get<double>(), 0);
}

TEST_F(DrawingTest, AxesOfASceneAreThoseOfItsSeed) {
  const auto found = [&](const char* seed) {
    return json::parse(
        draw({"axes", "--faces", "8", "--of-scene", "--frames", "9", "--seed", seed, "--json"}).out);
  };
  const json first = found("1");
  EXPECT_EQ(first, found("1"));
  EXPECT_NE(first.at("axes"), found("2").at("axes"));
  EXPECT_LT(first.at("tightness").at("found").get<double>(), first.at("tightness").at("xyz").get<double>());
}

TEST_F(DrawingTest, AModelThatIsASinglePointDraws) {
  json one_point = model({1, 1, 1}, {0, 0, 0});
  one_point["buffers"][0]["uri"] = "data:application/octet-stream;base64," + std::string(48, 'A');
  one_point["accessors"][0]["max"] = {0, 0, 0};
  const std::string point = folder.file("point.gltf", one_point.dump()).string();
  for (const char* stage : {"stage=asphalt", "stage=none"}) {
    const Outcome drawn = draw(
        {"capture", point, "--frames", "2", "--set", stage, "--buffers", file("b"), "-o", file("p.png")});
    EXPECT_NE(drawn.err.find("it has no size"), std::string::npos) << drawn.err;
    for (const auto& [name, values] : read_exr(file("b/00001.exr")).channels)
      for (const float value : values) ASSERT_FALSE(std::isnan(value)) << name << ", " << stage;
  }
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
