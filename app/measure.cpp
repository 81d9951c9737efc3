// `unghost measure`: figures, all modes from the same frames.
#include <algorithm>
#include <memory>

#include "app/files.h"
#include "app/measuring.h"
#include "app/table.h"

namespace unghost {
namespace {

void check_words(const CommandLine& line) {
  if (!line.output.empty() && !line.output.ends_with(".json") && line.output != "-")
    throw WrongWords("figures go to a .json file");
  if (line.measure.keep != "none" && !line.output.ends_with(".json"))
    throw WrongWords("--keep wants -o FILE.json: pictures go to the folder FILE");
}

/// The figures that any mode has.
std::vector<FigureKind> columns_of(const Measured& measured) {
  std::vector<FigureKind> columns;
  for (const FigureKind& kind : figure_kinds())
    if (kind.shown && std::ranges::any_of(measured.rows, [&](const MeasuredMode& row) {
          return row.figures.contains(std::string(kind.name));
        }))
      columns.push_back(kind);
  return columns;
}

std::string text_of(const Measured& measured) {
  const std::vector<FigureKind> columns = columns_of(measured);
  std::vector<std::string> heads = {"mode"};
  for (const FigureKind& kind : columns) heads.emplace_back(kind.label);
  Table table(heads);
  for (const MeasuredMode& row : measured.rows) {
    std::vector<std::string> cells = {row.mode};
    for (const FigureKind& kind : columns) {
      const auto found = row.figures.find(std::string(kind.name));
      cells.push_back(found == row.figures.end() ? "-" : fixed(found->second, kind.decimals));
    }
    table.add(cells);
  }
  return table.text();
}

void say_what_is_missing(const MeasurePlan& plan, const Measured& measured, Console& console) {
  const auto none_has = [&](const char* figure) {
    return std::ranges::none_of(measured.rows,
                                [&](const MeasuredMode& row) { return row.figures.contains(figure); });
  };
  if (plan.aspects.contains(Aspect::trail) && none_has("trail"))
    console.err
        << "no surface and no shadow changed in the frames that were measured, so there is no trail\n";
}

} // namespace

void measure(const CommandLine& line, Console& console) {
  check_words(line);
  const MeasurePlan plan(line);
  std::unique_ptr<NewFile> file;
  if (!line.output.empty() && line.output != "-") file = std::make_unique<NewFile>(line.output);
  const std::filesystem::path folder = std::filesystem::path(line.output).replace_extension();
  Measured measured;
  if (console.progress != nullptr) {
    measured = measured_by(plan, folder, console, *console.progress);
  } else {
    Progress progress(console, work_of(plan));
    progress.name(plan.shot.rig);
    measured = measured_by(plan, folder, console, progress);
  }
  const std::string json = measured_json(measured).dump(2) + "\n";
  if (file != nullptr) {
    file->write(bytes_of(json));
    file->commit();
  }
  console.out << (line.json || line.output == "-" ? json : text_of(measured));
  if (!console.quiet) say_what_is_missing(plan, measured, console);
}

} // namespace unghost
