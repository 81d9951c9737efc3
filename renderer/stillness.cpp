#include "renderer/stillness.h"

#include <algorithm>

#include "renderer/view.h"

namespace unghost {
namespace {

constexpr double invisible = 1.0 / 512; // half a step of 8 bits
constexpr uint32_t most_frames_held = 1024;

/// Along a line, and not each component by itself; nothing at rest, where only what is unknown is bounded.
bool clips(const TaaPolicy& policy) {
  if (policy.rectifies_unknown_only()) return false;
  return policy.uses_dop() || policy.rectify == Rectify::box_clip || policy.rectify == Rectify::variance_clip;
}

/// What moves between two moments.
std::string motion_between(const Instant& a, const Instant& b, bool animated) {
  if (a.eye != b.eye || a.camera != b.camera || a.vertical_fov != b.vertical_fov ||
      a.near_plane != b.near_plane)
    return "the camera moves";
  if (a.vehicle != b.vehicle || a.wheel_travel != b.wheel_travel || a.steer != b.steer)
    return "the vehicle moves";
  if (a.towards_sun != b.towards_sun) return "the sun moves";
  if (animated && a.animation_s != b.animation_s) return "an animation plays";
  return {};
}

} // namespace

std::optional<uint32_t> frames_until_settled(const TaaSettings& taa) {
  const TaaPolicy& policy = taa.policy;
  if (!policy.needs_history()) return 1;
  if (clips(policy) && policy.jitter != Jitter::none) return std::nullopt;
  const bool counting = policy.blend == Blend::counting, one_input = policy.keeps == Keeps::input;
  const double least = policy.blend == Blend::attenuated ? taa.alpha / 4 : taa.alpha;
  uint32_t frames = 1; // drawn; of the first of them `left` is
  for (double left = one_input ? 0 : 1; left > invisible && frames < most_frames_held; ++frames)
    left *= 1 - (counting ? std::max(least, 1.0 / (frames + 1)) : least);
  const uint32_t cycle = jitter_cycle(policy.jitter);
  return (frames + cycle - 1) / cycle * cycle + (one_input ? cycle : 0);
}

std::string Stillness::change_to(const FrameInput& input) const {
  if (std::string motion = motion_between(input.before, input.now, animated_); !motion.empty()) return motion;
  if (!last_) return {};
  if (std::string motion = motion_between(last_->now, input.now, animated_); !motion.empty()) return motion;
  const bool same = last_->settings == input.settings && last_->modes == input.modes &&
                    last_->width == input.width && last_->height == input.height &&
                    last_->jitter_px == input.jitter_px;
  return same ? "" : "the settings change";
}

std::optional<uint32_t> Stillness::frames_left(const FrameInput& input) {
  change_ = change_to(input);
  if (!change_.empty() || input.cut) at_rest_ = 0;
  last_ = input;
  uint32_t needed = 1;
  const uint32_t drawn = at_rest_++;
  for (const ModeRun& run : input.modes) {
    const std::optional<uint32_t> of_mode = frames_until_settled(run.taa);
    if (!of_mode) return std::nullopt;
    needed = std::max(needed, *of_mode);
  }
  return needed - std::min(needed, drawn);
}

} // namespace unghost
