// Shimmer: the world at rest, jittered; what changes between frames is the resolve's doing.
#include <optional>

#include "app/measure/kept_frames.h"
#include "app/measure/measure_parts.h"

namespace unghost {
namespace {

void take(const Measurement& m, FrameResult& result, std::vector<std::optional<SeenPicture>>& last,
          Measured& into) {
  for (size_t mode = 0; mode < m.modes.size(); ++mode) {
    SeenPicture now = seen(result.delivered[mode].picture);
    if (last[mode]) add_sample(into.rows[mode], "shimmer", mean_flip(*last[mode], now));
    last[mode] = std::move(now);
  }
}

void keep_all(const Measurement& m, uint32_t frame, const FrameResult& result) {
  for (size_t mode = 0; mode < m.modes.size() && m.keep == Keep::all; ++mode)
    m.save(picture_file("shimmer", m.modes[mode].name, frame), result.delivered[mode].picture);
}

} // namespace

void measure_rest(const Measurement& m, Measured& into) {
  std::vector<std::optional<SeenPicture>> last(m.modes.size());
  for (uint32_t frame = 0; frame <= last_frame(m.protocol) + 1; ++frame) {
    FrameInput input = at_rest(m.film, m.protocol.fill);
    input.cut = frame == 0;
    input.index = frame;
    input.modes = m.modes;
    if (frame >= m.protocol.fill)
      for (size_t mode = 0; mode < m.modes.size(); ++mode) input.wanted.push_back({Output::display, mode});
    FrameResult result = m.film.draw(input);
    if (frame < m.protocol.fill) continue;
    keep_all(m, frame, result);
    take(m, result, last, into);
  }
  set_means(into, "shimmer");
}

} // namespace unghost
