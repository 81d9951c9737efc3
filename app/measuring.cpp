#include "app/measuring.h"

#include <algorithm>

#include "app/files.h"
#include "app/headless.h"
#include "app/maker.h"
#include "app/png_file.h"
#include "app/reference_files.h"
#include "app/version.h"

namespace unghost {
namespace {

constexpr std::string_view custom = "custom";

std::set<Aspect> aspects_of(const CommandLine& line) {
  std::set<Aspect> asked;
  for (const AspectRow& row : aspects())
    if (line.measure.what.empty() && row.by_default) asked.insert(row.aspect);
  std::vector<std::string> known;
  for (const AspectRow& row : aspects()) known.emplace_back(row.word);
  for (const std::string& word : line.measure.what) {
    const auto row = std::ranges::find(aspects(), word, &AspectRow::word);
    if (row == aspects().end()) throw WrongWords("--what has no '" + word + "'" + did_you_mean(word, known));
    asked.insert(row->aspect);
  }
  return asked;
}

Protocol protocol_of(const CommandLine& line) {
  Protocol protocol = *std::ranges::find(protocols(), line.measure.protocol, &Protocol::word);
  if (line.rounds) protocol.rounds = *line.rounds;
  if (!line.frames) return protocol;
  if (*line.frames < protocol.fill + 2)
    throw WrongWords("--frames counts the " + std::to_string(protocol.fill) +
                     " frames that fill the history, and at least 2 after them are measured");
  protocol.word = custom;
  protocol.measured = *line.frames - protocol.fill;
  protocol.references = std::min(protocol.references, protocol.measured / 2 * 2);
  return protocol;
}

Measurement measurement_of(const MeasurePlan& plan, const Film& film) {
  return {.film = film,
          .protocol = plan.protocol,
          .aspects = plan.aspects,
          .modes = plan.shot.modes,
          .references = {},
          .keep = std::ranges::find(keep_words(), plan.line.measure.keep, &KeepRow::word)->keep,
          .save = {}};
}

/// Without figures.
Measured described(const MeasurePlan& plan, const Headless& headless) {
  const nlohmann::json facts = headless.facts(), shot = shot_json(plan.shot, last_frame(plan.protocol) + 1);
  Measured m{.version = UNGHOST_VERSION,
             .build = build_of_program(),
             .device = facts.at("device"),
             .driver = facts.at("driver"),
             .software = facts.at("software"),
             .validation = facts.at("validation"),
             .debug_build = facts.at("debug_build"),
             .inputs = inputs_of(plan.shot.scene, plan.line.settings),
             .scene = plan.shot.scene,
             .rig = plan.shot.rig,
             .width = plan.shot.size.width,
             .height = plan.shot.size.height,
             .seed = plan.shot.seed,
             .protocol = std::string(plan.protocol.word),
             .frames = last_frame(plan.protocol) + 1,
             .fill = plan.protocol.fill,
             .settings = shot.at("settings"),
             .set = plan.line.assignments,
             .words = plan.line.words};
  for (const nlohmann::json& mode : shot.at("modes")) {
    m.modes.emplace_back(mode.at("name"), mode.at("settings"));
    m.rows.push_back({.mode = mode.at("name"), .figures = {}, .samples = {}});
  }
  if (plan.aspects.contains(Aspect::time)) m.timing = Timing{.host = host_name(), .rig = plan.shot.rig};
  return m;
}

} // namespace

MeasurePlan::MeasurePlan(const CommandLine& words)
    : line(words), shot(shot_from(words)), protocol(protocol_of(words)), aspects(aspects_of(words)) {
  shot.frames = last_frame(protocol) + 1;
  shot.modes = jittered(shot.modes);
  for (const std::string& word : words.words)
    if (!is_utf8(word)) throw WrongWords("figures carry the words that asked for them, and one is not UTF-8");
  if (shot.settings.view != View::colour)
    throw SettingError("figures are of finished pictures: --view has no place");
  const bool timed = aspects.contains(Aspect::time);
  if (line.rounds && !timed) throw WrongWords("--rounds are for --what time");
  for (const ModeRun& mode : shot.modes)
    if (timed && mode.taa.resolver != Resolver::fast)
      throw SettingError("time compares both resolvers; resolver is not for it");
}

double work_of(const MeasurePlan& plan) {
  const Film none;
  const double pixels = double(plan.shot.size.width) * plan.shot.size.height;
  return work_of(measurement_of(plan, none)) * pixels / (640 * 360);
}

Measured measured_by(const MeasurePlan& plan, const std::filesystem::path& folder, Console& console,
                     Progress& progress) {
  Headless headless(plan.line, plan.shot, console);
  const double pixels = double(plan.shot.size.width) * plan.shot.size.height / (640 * 360);
  const Film film = headless.film([&](double work) { progress.step(work * pixels); });
  Measured measured = described(plan, headless);
  Measurement measurement = measurement_of(plan, film);
  measurement.references = reference_files(film, plan.shot, measured.device + ", " + measured.driver);
  measurement.save = [&](const std::string& file, const Image& picture) {
    write_file(folder / file, encode_png(picture, shot_json(plan.shot, plan.shot.frames).dump()));
  };
  if (measurement.keep != Keep::none) make_folder(folder);
  measure_all(measurement, measured);
  for (KeptFrame& kept : measured.kept) // as seen from the file of figures, beside the folder
    for (std::string* file : {&kept.picture, &kept.reference})
      *file = (folder.filename() / *file).generic_string();
  headless.finish();
  return measured;
}

} // namespace unghost
