// `unghost stability`: every mode against every stiff and extreme case.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/assignments.h"
#include "app/commands.h"
#include "app/failure.h"
#include "app/files.h"
#include "app/headless.h"
#include "app/measure/stability/run.h"
#include "app/paths.h"
#include "app/progress.h"
#include "app/table.h"
#include "renderer/mode_names.h"

namespace unghost {
namespace {

constexpr const char* all_of_them = "all"; // a word of --case and --modes

/// Those of the names; all of them where there are none.
template <class Row>
std::vector<const Row*> chosen(std::span<const Row> all, const std::vector<std::string>& names,
                               const char* what) {
  std::vector<std::string> known;
  for (const Row& row : all) known.emplace_back(row.name);
  const bool every = names.empty() || std::ranges::find(names, all_of_them) != names.end();
  std::vector<const Row*> some;
  for (const std::string& name : every ? known : names) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end())
      throw WrongWords(std::string("there is no ") + what + " '" + name + "'" + did_you_mean(name, known) +
                       "; there are " + joined(known, ", "));
    const Row* row = &all[size_t(found - known.begin())];
    if (std::ranges::find(some, row) == some.end()) some.push_back(row);
  }
  return some;
}

Endurance endurance_of(const StabilityWords& words) {
  if (words.brief && words.long_run) throw WrongWords("--brief and --long do not go together");
  return words.brief ? Endurance::brief : words.long_run ? Endurance::long_run : Endurance::usual;
}

std::string text_of(const StabilityCell& cell) {
  return value_text(cell.value) + (!cell.pass ? "!" : cell.excuse.empty() ? "" : "~");
}

/// A line a mode, a column a case: those from `first` on, as many as a page is wide.
std::string text_of(const StabilityTable& all, size_t first, size_t count) {
  std::vector<std::string> heads = {"mode"}, bounds = {"at most"};
  const std::span columns =
      std::span(all.columns).subspan(first, std::min(count, all.columns.size() - first));
  for (const StabilityColumn& column : columns)
    heads.push_back(column.name), bounds.push_back(value_text(column.bound));
  Table table(heads);
  table.add(bounds);
  for (const std::string& mode : modes_of(all)) {
    std::vector<std::string> line = {mode};
    for (const StabilityColumn& column : columns) line.push_back(text_of(*find_cell(all, mode, column.name)));
    table.add(line);
  }
  return table.text();
}

/// The worst of each case that has no excuse, and the excuses.
void say_worst(const StabilityTable& table, std::ostream& out) {
  for (const StabilityColumn& column : table.columns) {
    const StabilityCell* worst = worst_cell(table, column.name);
    if (worst == nullptr || worst->value == 0.0) continue;
    out << column.name << ": worst " << (worst->mode == every_mode ? "" : worst->mode + ", ")
        << value_text(worst->value) << " " << column.unit << " (" << worst->worst << ")"
        << (worst->pass ? "" : ": over its bound") << "\n";
  }
  for (const StabilityCell& cell : table.cells)
    if (!cell.excuse.empty())
      out << "~ " << cell.mode << " in " << cell.column << ": " << cell.excuse << "\n";
}

/// Our own scene on rig `drive`, once for each worker that asks: no device is drawn on by two threads.
class Asphalts {
public:
  Asphalts(const CommandLine& line, const Console& console, size_t workers)
      : line_(line), console_(console), films_(workers) {
    shot_.rig = "drive";
    console_.quiet = true; // no time is said that a banner would have to excuse
  }

  const Film& of_worker(size_t worker) {
    Own& own = films_[worker];
    if (own.headless == nullptr) {
      own.headless = std::make_unique<Headless>(line_, shot_, console_);
      own.film = own.headless->film();
    }
    return own.film;
  }
  void finish() const {
    for (const Own& own : films_)
      if (own.headless != nullptr) own.headless->finish();
  }

private:
  struct Own {
    std::unique_ptr<Headless> headless;
    Film film;
  };

  const CommandLine& line_;
  Shot shot_;
  Console console_;
  std::vector<Own> films_;
};

void check_words(const CommandLine& line) {
  if (!line.output.empty() && !line.output.ends_with(".json") && line.output != "-")
    throw WrongWords("the table goes to a .json file");
  if (line.stability.trial && line.stability.cases != std::vector<std::string>{"chance"})
    throw WrongWords("--trial is one of --case chance");
}

/// Rows, and answers that no row has; rows with settings of their own are checked here.
std::vector<ModeRun> modes_from(const CommandLine& line) {
  const std::vector<ModeRun> known = stability_modes();
  std::vector<ModeRun> modes;
  const auto add = [&](const ModeRun& run) {
    if (!run.taa.policy.needs_history())
      throw WrongWords(run.name + " keeps no history, and has nothing that could break");
    if (std::ranges::find(modes, run.name, &ModeRun::name) == modes.end()) modes.push_back(run);
  };
  for (const std::string& name : line.modes.empty() ? std::vector<std::string>{all_of_them} : line.modes)
    if (base_of_mode(name) != name || find_taa_mode(name) != nullptr)
      add(mode_run(name));
    else
      for (const ModeRun* mode : chosen(std::span(known), {name}, "mode")) add(*mode);
  if (const auto why = refusal(Settings{}, modes)) throw WrongWords(*why);
  return modes;
}

StabilityRequest request_from(const CommandLine& line) {
  return {.cases = chosen(stability_cases(), line.stability.cases, "case"),
          .modes = modes_from(line),
          .endurance = endurance_of(line.stability),
          .seed = line.seed.value_or(1),
          .trial = line.stability.trial,
          .device = {.which = line.device, .validate = line.validate},
          .shaders = find_data_folders().shaders,
          .asphalt = {},
          .begins = {},
          .ends = {}};
}

void print(const CommandLine& line, const Console& console, const StabilityTable& table, NewFile* file) {
  const std::string json = stability_json(table).dump(2) + "\n";
  if (line.json || line.output == "-") {
    console.out << json;
  } else {
    constexpr size_t columns = 8;
    for (size_t first = 0; first < table.columns.size(); first += columns)
      console.out << text_of(table, first, columns) << "\n";
    if (!console.quiet) say_worst(table, console.err);
  }
  console.out.flush(); // before a disk may be full
  if (file == nullptr) return;
  file->write(bytes_of(json));
  file->commit();
}

} // namespace

void stability(const CommandLine& line, Console& console) {
  check_words(line);
  StabilityRequest request = request_from(line);
  std::unique_ptr<NewFile> file;
  if (!line.output.empty() && line.output != "-") file = std::make_unique<NewFile>(line.output);
  Asphalts asphalts(line, console, stability_workers(request));
  request.asphalt = [&](size_t worker) -> const Film& { return asphalts.of_worker(worker); };
  StabilityResult result;
  {
    Progress progress(console, double(request.cases.size() * stability_workers(request)));
    request.begins = [&](std::string_view name) { progress.name(std::string(name)); };
    request.ends = [&] { progress.step(1); };
    result = run_stability(request);
  }
  print(line, console, result.table, file.get());
  report_validation(console.err, result.validation_messages);
  asphalts.finish();
  const auto failed = std::ranges::count(result.table.cells, false, &StabilityCell::pass);
  if (failed > 0)
    throw Failure(Exit::failed, std::to_string(failed) + " of " + std::to_string(result.table.cells.size()) +
                                    (failed == 1 ? " cells is" : " cells are") + " over the bound");
}

} // namespace unghost
