// The measurements: which frames are drawn, and what is taken of them. All modes of one measurement see the
// same frames. Ghosting and shimmer are those of Ikkala et al. 2024, section 4.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "app/measure/film.h"
#include "app/measure/results.h"
#include "app/measure/supersampling.h"

namespace unghost {

struct Protocol {
  std::string_view word;
  uint32_t fill = 16, measured = 16; // frames before the first that counts, and those that count
  uint32_t samples = 64;             // of a supersampled frame
  uint32_t references = 4;           // supersampled frames, in pairs of successive ones
  uint32_t rounds = 31;              // that are timed
};
/// quick and full.
std::span<const Protocol> protocols();

/// What can be measured, by its word.
enum class Aspect { ghosting, shimmer, error, flicker, trail, convergence, time };
struct AspectRow {
  std::string_view word;
  Aspect aspect;
  bool by_default = true;
};
std::span<const AspectRow> aspects();
/// With commas between them.
std::string words_by_default();

/// Which frames stay as pictures: none, each mode's worst, all that were judged.
enum class Keep { none, worst, all };
struct KeepRow {
  std::string_view word;
  Keep keep;
};
std::span<const KeepRow> keep_words();

struct Measurement {
  const Film& film;
  Protocol protocol;
  std::set<Aspect> aspects;
  std::vector<ModeRun> modes; // as jittered() has them
  ReferenceCache references;  // of supersampled frames
  Keep keep = Keep::none;
  std::function<void(const std::string& file, const Image& picture)> save; // where `keep` is not none
};

/// Frames of the rig that are drawn: those that fill the history and those that count.
inline uint32_t last_frame(const Protocol& protocol) { return protocol.fill + protocol.measured - 1; }
/// Those that are supersampled: pairs of successive frames about evenly among those that count, each at
/// another phase of the jitter, the last included.
std::vector<uint32_t> reference_frames(const Protocol& protocol);
inline bool asks(const Measurement& m, Aspect aspect) { return m.aspects.contains(aspect); }

/// How much work it is, as work_of(FrameInput) counts; references that are in the cache are not in it.
double work_of(const Measurement& measurement);

/// The modes with the jitter that all share, R2's ten points (Ikkala et al. 2024); those that keep none have
/// none, and those that mix two input frames keep their own two samples, which are the whole of what they
/// mix.
std::vector<ModeRun> jittered(const std::vector<ModeRun>& modes);

/// Fills the figures, samples, curves and kept frames of `into`, whose rows are the measurement's modes.
void measure_all(const Measurement& measurement, Measured& into);

} // namespace unghost
