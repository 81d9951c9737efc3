#include "app/measure/protocols.h"

#include <algorithm>
#include <cmath>

#include "app/measure/measure_parts.h"
#include "app/measure/quantile.h"
#include "app/measure/run_time.h"

namespace unghost {
namespace {

constexpr Output surface_outputs[] = {Output::depth, Output::previous_depth, Output::motion, Output::object,
                                      Output::sun_visibility};

} // namespace

std::span<const Protocol> protocols() {
  static constexpr Protocol rows[] = {
      {.word = "quick"},
      {.word = "full", .fill = 100, .measured = 100, .samples = 256, .references = 10, .rounds = 1000},
  };
  return rows;
}

std::span<const AspectRow> aspects() {
  static constexpr AspectRow rows[] = {
      {"ghosting", Aspect::ghosting}, {"shimmer", Aspect::shimmer},
      {"error", Aspect::error},       {"flicker", Aspect::flicker},
      {"trail", Aspect::trail},       {"convergence", Aspect::convergence, false},
      {"time", Aspect::time, false}};
  return rows;
}

std::string words_by_default() {
  std::string words;
  for (const AspectRow& row : aspects())
    if (row.by_default) words += (words.empty() ? "" : ",") + std::string(row.word);
  return words;
}

std::span<const KeepRow> keep_words() {
  static constexpr KeepRow rows[] = {{"none", Keep::none}, {"worst", Keep::worst}, {"all", Keep::all}};
  return rows;
}

std::vector<ModeRun> jittered(const std::vector<ModeRun>& modes) {
  std::vector<ModeRun> runs = modes;
  for (ModeRun& run : runs)
    if (run.taa.policy.jitter != Jitter::none && run.taa.policy.keeps == Keeps::result)
      run.taa.policy.jitter = Jitter::r2_10;
  return runs;
}

std::vector<Wanted> surfaces_wanted(size_t mode) {
  std::vector<Wanted> wanted;
  for (const Output what : surface_outputs) wanted.push_back({what, mode});
  return wanted;
}

Surfaces surfaces_of(const std::vector<Wanted>& wanted, FrameResult& result, size_t mode) {
  const auto take = [&](Output what) { return std::move(delivered(wanted, result, what, mode).image); };
  return {.depth = take(Output::depth),
          .previous_depth = take(Output::previous_depth),
          .motion = take(Output::motion),
          .object = take(Output::object),
          .sun_visibility = take(Output::sun_visibility)};
}

double rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double scale = std::pow(10.0, 8 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

void add_sample(MeasuredMode& row, const char* figure, double value) {
  row.samples[figure].push_back(rounded(value));
}

double mean_of(const std::vector<double>& samples) {
  double sum = 0;
  for (const double sample : samples) sum += sample;
  return rounded(sum / double(samples.size()));
}

void set_means(Measured& into, const char* figure) {
  for (MeasuredMode& row : into.rows)
    if (const auto& samples = row.samples.find(figure); samples != row.samples.end())
      row.figures[figure] = mean_of(samples->second);
}

void measure_time(const Measurement& m, Measured& into) {
  std::vector<ModeRun> runs = m.modes;
  for (ModeRun& run : runs) run.taa.policy.jitter = Jitter::none;
  const RunTimes times = time_modes(m.film, runs, m.protocol.rounds);
  for (size_t mode = 0; mode < runs.size(); ++mode) {
    const ModeTimes& of = times.modes[mode];
    MeasuredMode& row = into.rows[mode];
    row.figures["added_ms"] = quantile(of.added_ms, 0.5);
    row.figures["p05"] = quantile(of.added_ms, 0.05), row.figures["p95"] = quantile(of.added_ms, 0.95);
    for (const auto& [name, samples] : {std::pair{"added_ms", &of.added_ms},
                                        {"added_over_copy", &of.added_over_copy},
                                        {"over_copy", &of.over_copy},
                                        {"over_naive", &of.over_naive}}) {
      for (const double sample : *samples) add_sample(row, name, sample);
      if (!samples->empty() && row.figures.count(name) == 0) row.figures[name] = quantile(*samples, 0.5);
    }
  }
  into.timing->rounds = m.protocol.rounds;
  into.timing->copy_ms = quantile(times.copy_ms, 0.5);
  into.timing->motion_ms = quantile(times.motion_ms, 0.5);
  into.timing->geometry_ms = quantile(times.geometry_ms, 0.5);
}

double work_of(const Measurement& m) {
  FrameInput frame, judged;
  frame.modes = m.modes, judged.modes = m.modes;
  for (size_t mode = 0; mode < m.modes.size(); ++mode) judged.wanted.push_back({Output::display, mode});
  const Protocol& p = m.protocol;
  const double drawn = work_of(frame) * (last_frame(p) + 1), judging = work_of(judged) - work_of(frame);
  const uint32_t reference = p.samples + supersampling_steps[std::size(supersampling_steps) - 1] + 1;
  double work = 0;
  if (asks(m, Aspect::ghosting) || asks(m, Aspect::trail)) work += drawn + p.measured * judging;
  if (asks(m, Aspect::shimmer)) work += drawn + p.measured * judging;
  if (asks(m, Aspect::error) || asks(m, Aspect::flicker))
    work += drawn + p.references * (reference + judging);
  if (asks(m, Aspect::convergence)) work += 2 * drawn + reference + (last_frame(p) + 1);
  if (asks(m, Aspect::time)) work += timed_work(m.modes, p.rounds);
  return work;
}

void measure_all(const Measurement& m, Measured& into) {
  if (asks(m, Aspect::ghosting) || asks(m, Aspect::trail)) measure_motion(m, into);
  if (asks(m, Aspect::shimmer)) measure_rest(m, into);
  if (asks(m, Aspect::error) || asks(m, Aspect::flicker)) measure_error(m, into);
  if (asks(m, Aspect::convergence)) measure_convergence(m, into);
  if (asks(m, Aspect::time)) measure_time(m, into);
}

} // namespace unghost
