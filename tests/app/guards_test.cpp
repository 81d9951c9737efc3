// Each guard of a shader against what is stiff or extreme, taken out: the case that it is there for must then
// be over its bound. That all of them hold is for stability_test.cpp to show.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

#include "app/files.h"
#include "app/measure/stability/run.h"
#include "app/paths.h"
#include "renderer/gpu/sha256.h"
#include "tests/app/child.h"
#include "tests/app/own_copy.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

/// `line`, which stands once in `file`, becomes `instead`; then `row` is too much for `mode`.
struct Guard {
  const char *name, *file, *line, *instead, *entry, *row, *mode;
};

constexpr const char *resolve = "taa.comp", *pixel = "taa_pixel.glsl",
                     *reprojection = "taa_reprojection.glsl", *store = "taa_store.glsl",
                     *turn = "clamp(seed >> 19, arithmetic, unit - arithmetic)";
constexpr Guard guards[] = {
    {"what is no number ends at the door", "taa_inputs.glsl",
     "return mix(max(colour, vec3(0)), vec3(0), bad);", "return colour;", resolve, "bad-colour", "blend"},
    {"a history that is no number is none", reprojection,
     "r.number = abs(f.colour.x) + abs(f.colour.y) + abs(f.colour.z) < largest;", "r.number = true;", resolve,
     "bad-history", "blend"},
    {"what has no motion has no history", reprojection,
     "r.known = all(lessThan(abs(r.motion), vec2(MOTION_UNKNOWN / 2)));", "r.known = true;", resolve,
     "lookup", "blend"},
    {"what was off the picture is no history", reprojection, "(r.inside || !rejects(reject_off_screen))",
     "true", resolve, "lookup", "blend"},
    {"a store does not round to one side", store, turn, "0", resolve, "constant", "blend"},
    {"a history that stays is not rounded", store, turn, "seed >> 19", resolve, "flat", "holy-trail"},
    {"weights by luminance, not 1 less of it", pixel, "if (weighting != weighting_inverse_luminance)",
     "if (true)", resolve, "constant", "holy-trail"},
    {"black comes back from the logarithm", "taa_colour.glsl", "max(exp(colour) - log_offset, vec3(0))",
     "exp(colour)", resolve, "flat", "weighting=log"},
    {"variance is taken about the mean", "taa_rectify.glsl",
     "squares = (a - mean) * (a - mean) + (b - mean) * (b - mean) + (c - mean) * (c - mean)",
     "squares = a * a + b * b + c * c - 3 * mean * mean", resolve, "flat", "gdk-variance"},
    {"what rests and was behind the camera has no motion", "motion.comp", "if (along <= 0)", "if (false)",
     "motion.comp", "motion", "blend"},
    {"nor has what moves", "gbuffer.frag", "if (before.w <= 0)", "if (false)",
     "gbuffer.frag.emissive.motion.object", "motion", "blend"},
};

