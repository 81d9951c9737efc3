#include "app/measure/baseline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "app/measure/bootstrap.h"
#include "app/measure/quantile.h"
#include "renderer/spelling.h"

namespace unghost {
namespace {

using nlohmann::json;

/// Which samples a figure is made of, and how.
struct Comparable {
  std::string_view figure, samples, wholes; // wholes: empty for a mean
  bool time = false;
  bool supersampled = false; // of the frames that have a supersampled one, not of all that count
};
constexpr Comparable comparables[] = {
    {"ghosting", "ghosting", ""},
    {"shimmer", "shimmer", ""},
    {"error", "error", "", false, true},
    {"flicker", "flicker", "", false, true},
    {"trail", "trail_remaining", "trail_all"},
    {"added_over_copy", "added_over_copy", "", true},
};

std::string name_of(const Measured& m) {
  std::string name = m.scene + ", " + m.rig + ", " + size_of(m) + ", seed " + std::to_string(m.seed);
  return m.set.empty() ? name : name + ", " + joined(m.set, " ");
}

/// What is small beside this is nothing: ten units of the last decimal that is worth reading.
double least_of(std::string_view figure) {
  const auto kind = std::ranges::find(figure_kinds(), figure, &FigureKind::name);
  return std::pow(10.0, 1 - kind->decimals);
}

std::vector<double> samples_of(const MeasuredMode& row, std::string_view name) {
  const auto found = row.samples.find(std::string(name));
  return found == row.samples.end() ? std::vector<double>{} : found->second;
}

/// A figure's frames, and whether they follow one another.
struct Series {
  FrameShares frames;
  bool successive = true;
};

/// Supersampled frames come in runs of neighbours with gaps between, and each run is one entry.
FrameShares runs_of(const FrameShares& frames, const std::vector<uint32_t>& numbers) {
  FrameShares runs;
  for (size_t i = 0; i < numbers.size(); ++i) {
    if (i == 0 || numbers[i] != numbers[i - 1] + 1) runs.parts.push_back(0), runs.wholes.push_back(0);
    runs.parts.back() += frames.parts[i], runs.wholes.back() += frames.wholes[i];
  }
  return runs;
}

Series series_of(const Measured& m, const MeasuredMode& row, const Comparable& what) {
  FrameShares frames{.parts = samples_of(row, what.samples), .wholes = samples_of(row, what.wholes)};
  if (what.wholes.empty()) frames.wholes.assign(frames.parts.size(), 1);
  frames.wholes.resize(frames.parts.size(), 0);
  if (!what.supersampled) return {.frames = std::move(frames), .successive = true};
  if (m.error_frames.size() != frames.parts.size()) // flicker: one a run
    return {.frames = std::move(frames), .successive = false};
  FrameShares runs = runs_of(frames, m.error_frames);
  const bool one_run = runs.parts.size() == 1;
  return {.frames = one_run ? std::move(frames) : std::move(runs), .successive = one_run};
}

bool same_machine(const Measured& a, const Measured& b) {
  return a.device == b.device && a.driver == b.driver &&
         (a.timing ? a.timing->host : "") == (b.timing ? b.timing->host : "");
}

/// Validation and assertions take time.
bool times_compare(const Measured& a, const Measured& b) {
  return same_machine(a, b) && a.validation == b.validation && a.debug_build == b.debug_build;
}

class Comparing {
public:
  Comparing(const Measured& before, const Measured& now, BaselineComparison& into)
      : before_(before), now_(now), into_(into) {}

  void compare() {
    say_differences();
    for (const MeasuredMode& row : now_.rows) {
      const auto old = std::ranges::find(before_.rows, row.mode, &MeasuredMode::mode);
      if (old == before_.rows.end())
        say(row.mode + " is not in the baseline");
      else
        for (const Comparable& what : comparables) compare_figure(*old, row, what);
    }
    for (const MeasuredMode& old : before_.rows)
      if (std::ranges::count(now_.rows, old.mode, &MeasuredMode::mode) == 0)
        say(old.mode + " is in the baseline and not here");
  }

private:
  void say(const std::string& what) { into_.missing.push_back(name_of(now_) + ": " + what); }

