#include "app/measure/kept_frames.h"

#include <algorithm>

#include "app/measure/measure_parts.h"

namespace unghost {
namespace {

constexpr const char* reference_name = "reference";

std::string five_digits(uint32_t frame) {
  const std::string number = std::to_string(frame);
  return std::string(5 - std::min<size_t>(5, number.size()), '0') + number;
}

} // namespace

std::string picture_file(const std::string& kind, const std::string& of, uint32_t frame) {
  return kind + "-" + of + "-" + five_digits(frame) + ".png";
}

void FrameKeeper::offer(const OfferedFrame& offered) {
  if (m_.keep == Keep::none) return;
  if (m_.keep == Keep::all) {
    m_.save(picture_file(kind_, m_.modes[offered.mode].name, offered.frame), offered.picture);
    if (offered.mode == 0) m_.save(picture_file(kind_, reference_name, offered.frame), offered.reference);
  }
  Kept& best = best_[offered.mode];
  if (best.any && !latest_ && offered.flip <= best.flip) return;
  best = {.any = true, .frame = offered.frame, .flip = offered.flip, .picture = offered.picture};
  references_.try_emplace(offered.frame, offered.reference);
  std::erase_if(references_, [&](const auto& reference) {
    return std::ranges::none_of(best_,
                                [&](const Kept& kept) { return kept.any && kept.frame == reference.first; });
  });
}

void FrameKeeper::finish(Measured& into) {
  for (const auto& [frame, reference] : references_)
    if (m_.keep == Keep::worst) m_.save(picture_file(kind_, reference_name, frame), reference);
  for (size_t mode = 0; mode < best_.size(); ++mode) {
    const Kept& kept = best_[mode];
    if (!kept.any) continue;
    const std::string name = m_.modes[mode].name, picture = picture_file(kind_, name, kept.frame);
    if (m_.keep == Keep::worst) m_.save(picture, kept.picture);
    into.kept.push_back({.kind = kind_,
                         .mode = name,
                         .frame = kept.frame,
                         .flip = rounded(kept.flip),
                         .picture = picture,
                         .reference = picture_file(kind_, reference_name, kept.frame)});
  }
}

} // namespace unghost
