#include "app/report_notes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "app/measure/bootstrap.h"
#include "app/measure/report/html.h"
#include "app/measure/report/paper_tables.h"
#include "app/table.h"

namespace unghost {
namespace {

/// Of the paper's columns.
struct Column {
  const char* figure;
  double PaperRow::*theirs;
  const char* less;    // than: the one with the smaller figure ...
  const char* of_what; // its samples are
  const char* depends; // where the paper's other scene has the order that we have
  int decimals, their_decimals;
};
constexpr Column columns[] = {
    {"ghosting", &PaperRow::ghosting, "ghosts less", "frames", "it depends on the scene", 4, 4},
    {"shimmer", &PaperRow::shimmer, "shimmers less", "frames", "it depends on the scene", 4, 4},
    {"over_copy", &PaperRow::ms, "takes less time", "rounds", "neither is faster everywhere", 2, 3}};

const MeasuredMode* row_of(const Measured& m, std::string_view mode) {
  const auto found = std::ranges::find(m.rows, mode, &MeasuredMode::mode);
  return found == m.rows.end() ? nullptr : &*found;
}

std::string percent(double share) { return fixed(100 * std::abs(share), 1) + "%"; }

/// Of what is less: "4.1 to 4.9%".
std::string interval(const RelativeChange& change) {
  const auto part = [](double share) { return fixed(-100 * share, 1); };
  return part(change.high) + " to " + part(change.low) + "%";
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
    const std::string figures = fixed(x, column.their_decimals) + " and " + fixed(y, column.their_decimals);
    return x < y ? " In the paper's own " + std::string(other.scene) + " the order is as here (" + figures +
                       "): " + column.depends + "."
                 : " Its " + std::string(other.scene) + " has the paper's order, too (" + figures + ").";
  }
  return {};
}

const std::vector<double>* samples_of(const MeasuredMode& row, const Column& column) {
  const auto found = row.samples.find(column.figure);
  return found == row.samples.end() || found->second.size() < 2 ? nullptr : &found->second;
}

/// How sure it is that the first is less than the second; nothing where the samples have not come along.
std::string certainty(const MeasuredMode& less, const MeasuredMode& more, const Column& column) {
  const std::vector<double>*after = samples_of(less, column), *before = samples_of(more, column);
  if (after == nullptr || before == nullptr) return {};
  const auto shares = [](const std::vector<double>& samples) {
    return FrameShares{samples, std::vector<double>(samples.size(), 1)};
  };
  constexpr double least = 1e-9;
  const RelativeChange change = std::string_view(column.figure) == "over_copy"
                                    ? change_of_medians(*before, *after, least)
                                    : change_of_frames(shares(*before), shares(*after),
                                                       {.paired = before->size() == after->size()}, least);
  return std::string(" (95% over ") + column.of_what + ": " + interval(change) + "), " +
         (change.high < 0 ? "so it is no chance of these " : "which does not tell them apart over these ") +
         column.of_what;
}

/// `less` has the smaller figure here, and the larger one in the paper.
std::string explained(const Measured& m, const PaperTable& table, const Column& column, const PaperRow& less,
                      const PaperRow& more) {
  const MeasuredMode &a = *row_of(m, less.mode), &b = *row_of(m, more.mode);
  const double ours = a.figures.at(column.figure), ours_more = b.figures.at(column.figure);
  const double theirs = less.*(column.theirs), theirs_more = more.*(column.theirs);
  return "At " + size_of(m) + " " + std::string(less.mode) + " " + column.less + " than " +
         std::string(more.mode) + ": " + fixed(ours, column.decimals) + " and " +
         fixed(ours_more, column.decimals) + ", " + percent(ours / ours_more - 1) + " apart" +
         certainty(a, b, column) + ". The paper has " + fixed(theirs, column.their_decimals) + " and " +
         fixed(theirs_more, column.their_decimals) + ", " + percent(theirs_more / theirs - 1) + " apart." +
         elsewhere_in_the_paper(table, column, less, more);
}

/// Pairs of modes by name, of one column: those that have been explained.
using Explained = std::set<std::tuple<const char*, std::string_view, std::string_view>>;

void explain(const Measured& m, const PaperTable& table, const Column& column, Explained& done,
             PageNotes& notes) {
  // as the table shows them: what reads alike has no order, and times are ratios to the first
  const auto ours_of = [&](const PaperRow& row) {
    const MeasuredMode* here = row_of(m, row.mode);
    return here != nullptr && here->figures.contains(column.figure) ? here->figures.at(column.figure) : NAN;
  };
  const PaperRow& first = table.rows.front();
  const bool ratios = column.theirs == &PaperRow::ms;
  std::vector<double> theirs, ours;
  for (const PaperRow& row : table.rows) {
    theirs.push_back(as_read(row.*(column.theirs) / (ratios ? first.ms : 1), column.decimals));
    ours.push_back(as_read(ours_of(row) / (ratios ? ours_of(first) : 1), column.decimals));
  }
  for (const auto& [a, b] : compare_orders(theirs, ours).unlike) {
    const PaperRow &less = table.rows[ours[a] < ours[b] ? a : b],
                   &more = table.rows[ours[a] < ours[b] ? b : a];
    if (done.insert({column.figure, less.mode, more.mode}).second)
      notes.paragraphs.push_back(explained(m, table, column, less, more));
  }
}

} // namespace

PageNotes report_notes(const Results& results) {
  PageNotes notes;
  for (const PaperTable& table : paper_tables()) {
    std::vector<const Measured*> shown; // what the largest says holds for the others, too
    for (const Measured& m : results.scenes)
      if (is_of(table, m)) shown.push_back(&m);
    std::ranges::stable_sort(shown, std::ranges::greater(),
                             [](const Measured* m) { return m->width * uint64_t(m->height); });
    Explained done;
    for (const Measured* m : shown)
      for (const Column& column : columns) explain(*m, table, column, done, notes);
  }
  return notes;
}

} // namespace unghost