/// The compiled shaders, one of them without its guard.
class WithoutGuard {
public:
  explicit WithoutGuard(const Guard& guard) {
    const fs::path sources = folder_.path / "sources";
    fs::copy(UNGHOST_SHADER_SOURCES, sources, fs::copy_options::recursive);
    std::string text = content_of(sources / guard.file);
    const std::string line = guard.line;
    EXPECT_EQ(text.find(line, text.find(line) + 1), std::string::npos) << guard.line << " stands there twice";
    if (text.find(line) == std::string::npos) throw std::runtime_error("no such line: " + line);
    write_file(sources / guard.file, bytes_of(text.replace(text.find(line), line.size(), guard.instead)));
    fs::create_directory(shaders());
    const std::string changed = std::string(guard.entry) + ".spv";
    for (const fs::directory_entry& entry : fs::directory_iterator(find_data_folders().shaders))
      if (entry.path().filename() != changed)
        fs::create_symlink(entry.path(), shaders() / entry.path().filename());
    EXPECT_EQ(exit_of(compiler(guard.entry, sources, shaders() / changed)), 0);
    write_sums(changed);
  }
  fs::path shaders() const { return folder_.path / "shaders"; }
  fs::path program() const { return copy_program(folder_.path); }

private:
  /// Only what was built is loaded.
  void write_sums(const std::string& changed) const {
    std::istringstream lines(content_of(find_data_folders().shaders / "sums.txt"));
    std::string sums;
    for (std::string sum, file; lines >> sum >> file;)
      sums += (file == changed ? Sha256::hex(content_of(shaders() / file)) : sum) + "  " + file + "\n";
    fs::remove(shaders() / "sums.txt");
    write_file(shaders() / "sums.txt", bytes_of(sums));
  }
  /// What an entry's name has behind its stage is what it writes.
  static std::vector<std::string> compiler(const std::string& entry, const fs::path& sources,
                                           const fs::path& out) {
    std::vector<std::string> words = {UNGHOST_GLSLANG,         "-V", "--quiet",   "--target-env", "vulkan1.2",
                                      "-I" + sources.string(), "-o", out.string()};
    const size_t stage = entry.find('.') + 1;
    size_t end = std::min(entry.find('.', stage), entry.size());
    const std::string source = entry.substr(0, end);
    while (end < entry.size()) {
      const size_t next = std::min(entry.find('.', end + 1), entry.size());
      std::string output = entry.substr(end + 1, next - end - 1);
      std::ranges::transform(output, output.begin(), [](char c) { return char(std::toupper(c)); });
      words.push_back("-DWRITES_" + output);
      end = next;
    }
    words.push_back((sources / source).string());
    return words;
  }

  ScratchFolder folder_;
};

template <class Rows> const auto& named(const Rows& rows, std::string_view name) {
  return *std::ranges::find_if(rows, [&](const auto& row) { return row.name == name; });
}

StabilityCell outcome_of(const Guard& guard, const fs::path& shaders) {
  const std::vector<ModeRun> modes = stability_modes();
  const StabilityResult result = run_stability({.cases = {&named(stability_cases(), guard.row)},
                                                .modes = {named(modes, guard.mode)},
                                                .endurance = Endurance::brief,
                                                .trial = {},
                                                .device = {},
                                                .shaders = shaders,
                                                .asphalt = {},
                                                .begins = {},
                                                .ends = {}});
  return result.table.cells.at(0);
}

TEST(Guards, EachIsMissedWhereItIsTakenOut) {
  for (const Guard& guard : guards) {
    const WithoutGuard without(guard);
    const StabilityCell cell = outcome_of(guard, without.shaders());
    EXPECT_FALSE(cell.pass) << guard.name << ": " << guard.mode << " in " << guard.row << " is still at "
                            << value_text(cell.value) << " (" << cell.worst << ")";
  }
}

TEST(Guards, TheProgramSaysWhichCellIsOverItsBound) {
  const Guard& rounding = guards[4];
  const WithoutGuard without(rounding);
  const ScratchFolder folder;
  const std::string said = (folder.path / "said").string();
  const int exit = wait_for(start({without.program().string(), "stability", "--brief", "--case", rounding.row,
                                   "--modes", rounding.mode, "-o", (folder.path / "table.json").string()},
                                  folder.path, said));
  EXPECT_EQ(exit, 1);
  EXPECT_NE(content_of(said).find("1 of 1 cells is over the bound"), std::string::npos) << content_of(said);
  const auto table = stability_from_json(nlohmann::json::parse(content_of(folder.path / "table.json")), "it");
  ASSERT_EQ(table.cells.size(), 1u) << "what was found is written all the same";
  EXPECT_FALSE(table.cells[0].pass);
}

TEST(Guards, AFailureByChanceSaysHowItIsRepeated) {
  const Guard range{"",
                    store,
                    "return store == store_dithered ? rounded(colour, pixel) :",
                    "return store == store_dithered ? vec3(-1) :",
                    resolve,
                    "chance",
                    "blend"};
  const WithoutGuard without(range);
  const StabilityCell cell = outcome_of(range, without.shaders());
  EXPECT_FALSE(cell.pass);
  EXPECT_TRUE(cell.worst.starts_with("unghost stability --case chance --seed 1 --trial ")) << cell.worst;
  EXPECT_TRUE(cell.worst.ends_with(" --brief --modes blend")) << cell.worst;
}

} // namespace
} // namespace unghost
