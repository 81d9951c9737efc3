// Convergence: the world at rest from a cold start; error against the number of frames.
#include <algorithm>

#include "app/measure/measure_parts.h"

namespace unghost {
namespace {

/// 1, 2, 4, ... up to all that a measurement draws.
std::vector<uint32_t> frame_counts(const Protocol& protocol) {
  std::vector<uint32_t> counts;
  for (uint32_t count = 1; count <= last_frame(protocol) + 1; count *= 2) counts.push_back(count);
  return counts;
}

/// The row that accumulates and nothing else, with each jitter there is.
std::vector<ModeRun> jitter_runs() {
  std::vector<ModeRun> runs;
  for (const Answer& jitter : answers<Jitter>()) {
    if (Jitter(jitter.value) == Jitter::none) continue;
    ModeRun& run = runs.emplace_back(ModeRun{.name = jitter.name, .taa = find_taa_mode("blend")->settings});
    run.taa.policy.jitter = Jitter(jitter.value);
  }
  return runs;
}

} // namespace

void measure_convergence(const Measurement& m, Measured& into) {
  std::vector<ModeRun> runs = m.modes;
  const std::vector<ModeRun> of_jitters = jitter_runs();
  runs.insert(runs.end(), of_jitters.begin(), of_jitters.end());
  Convergence convergence{.frames = frame_counts(m.protocol), .curves = {}};
  for (size_t run = 0; run < runs.size(); ++run)
    convergence.curves.push_back(
        {.kind = run < m.modes.size() ? "mode" : "jitter", .name = runs[run].name, .error = {}});

  const uint32_t instant = m.protocol.fill;
  const SeenPicture reference =
      seen(supersampled_reference(m.film, instant, m.protocol.samples, m.references));
  for (uint32_t frame = 0; frame < convergence.frames.back(); ++frame) {
    FrameInput input = at_rest(m.film, instant);
    input.cut = frame == 0;
    input.index = frame;
    input.modes = runs;
    if (std::ranges::count(convergence.frames, frame + 1) > 0)
      for (size_t run = 0; run < runs.size(); ++run) input.wanted.push_back({Output::display, run});
    FrameResult result = m.film.draw(input);
    for (size_t run = 0; run < result.delivered.size(); ++run)
      convergence.curves[run].error.push_back(
          rounded(mean_flip(reference, seen(result.delivered[run].picture))));
  }
  ConvergenceCurve samples{.kind = "supersampling", .name = "supersampling", .error = {}};
  for (const Image& mean : progressive_means(m.film, instant, convergence.frames))
    samples.error.push_back(rounded(mean_flip(reference, seen(mean))));
  convergence.curves.push_back(std::move(samples));
  into.convergence = std::move(convergence);
}

} // namespace unghost
