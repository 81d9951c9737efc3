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

/// A line a number of frames, a column a curve of this kind.
std::string text_of(const Convergence& convergence, std::string_view kind) {
  std::vector<std::string> heads = {"frames"};
  for (const ConvergenceCurve& curve : convergence.curves)
    if (curve.kind == kind) heads.push_back(curve.name);
  if (heads.size() < 2) return {};
  Table table(heads);
  for (size_t i = 0; i < convergence.frames.size(); ++i) {
    std::vector<std::string> cells = {std::to_string(convergence.frames[i])};
    for (const ConvergenceCurve& curve : convergence.curves)
      if (curve.kind == kind) cells.push_back(fixed(curve.error[i], 4));
    table.add(cells);
  }
  return "Error after so many frames at rest, a " + std::string(kind) + " a column\n" + table.text();
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
  std::string text = columns.empty() ? "" : table.text();
  if (measured.convergence)
    for (const char* kind : {"mode", "jitter"})
      if (const std::string curves = text_of(*measured.convergence, kind); !curves.empty())
        text += (text.empty() ? "" : "\n") + curves;
  return text;
}

void say_what_is_missing(const MeasurePlan& plan, const Measured& measured, Console& console) {
  const auto none_has = [&](const char* figure) {
    return std::ranges::none_of(measured.rows,
                                [&](const MeasuredMode& row) { return row.figures.contains(figure); });
  };
  if (plan.aspects.contains(Aspect::trail) && none_has("trail"))
    console.err
        << "no surface and no shadow changed in the frames that were measured, so there is no trail\n";
  if (plan.aspects.contains(Aspect::flicker) && none_has("flicker"))
    console.err
        << "between its supersampled frames the picture rests, or has no surface that stays, so there is no "
           "flicker; see shimmer\n";
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
  console.out << (line.json || line.output == "-" ? json : text_of(measured)); // before a disk may be full
  if (!console.quiet) say_what_is_missing(plan, measured, console);
  if (file == nullptr) return;
  console.out.flush();
  file->write(bytes_of(json));
  file->commit();
}

} // namespace unghost