  void say_where_differs(const std::string& whose, const json& before, const json& now) {
    json all = before;
    all.update(now);
    for (const auto& [name, value] : all.items()) {
      const json old = before.value(name, json()), fresh = now.value(name, json());
      if (old != fresh) say(whose + name + " was " + old.dump() + " and is " + fresh.dump());
    }
  }

  void say_differences() {
    if (before_.device != now_.device || before_.driver != now_.driver)
      say("was measured on " + before_.device + ", " + before_.driver + " and now on " + now_.device + ", " +
          now_.driver);
    say_where_differs("", before_.settings, now_.settings);
    for (const auto& [mode, settings] : now_.modes)
      for (const auto& [old_mode, old_settings] : before_.modes)
        if (mode == old_mode) say_where_differs(mode + ": ", old_settings, settings);
    if (before_.timing && now_.timing && !times_compare(before_, now_))
      say("times compare only on one host, device and driver, and of builds alike");
    if (before_.samples != 0 && now_.samples != 0 && before_.samples != now_.samples)
      say("a supersampled frame was of " + std::to_string(before_.samples) + " samples and is of " +
          std::to_string(now_.samples));
  }

  void compare_figure(const MeasuredMode& old, const MeasuredMode& row, const Comparable& what) {
    const std::string figure(what.figure);
    const bool was = old.figures.contains(figure), is = row.figures.contains(figure);
    if (was != is) return say(row.mode + " has " + figure + (is ? " only here" : " only in the baseline"));
    if (!is || (what.time && !times_compare(before_, now_))) return;
    const std::optional<Change> change =
        what.time ? change_of_times(old, row, what) : change_of_shares(old, row, what);
    if (!change) return say(row.mode + ": " + figure + " has too few samples to be compared");
    add(*change, row.mode);
  }

  std::optional<Change> change_of_times(const MeasuredMode& old, const MeasuredMode& row,
                                        const Comparable& what) const {
    const std::vector<double> before = samples_of(old, what.samples), after = samples_of(row, what.samples);
    if (std::min(before.size(), after.size()) < 2) return std::nullopt;
    Change change = bare(what);
    change.before = quantile(before, 0.5), change.after = quantile(after, 0.5);
    if (before != after) judge(change, change_of_medians(before, after, least_of(what.figure)));
    return change;
  }

  std::optional<Change> change_of_shares(const MeasuredMode& old, const MeasuredMode& row,
                                         const Comparable& what) const {
    const Series was = series_of(before_, old, what), is = series_of(now_, row, what);
    const FrameShares &before = was.frames, &after = is.frames;
    if (std::min(before.parts.size(), after.parts.size()) < 2) return std::nullopt;
    Change change = bare(what);
    change.before = share_of(before), change.after = share_of(after);
    if (before.parts == after.parts && before.wholes == after.wholes) return change;
    const bool same_frames = !what.supersampled || before_.error_frames == now_.error_frames;
    const FramePairing pairing{.paired = before.parts.size() == after.parts.size() && same_frames,
                               .successive = was.successive && is.successive};
    judge(change, change_of_frames(before, after, pairing, least_of(what.figure)));
    return change;
  }

  Change bare(const Comparable& what) const {
    return {.scene = now_.scene,
            .rig = now_.rig,
            .mode = {},
            .figure = std::string(what.figure),
            .width = now_.width,
            .height = now_.height,
            .seed = now_.seed,
            .set = now_.set};
  }

  static void judge(Change& change, const RelativeChange& found) {
    change.change = found.change, change.low = found.low, change.high = found.high;
    change.verdict = found.low > 0 ? Verdict::worse : found.high < 0 ? Verdict::better : Verdict::noise;
  }

