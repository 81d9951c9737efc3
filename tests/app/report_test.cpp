// `measure` and `report` as they are run: figures that follow from the frames they kept, and the same ones
// again.
#include <gtest/gtest.h>

#include "app/files.h"
#include "app/measure/results.h"
#include "app/png_file.h"
#include "tests/app/flip_oracle.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr double default_ppd = 67.0206432765;

std::string text_of(const fs::path& file) {
  const std::vector<uint8_t> bytes = read_file(file, 1 << 28);
  return {bytes.begin(), bytes.end()};
}

Measured measured_in(const fs::path& file) {
  return measured_from_json(nlohmann::json::parse(text_of(file)), file.string());
}

/// By the reference: the mean over pixels, of two files.
double oracle_mean(const fs::path& reference, const fs::path& test) {
  const std::vector<double> errors = oracle_flip(decode_png(read_file(reference, 1 << 28)),
                                                 decode_png(read_file(test, 1 << 28)), default_ppd);
  double sum = 0;
  for (const double error : errors) sum += error;
  return sum / double(errors.size());
}

std::string five(uint32_t frame) {
  const std::string number = std::to_string(frame);
  return std::string(5 - number.size(), '0') + number;
}

class KeptFigures : public testing::Test {
protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    const Outcome run = measure_into("m.json", {"--keep", "all"});
    ASSERT_EQ(run.exit, 0) << run.err;
    measured_ = new Measured(measured_in(folder_->path / "m.json"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    delete measured_;
  }
  static Outcome measure_into(const std::string& file, const Words& more) {
    Words words{"measure",
                "--rig",
                "pass",
                "--size",
                "64x36",
                "--frames",
                "20",
                "--modes",
                "off,blend,dop32-var",
                "--what",
                "ghosting,shimmer,error,flicker,trail",
                "-q",
                "-o",
                (folder_->path / file).string()};
    words.insert(words.end(), more.begin(), more.end());
    return outcome(words);
  }
  static fs::path picture(const std::string& name) { return folder_->path / "m" / (name + ".png"); }

  static ScratchFolder* folder_;
  static Measured* measured_;
};
ScratchFolder* KeptFigures::folder_ = nullptr;
Measured* KeptFigures::measured_ = nullptr;

TEST_F(KeptFigures, GhostingFollowsFromTheFrames) {
  for (const MeasuredMode& row : measured_->rows) {
    double sum = 0;
    for (uint32_t frame = 16; frame < 20; ++frame)
      sum += oracle_mean(picture("ghosting-reference-" + five(frame)),
                         picture("ghosting-" + row.mode + "-" + five(frame)));
    EXPECT_NEAR(row.figures.at("ghosting"), sum / 4, 1e-4) << row.mode;
    EXPECT_TRUE(row.mode == "off" || sum > 0.01) << row.mode;
  }
}

TEST_F(KeptFigures, ShimmerFollowsFromTheFrames) {
  for (const MeasuredMode& row : measured_->rows) {
    double sum = 0;
    for (uint32_t frame = 17; frame <= 20; ++frame)
      sum += oracle_mean(picture("shimmer-" + row.mode + "-" + five(frame - 1)),
                         picture("shimmer-" + row.mode + "-" + five(frame)));
    EXPECT_NEAR(row.figures.at("shimmer"), sum / 4, 1e-4) << row.mode;
    EXPECT_TRUE(row.mode == "off" || sum > 0.001) << row.mode;
  }
}

TEST_F(KeptFigures, ErrorFollowsFromTheFrames) {
  ASSERT_EQ(measured_->error_frames.size(), 4u);
  for (const MeasuredMode& row : measured_->rows) {
    double sum = 0;
    for (const uint32_t frame : measured_->error_frames)
      sum += oracle_mean(picture("error-reference-" + five(frame)),
                         picture("error-" + row.mode + "-" + five(frame)));
    EXPECT_NEAR(row.figures.at("error"), sum / 4, 1e-4) << row.mode;
  }
}

TEST_F(KeptFigures, AreTheSameBytesOnASecondRun) {
  setenv("XDG_CACHE_HOME", folder_->path.c_str(), 1); // without the references that were drawn before
  ASSERT_EQ(measure_into("again.json", {}).exit, 0);
  Measured again = measured_in(folder_->path / "again.json"), first = *measured_;
  EXPECT_TRUE(fs::exists(folder_->path / "unghost" / "references"));
  first.kept.clear(), first.words.clear(), again.words.clear();
  EXPECT_EQ(measured_json(first).dump(), measured_json(again).dump());
}

class Reported : public testing::Test {
protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    const Outcome run = outcome(words_for("r"));
    ASSERT_EQ(run.exit, 0) << run.err;
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path at(const std::string& file) { return folder_->path / file; }
  static Words words_for(const std::string& to) {
    return {"report",   "--rig", "drive",   "--size",        "64x36", "--frames",     "18",
            "--rounds", "3",     "--modes", "off,blend,rgb", "-o",    at(to).string()};
  }

