// `unghost flip`, and FLIP against what its authors' own program says of all pairs in the folder that
// UNGHOST_FLIP names.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/files.h"
#include "app/measure/flip.h"
#include "app/measure/magma.h"
#include "app/picture_input.h"
#include "app/png_file.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"
#include "tests/flat_picture.h"

namespace unghost {
namespace {

TEST(FlipCommand, SaysFiguresAndDrawsAMap) {
  const ScratchFolder folder;
  const auto file = [&](const char* name) { return (folder.path / name).string(); };
  write_file(file("a.png"), encode_png(picture_of(30, 20, {128, 128, 128}), "{}"));
  write_file(file("b.png"), encode_png(picture_of(30, 20, {138, 138, 138}), "{}"));
  write_file(file("c.png"), encode_png(picture_of(20, 30, {138, 138, 138}), "{}"));
  const Outcome run = outcome({"flip", file("a.png"), file("b.png"), "-o", file("map.png"), "--json"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const nlohmann::json object = nlohmann::json::parse(run.out);
  EXPECT_NEAR(object.at("mean").get<double>(), 0.14901, 1e-4);
  EXPECT_EQ(object.at("width"), 30);
  EXPECT_EQ(read_picture(file("map.png")).image.width, 30u);
  const Outcome sizes = outcome({"flip", file("a.png"), file("c.png")});
  EXPECT_EQ(sizes.exit, 3);
  EXPECT_NE(sizes.err.find("30x20"), std::string::npos) << sizes.err;
  EXPECT_EQ(outcome({"flip", file("a.png")}).exit, 2);
  EXPECT_EQ(outcome({"flip", file("a.png"), file("none.png")}).exit, 3);
  EXPECT_EQ(outcome({"flip", file("a.png"), file("b.png"), "--ppd", "nan"}).exit, 2);
  EXPECT_EQ(outcome({"flip", file("a.png"), file("b.png"), "--exposures", "4"}).exit, 2);
}

TEST(FlipCommand, SaysHowLongItTakes) {
  const ScratchFolder folder;
  const auto file = [&](const char* name) { return (folder.path / name).string(); };
  write_file(file("a.png"), encode_png(picture_of(30, 40, {128, 128, 128}), "{}"));
  write_file(file("b.png"), encode_png(picture_of(30, 40, {138, 138, 138}), "{}"));
  const auto flip_with = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"flip", file("a.png"), file("b.png")});
    return outcome(words);
  };
  const Outcome run = flip_with({"--rounds", "5", "--threads", "2", "--json"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const nlohmann::json timed = nlohmann::json::parse(run.out);
  EXPECT_EQ(timed.at("rounds"), 5);
  EXPECT_EQ(timed.at("threads"), 2);
  EXPECT_GT(timed.at("best_ms").get<double>(), 0);
  EXPECT_GE(timed.at("median_ms"), timed.at("best_ms"));
  EXPECT_EQ(run.err, "");
  nlohmann::json figures = nlohmann::json::parse(flip_with({"--json"}).out), rest = timed;
  for (const char* name : {"rounds", "threads", "best_ms", "median_ms"}) rest.erase(name);
  EXPECT_EQ(figures, rest);
  const nlohmann::json all = nlohmann::json::parse(flip_with({"--rounds", "1", "--json"}).out);
  EXPECT_EQ(all.at("threads"), threads_of(0));
  EXPECT_NE(flip_with({"--rounds", "3", "--threads", "1"}).err.find("3 rounds, on 1 thread;"),
            std::string::npos);
  EXPECT_EQ(flip_with({"--rounds", "3", "--quiet"}).err, "");
  for (const auto& [option, value] : {std::pair{"--rounds", "0"},
                                      {"--rounds", "10001"},
                                      {"--rounds", "x"},
                                      {"--threads", "-1"},
                                      {"--threads", "257"}})
    EXPECT_EQ(flip_with({option, value}).exit, 2) << option << " " << value;
}

class FlipGroundTruth : public testing::Test {
protected:
  void SetUp() override {
    const char* name = std::getenv("UNGHOST_FLIP");
    if (name == nullptr) GTEST_SKIP() << "UNGHOST_FLIP does not name a folder of pairs with their errors";
    folder = name;
  }
  FloatImage read(const nlohmann::json& name) const {
    return read_picture(folder / name.get<std::string>()).image;
  }
  FloatImage error_of(const nlohmann::json& one) const {
    const FloatImage reference = read(one.at("reference")), test = read(one.at("test"));
    const FlipOptions options{.pixels_per_degree = one.at("ppd").get<double>()};
    if (one.at("kind") == "LDR-FLIP") return flip(reference, test, options);
    const std::string mapper = one.at("tonemapper").get<std::string>();
    const ToneMapper tone = mapper == "hable"      ? ToneMapper::hable
                            : mapper == "reinhard" ? ToneMapper::reinhard
                                                   : ToneMapper::aces;
    const Exposures given{one.at("start_exposure").get<double>(), one.at("stop_exposure").get<double>(),
                          one.at("num_exposures").get<uint32_t>()};
    const Exposures found = exposures_of(reference, tone);
    const bool asked = one.at("name").get<std::string>().find("_-4_2_5") != std::string::npos;
    if (!asked) {
      EXPECT_NEAR(found.first, given.first, 1e-5);
      EXPECT_NEAR(found.last, given.last, 1e-5);
      EXPECT_EQ(found.count, given.count);
    }
    return hdr_flip(reference, test, given, tone, options).error;
  }
  std::filesystem::path folder;
};

TEST_F(FlipGroundTruth, EveryPairIsWithinItsTolerance) {
  const auto cases = nlohmann::json::parse(std::ifstream(folder / "expected.json")).at("cases");
  ASSERT_GT(cases.size(), 10u);
  for (const nlohmann::json& one : cases) {
    const std::string name = one.at("name").get<std::string>();
    const std::vector<float> errors = error_of(one).values;
    const std::vector<uint8_t> bytes =
        read_file(folder / one.at("error_map_f32").get<std::string>(), 1 << 26);
    ASSERT_EQ(bytes.size(), errors.size() * sizeof(float)) << name;
    std::vector<float> expected(errors.size());
    std::memcpy(expected.data(), bytes.data(), bytes.size());
    double most = 0;
    for (size_t i = 0; i < errors.size(); ++i)
      most = std::max(most, double(std::abs(errors[i] - expected[i])));
    EXPECT_LT(most, 1e-3) << name;
    const FlipSummary s = summary_of(errors);
    EXPECT_NEAR(s.mean, one.at("mean").get<double>(), 1e-4) << name;
    EXPECT_NEAR(s.weighted_median, one.at("weighted_median").get<double>(), 1e-3) << name;
    EXPECT_NEAR(s.weighted_first_quartile, one.at("weighted_q1").get<double>(), 1e-3) << name;
    EXPECT_NEAR(s.weighted_third_quartile, one.at("weighted_q3").get<double>(), 1e-3) << name;
  }
}

} // namespace
} // namespace unghost
