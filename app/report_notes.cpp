#include "app/report_notes.h"

#include <algorithm>
#include <cmath>

#include "app/measure/bootstrap.h"
#include "app/measure/report/paper_tables.h"
#include "app/table.h"

namespace unghost {
namespace {

/// Of the paper's columns.
struct Column {
  const char* figure;
  double PaperRow::*theirs;
  const char* less; // than: the one with the smaller figure ...
};
constexpr Column columns[] = {{"ghosting", &PaperRow::ghosting, "ghosts less"},
                              {"shimmer", &PaperRow::shimmer, "shimmers less"}};

const MeasuredMode* row_of(const Measured& m, std::string_view mode) {
  const auto found = std::ranges::find(m.rows, mode, &MeasuredMode::mode);
  return found == m.rows.end() ? nullptr : &*found;
}

std::string percent(double share) { return fixed(100 * std::abs(share), 1) + "%"; }

/// "-4.9% to -4.1%" as a size.
std::string interval(const RelativeChange& change) {
  const auto part = [](double share) { return fixed(100 * share, 1); };
  return part(change.low) + " to " + part(change.high) + "%";
}

/// How both stand in the paper's tables of other scenes.
std::string elsewhere_in_the_paper(const PaperTable& table, const Column& column, const PaperRow& less,
                                   const PaperRow& more) {
  for (const PaperTable& other : paper_tables()) {
    if (other.scene == table.scene) continue;
    const auto find = [&](std::string_view mode) {
      return std::ranges::find(other.rows, mode, &PaperRow::mode);
    };
    const auto a = find(less.mode), b = find(more.mode);
    if (a == other.rows.end() || b == other.rows.end()) continue;
    const double x = (*a).*(column.theirs), y = (*b).*(column.theirs);
    const std::string figures = fixed(x, 4) + " and " + fixed(y, 4);
    return x < y ? " In the paper's own " + std::string(other.scene) + " the order is as here (" + figures +
                       "): it depends on the scene."
                 : " Its " + std::string(other.scene) + " has the paper's order, too (" + figures + ").";
  }
  return {};
}

/// `less` has the smaller figure here, and the larger one in the paper.
std::string explained(const Measured& m, const PaperTable& table, const Column& column, const PaperRow& less,
                      const PaperRow& more) {
  const MeasuredMode &a = *row_of(m, less.mode), &b = *row_of(m, more.mode);
  const auto shares = [&](const MeasuredMode& row) {
    const std::vector<double>& samples = row.samples.at(column.figure);
    return FrameShares{samples, std::vector<double>(samples.size(), 1)};
  };
  const FrameShares before = shares(b), after = shares(a);
  const bool paired = before.parts.size() == after.parts.size();
  const RelativeChange change = change_of_frames(before, after, {.paired = paired}, 1e-9);
  const bool sure = change.high < 0;
  std::string text =
      std::string(less.mode) + " " + column.less + " here than " + std::string(more.mode) + ": " +
      fixed(a.figures.at(column.figure), 4) + " and " + fixed(b.figures.at(column.figure), 4) + ", " +
      percent(change.change) + " apart (95% over frames: " + interval(change) + "), " +
      (sure ? "so it is no chance of these frames." : "which these frames do not tell from none.");
  const double theirs_less = less.*(column.theirs), theirs_more = more.*(column.theirs);
  text += " The paper has " + fixed(theirs_less, 4) + " and " + fixed(theirs_more, 4) + ", " +
          percent(theirs_more / theirs_less - 1) + " apart.";
  return text + elsewhere_in_the_paper(table, column, less, more);
}

void explain(const Measured& m, const PaperTable& table, const Column& column, PageNotes& notes) {
  std::vector<double> theirs, ours;
  for (const PaperRow& row : table.rows) {
    const MeasuredMode* here = row_of(m, row.mode);
    const bool there = here != nullptr && here->figures.contains(column.figure) &&
                       here->samples.contains(column.figure) && here->samples.at(column.figure).size() > 1;
    theirs.push_back(row.*(column.theirs));
    ours.push_back(there ? here->figures.at(column.figure) : NAN);
  }
  for (const auto& [a, b] : compare_orders(theirs, ours).unlike) {
    const bool first = ours[a] < ours[b];
    notes.paragraphs.push_back(
        explained(m, table, column, table.rows[first ? a : b], table.rows[first ? b : a]));
  }
}

} // namespace

PageNotes report_notes(const Results& results) {
  PageNotes notes;
  for (const PaperTable& table : paper_tables()) {
    // the largest of what shows it speaks for the others
    const Measured* shown = nullptr;
    for (const Measured& m : results.scenes)
      if (is_of(table, m) &&
          (shown == nullptr || m.width * uint64_t(m.height) > shown->width * uint64_t(shown->height)))
        shown = &m;
    for (const Column& column : columns)
      if (shown != nullptr) explain(*shown, table, column, notes);
  }
  return notes;
}

} // namespace unghost