  void add(Change change, const std::string& mode) {
    change.mode = mode;
    change.regression = change.verdict == Verdict::worse && change.change > into_.allowed_share;
    into_.changes.push_back(std::move(change));
  }

  const Measured& before_;
  const Measured& now_;
  BaselineComparison& into_;
};

bool asked_the_same(const Measured& a, const Measured& b) {
  const auto asked = [](const Measured& m) {
    return std::tie(m.scene, m.rig, m.width, m.height, m.seed, m.set);
  };
  return asked(a) == asked(b);
}

/// To each entry of `now` the one of the baseline, each once; null where there is none. Those of one machine
/// and one set of settings find one another first.
std::vector<const Measured*> partners_of(const Results& now, const Results& baseline) {
  std::vector<const Measured*> partners(now.scenes.size()), left;
  for (const Measured& old : baseline.scenes) left.push_back(&old);
  for (const int alike : {3, 2, 1, 0})
    for (size_t i = 0; i < partners.size(); ++i) {
      const Measured& entry = now.scenes[i];
      const auto found = std::ranges::find_if(left, [&](const Measured* old) {
        return asked_the_same(entry, *old) &&
               2 * same_machine(entry, *old) + (entry.settings == old->settings) >= alike;
      });
      if (partners[i] != nullptr || found == left.end()) continue;
      partners[i] = *found;
      left.erase(found);
    }
  return partners;
}

} // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
  case Verdict::better:
    return "better";
  case Verdict::worse:
    return "worse";
  case Verdict::same:
    return "same";
  case Verdict::noise:
    return "noise";
  }
  return {};
}

BaselineComparison compared_with(const Results& baseline, const Results& now, double allowed_share) {
  BaselineComparison comparison{.allowed_share = allowed_share, .changes = {}, .missing = {}};
  const std::vector<const Measured*> partners = partners_of(now, baseline);
  for (size_t i = 0; i < partners.size(); ++i)
    if (partners[i] == nullptr)
      comparison.missing.push_back(name_of(now.scenes[i]) + ": is not in the baseline");
    else
      Comparing(*partners[i], now.scenes[i], comparison).compare();
  for (const Measured& old : baseline.scenes)
    if (std::ranges::count(partners, &old) == 0)
      comparison.missing.push_back(name_of(old) + ": is in the baseline and not here");
  return comparison;
}

size_t regressions(const BaselineComparison& comparison) {
  return size_t(std::ranges::count(comparison.changes, true, &Change::regression));
}

std::vector<Change> differences(const BaselineComparison& comparison) {
  std::vector<Change> changed;
  for (const Change& change : comparison.changes)
    if (change.verdict != Verdict::same) changed.push_back(change);
  const auto rank = [](const Change& c) {
    return c.regression ? 0 : c.verdict == Verdict::worse ? 1 : c.verdict == Verdict::better ? 2 : 3;
  };
  std::ranges::stable_sort(changed, {}, rank);
  return changed;
}

json comparison_json(const BaselineComparison& comparison) {
  json object = {{"allowed_share", comparison.allowed_share},
                 {"regressions", regressions(comparison)},
                 {"changes", json::array()},
                 {"missing", comparison.missing}};
  for (const Change& c : comparison.changes)
    object["changes"].push_back({{"scene", c.scene},
                                 {"rig", c.rig},
                                 {"size", std::to_string(c.width) + "x" + std::to_string(c.height)},
                                 {"seed", c.seed},
                                 {"set", c.set},
                                 {"mode", c.mode},
                                 {"figure", c.figure},
                                 {"before", c.before},
                                 {"after", c.after},
                                 {"change", c.change},
                                 {"low", c.low},
                                 {"high", c.high},
                                 {"verdict", name_of(c.verdict)},
                                 {"regression", c.regression}});
  return object;
}

} // namespace unghost
