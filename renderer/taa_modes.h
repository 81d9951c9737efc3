// A mode is a row of answers to the questions that every temporal resolve asks. The command line,
// the comparison, the measurements, the tests and the README's table iterate over these rows.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "shaders/shared/taa.h"

namespace unghost {

#define UNGHOST_ENUMERATOR(column, answer, value) answer = value,
enum class Jitter : uint32_t { TAA_JITTER(UNGHOST_ENUMERATOR) };
enum class Dilation : uint32_t { TAA_DILATION(UNGHOST_ENUMERATOR) };
enum class HistoryFilter : uint32_t { TAA_HISTORY(UNGHOST_ENUMERATOR) };
enum class Rectify : uint32_t { TAA_RECTIFY(UNGHOST_ENUMERATOR) };
enum class Reject : uint32_t { nothing = 0, TAA_REJECT(UNGHOST_ENUMERATOR) };
enum class Blend : uint32_t { TAA_BLEND(UNGHOST_ENUMERATOR) };
#undef UNGHOST_ENUMERATOR

constexpr Reject operator|(Reject a, Reject b) { return Reject(uint32_t(a) | uint32_t(b)); }
constexpr bool has(Reject set, Reject test) { return (uint32_t(set) & uint32_t(test)) != 0; }

/// Which answer, column by column; each becomes a specialization constant of the resolve.
struct TaaPolicy {
  Jitter jitter = Jitter::none;
  Dilation dilation = Dilation::centre;
  HistoryFilter history = HistoryFilter::bilinear;
  Rectify rectify = Rectify::none;
  Reject reject = Reject::nothing;
  Blend blend = Blend::current;

  bool operator==(const TaaPolicy&) const = default;
  bool needs_history() const { return blend != Blend::current; }
  bool needs_tags() const {
    return needs_history() && (has(reject, Reject::tag) || has(reject, Reject::near_moving));
  }
  bool needs_previous_tags() const { return needs_history() && has(reject, Reject::tag); }
};

struct TaaMode {
  std::string_view name;
  std::string_view summary; // one sentence
  std::string_view source;
  TaaPolicy policy;
};

std::span<const TaaMode> taa_modes();
/// The row of that name, or nothing.
const TaaMode* find_taa_mode(std::string_view name);

} // namespace unghost
