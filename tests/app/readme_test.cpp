// The README's figures are those of the committed report, and that report is of this program.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "app/measure/protocols.h"
#include "app/measure/report/html.h"
#include "app/measure/results.h"
#include "app/shards.h"
#include "app/shot.h"
#include "renderer/taa_modes.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr const char* how_to_renew =
    "the figures are stale: unghost report --full -o DIR, unghost merge DIR/measured --no-samples -o "
    "assets/report/full.json; unghost with the words in assets/report/small.json and -o of that file";

fs::path report_file(const char* name) {
  return fs::path(UNGHOST_README).parent_path() / "assets" / "report" / name;
}

std::string text_of(const char* file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Results results_in(const fs::path& file) { return results_from_json(read_json(file), file.string()); }

const MeasuredMode& row_of(const Measured& m, std::string_view mode) {
  const auto row = std::ranges::find(m.rows, mode, &MeasuredMode::mode);
  if (row == m.rows.end()) throw std::out_of_range("no row " + std::string(mode));
  return *row;
}

/// As the table has it: .954, 12.3, 0.
std::string cell(const Measured& m, const std::string& mode, const std::string& figure, int decimals) {
  const auto& figures = row_of(m, mode).figures;
  const bool none = mode == "off" && !figures.contains(figure); // it adds nothing
  const std::string text = none ? "0" : number(figures.at(figure), decimals);
  if (std::stod(text) == 0) return "0";
  return text.starts_with("0.") ? text.substr(1) : text;
}

class ReadmeFigures : public testing::Test {
protected:
  Results full = results_in(report_file("full.json"));

  const Measured& of(const std::string& rig) const {
    for (const Measured& m : full.scenes)
      if (m.rig == rig && m.width == 1280 && m.height == 720) return m;
    throw std::out_of_range("nothing of rig " + rig);
  }
  std::string figures_of(const std::string& mode) const {
    const Measured& drive = of("drive");
    std::string text = cell(drive, mode, "ghosting", 3) + " | " + cell(drive, mode, "shimmer", 4) + " | " +
                       cell(drive, mode, "error", 3);
    for (const char* rig : {"drive", "rotate", "pass", "overhead"})
      text += " | " + cell(of(rig), mode, "trail", 3);
    return text + " | " + cell(drive, mode, "added_over_copy", 1) + " |";
  }
};

TEST_F(ReadmeFigures, AreThoseOfTheCommittedReport) {
  EXPECT_EQ(full.protocol, "full");
  std::ifstream readme(UNGHOST_README);
  size_t rows = 0;
  for (std::string line; std::getline(readme, line);)
    for (const TaaMode& mode : taa_modes())
      if (line.starts_with("| `" + std::string(mode.name) + "` |")) {
        const std::string figures = figures_of(std::string(mode.name));
        EXPECT_TRUE(line.ends_with("| " + figures)) << line << "\nhas in the report: " << figures;
        ++rows;
      }
  EXPECT_EQ(rows, taa_modes().size());
  const auto ghosting = [&](const char* mode) { return cell(of("drive"), mode, "ghosting", 3); };
  EXPECT_NE(text_of(UNGHOST_README)
                .find("`blend` (ghosting " + ghosting("blend") + "), `dop32-var` (" + ghosting("dop32-var") +
                      ") and `unghost` (" + ghosting("unghost") + ")"),
            std::string::npos)
      << "below the first picture";
  const Timing& timing = of("drive").timing.value();
  EXPECT_NE(
      text_of(UNGHOST_README).find("copies: " + number(timing.motion_ms / timing.copy_ms, 1) + "\nof them"),
      std::string::npos);
  EXPECT_EQ(of("drive").frames, 200u);
  EXPECT_EQ(of("drive").fill, 100u);
  EXPECT_EQ(of("drive").seed, 1u);
  EXPECT_EQ(of("drive").samples, 256u);
  EXPECT_EQ(timing.rounds, 1000u);
}

TEST_F(ReadmeFigures, AreOfTheRowsThatTheModesAreNow) {
  std::vector<ModeRun> modes;
  for (const TaaMode& mode : taa_modes())
    modes.push_back({.name = std::string(mode.name), .taa = settings_for_mode(mode.name).taa});
  for (const Measured& m : full.scenes) {
    ASSERT_EQ(m.modes.size(), modes.size()) << how_to_renew;
    for (const ModeRun& run : jittered(modes)) {
      const auto measured =
          std::ranges::find(m.modes, run.name, &std::pair<std::string, nlohmann::json>::first);
      ASSERT_NE(measured, m.modes.end()) << run.name << ": " << how_to_renew;
      Settings settings, then; // what was no setting then was as its default is now
      settings.taa = run.taa;
      apply_settings_json(then, measured->second);
      EXPECT_EQ(settings_json(then, SettingsPart::per_mode), settings_json(settings, SettingsPart::per_mode))
          << run.name << ": " << how_to_renew;
    }
  }
}

/// A small measurement, taken by the same build as the full one, comes out as it did then: what draws and
/// resolves is what it was. Within 2%, as another driver rounds otherwise.
TEST_F(ReadmeFigures, AreOfTheProgramAsItIsNow) {
  const Measured then = measured_from_json(read_json(report_file("small.json")), "small.json");
  EXPECT_EQ(then.build, of("drive").build) << how_to_renew;
  const ScratchFolder folder;
  Words words = then.words;
  words.insert(words.end(), {"--quiet", "-o", (folder.path / "now.json").string()});
  const Outcome run = outcome(words);
  ASSERT_EQ(run.exit, 0) << run.err;
  const Measured now = measured_from_json(read_json(folder.path / "now.json"), "now.json");
  size_t compared = 0;
  for (const MeasuredMode& row : then.rows)
    for (const auto& [figure, value] : row.figures) {
      EXPECT_NEAR(row_of(now, row.mode).figures.at(figure), value, .02 * value + 2e-4)
          << row.mode << ", " << figure << ": " << how_to_renew;
      ++compared;
    }
  EXPECT_GE(compared, 4 * taa_modes().size());
}

} // namespace
} // namespace unghost
