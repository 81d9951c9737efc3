// A mode is a row of answers to the questions that every temporal resolve asks. The command line, the
// comparison, the measurements, the tests and the README's table iterate over these rows.
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
enum class Ringing : uint32_t { TAA_RINGING(UNGHOST_ENUMERATOR) };
enum class Space : uint32_t { TAA_SPACE(UNGHOST_ENUMERATOR) };
enum class Weighting : uint32_t { TAA_WEIGHTING(UNGHOST_ENUMERATOR) };
enum class Rectify : uint32_t { TAA_RECTIFY(UNGHOST_ENUMERATOR) };
enum class Where : uint32_t { TAA_WHERE(UNGHOST_ENUMERATOR) };
enum class Axes : uint32_t { TAA_AXES(UNGHOST_ENUMERATOR) };
enum class Reject : uint32_t { nothing = 0, TAA_REJECT(UNGHOST_ENUMERATOR) };
enum class Fill : uint32_t { TAA_FILL(UNGHOST_ENUMERATOR) };
enum class Blend : uint32_t { TAA_BLEND(UNGHOST_ENUMERATOR) };
enum class Input : uint32_t { TAA_INPUT(UNGHOST_ENUMERATOR) };
enum class Keeps : uint32_t { TAA_KEEPS(UNGHOST_ENUMERATOR) };
enum class Store : uint32_t { TAA_STORE(UNGHOST_ENUMERATOR) };
enum class TextureJitter : uint32_t { TAA_TEXTURE_JITTER(UNGHOST_ENUMERATOR) };
enum class Resolver : uint32_t { TAA_RESOLVER(UNGHOST_ENUMERATOR) };
#undef UNGHOST_ENUMERATOR

constexpr Reject operator|(Reject a, Reject b) { return Reject(uint32_t(a) | uint32_t(b)); }
constexpr bool has(Reject set, Reject test) { return (uint32_t(set) & uint32_t(test)) != 0; }

/// Which answer, column by column; each becomes a specialization constant of the resolve.
struct TaaPolicy {
  Jitter jitter = Jitter::none;
  Dilation dilation = Dilation::centre;
  HistoryFilter history = HistoryFilter::bilinear;
  Ringing ringing = Ringing::kept;
  Space space = Space::rgb;
  Weighting weighting = Weighting::none;
  Rectify rectify = Rectify::none;
  Where where = Where::everywhere;
  Axes axes = Axes::dop32;
  Reject reject = Reject::nothing;
  Fill fill = Fill::blurred;
  Blend blend = Blend::current;
  Input input = Input::sampled;
  Keeps keeps = Keeps::result;

  bool operator==(const TaaPolicy&) const = default;
  bool needs_history() const { return blend != Blend::current; }
  bool rejects(Reject tests) const { return needs_history() && has(reject, tests); }
  bool uses_dop() const { return rectify == Rectify::dop_clip || rectify == Rectify::dop_variance; }
  /// Axes that were found for linear RGB colours; the others are tight around a sphere, in any space.
  bool axes_are_of_rgb() const {
    return uses_dop() &&
           (axes == Axes::dop16_grass || axes == Axes::dop16_asphalt || axes == Axes::dop16_ours);
  }
  bool uses_variance() const {
    return rectify == Rectify::variance_clamp || rectify == Rectify::variance_clip ||
           rectify == Rectify::dop_variance;
  }
  bool needs_tags() const { return rejects(Reject::tag | Reject::near_moving); }
  bool needs_previous_motion() const {
    return rejects(Reject::velocity | Reject::motion_length | Reject::speed);
  }
  bool needs_previous_depth() const { return rejects(Reject::depth); }
  /// The history's alpha has one place: where keys take it, tags are kept with the objects.
  bool needs_previous_objects() const {
    return rejects(Reject::object) || (needs_key() && rejects(Reject::tag));
  }
  bool rectifies_unknown_only() const { return where == Where::unknown && rectify != Rectify::none; }
  /// What rejects, weighs or bounds by known causes asks for a key a pixel (shaders/shared/taa_key.h).
  bool needs_key() const {
    return needs_history() && (has(reject, Reject::moved_object | Reject::visibility) ||
                               blend == Blend::speed || rectifies_unknown_only());
  }
};

/// The answers, and how much of each. Metres, pixels a frame, shares.
struct TaaSettings {
  TaaPolicy policy;
  float alpha = 0.1f;               // weight of the current frame
  float gamma = 1.0f;               // variance: this many standard deviations
  float jitter_scale = 1.0f;        // 0 to 1, of a pixel
  float jitter_moving = 1.0f;       // share of it while the camera moves
  float motion_threshold_px = 1.0f; // near and moving, moved object: faster than this
  float near_m = 0.0f;              // near and moving: nearer than this, all of the history goes; 0: found
  float far_m = 0.0f;               // and beyond this, none; 0: found
  float velocity_min = 0.001f;      // velocity: a difference of this share of the picture's sides is none
  float velocity_slope = 10.0f;     // and each share beyond it rejects this much more
  // motion length: differs by more than this. A road that comes nearer is a pixel or two faster each frame;
  // what was hidden by a vehicle differs by more.
  float motion_length_px = 3.0f;
  float speed_px = 2.0f;     // speed: faster than this
  float depth_share = 0.1f;  // depth: differs by more than this share of it
  float fast_alpha = 0.52f;  // blend by speed: the weight of the current frame where the picture is
  float fast_px = 0.5f;      // so fast
  float zoom_weight = 4.0f;  // and by so much more for each share that it came nearer
  float centred_rest = 0.5f; // input centred: how much of it is taken at rest; where it is fast, all
  float cubic = 0.5f;        // history: the cubic filter's sharpness; 0.5 is Catmull-Rom
  float sharpen = 0.0f;      // after the resolve; 0: none
  float mip_bias = 0.0f;     // of the textures of what is drawn, -2 to 0
  TextureJitter texture_jitter = TextureJitter::kept;
  Resolver resolver = Resolver::fast;
  Store store = Store::dithered;

  bool operator==(const TaaSettings&) const = default;
};

struct TaaMode {
  std::string_view name;
  std::string_view summary; // one sentence
  std::string_view source;
  TaaSettings settings;
};

/// What is shown where nobody says.
constexpr std::string_view default_taa_mode = "unghost";

std::span<const TaaMode> taa_modes();
/// The row of that name, or nothing.
const TaaMode* find_taa_mode(std::string_view name);

} // namespace unghost