  static ScratchFolder* folder_;
};
ScratchFolder* Reported::folder_ = nullptr;

TEST_F(Reported, IsAPageFiguresAndATable) {
  const std::string page = text_of(at("r/index.html"));
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>") || page.starts_with("<!doctype html>"));
  EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org/2000/svg")) << "nothing from a network";
  const Results results =
      results_from_json(nlohmann::json::parse(text_of(at("r/results.json"))), "results.json");
  ASSERT_EQ(results.scenes.size(), 1u) << "errors and times of the same frames";
  for (const char* figure : {"ghosting", "shimmer", "error", "flicker", "trail", "added_ms", "over_copy"})
    EXPECT_TRUE(results.scenes[0].rows[1].figures.contains(figure)) << figure;
  EXPECT_EQ(results.protocol, "custom") << "fewer frames than any protocol has";
  const std::string csv = text_of(at("r/results.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  for (const KeptFrame& kept : results.scenes[0].kept)
    EXPECT_TRUE(fs::exists(at("r") / kept.picture)) << kept.picture;
}

TEST_F(Reported, GoesOnWithWhatIsThere) {
  std::map<fs::path, fs::file_time_type> before;
  for (const auto& entry : fs::directory_iterator(at("r/measured")))
    before[entry.path()] = entry.last_write_time();
  ASSERT_EQ(before.size(), 3u) << "two measurements, and a folder of frames";
  const std::string results = text_of(at("r/results.json"));
  ASSERT_EQ(outcome(words_for("r")).exit, 0);
  for (const auto& entry : fs::directory_iterator(at("r/measured")))
    EXPECT_EQ(before[entry.path()], entry.last_write_time()) << entry.path();
  EXPECT_EQ(text_of(at("r/results.json")), results);
  const Outcome from = outcome({"report", "--from", at("r/measured").string(), "-o", at("again").string()});
  ASSERT_EQ(from.exit, 0) << from.err;
  EXPECT_EQ(nlohmann::json::parse(text_of(at("again/results.json"))).at("scenes").at(0).at("rows"),
            nlohmann::json::parse(results).at("scenes").at(0).at("rows"));
}

TEST_F(Reported, BesideABaselineSaysWhatIsWorseAndEndsWithOne) {
  const auto beside = [&](const std::string& baseline) {
    return outcome(
        {"report", "--from", at("r/results.json").string(), "--baseline", baseline, "-o", at("b").string()});
  };
  EXPECT_EQ(beside(at("r/results.json").string()).exit, 0);
  nlohmann::json better = nlohmann::json::parse(text_of(at("r/results.json")));
  for (auto& sample : better["scenes"][0]["rows"][1]["samples"]["ghosting"])
    sample = sample.get<double>() * 0.5;
  const Outcome worse = beside(folder_->file("better.json", better.dump()).string());
  EXPECT_EQ(worse.exit, 1);
  EXPECT_NE(worse.out.find("ghosting"), std::string::npos) << worse.out;
  EXPECT_NE(worse.err.find("worse than"), std::string::npos) << worse.err;
  EXPECT_EQ(beside(folder_->file("broken.json", "{}").string()).exit, 3);
  nlohmann::json other = better;
  other["scenes"][0]["rig"] = "pass";
  const Outcome nothing = beside(folder_->file("other.json", other.dump()).string());
  EXPECT_EQ(nothing.exit, 3) << nothing.out;
  EXPECT_NE(nothing.err.find("nothing to compare"), std::string::npos) << nothing.err;
  const std::string own = folder_->file("b/results.json", better.dump()).string(); // is written over
  EXPECT_EQ(beside(own).exit, 1);
}

TEST(Measure, ConvergenceAloneHasATable) {
  const Outcome run =
      outcome({"measure", "--what", "convergence", "--size", "16x16", "--modes", "blend", "--quiet"});
  ASSERT_EQ(run.exit, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("Error after so many frames at rest, a mode a column\nframes  blend\n"))
      << run.out;
  EXPECT_NE(run.out.find("halton-8"), std::string::npos) << run.out;
}

} // namespace
} // namespace unghost
