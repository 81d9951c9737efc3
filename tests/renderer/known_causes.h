// All answers that ask for keys, at once.
#pragma once

#include "renderer/settings.h"

namespace unghost {

inline ModeRun known_causes(Where where) {
  return {"known causes",
          {.policy = {.jitter = Jitter::r2_10,
                      .dilation = Dilation::depth_edges,
                      .history = HistoryFilter::catmull_rom_12,
                      .ringing = Ringing::clamped,
                      .rectify = Rectify::box_clip,
                      .where = where,
                      .reject = Reject::off_screen | Reject::moved_object | Reject::visibility,
                      .fill = Fill::plain,
                      .blend = Blend::speed,
                      .input = Input::centred},
           .alpha = 0.08f,
           .jitter_scale = 0.85f}};
}

} // namespace unghost
