// The filters of FLIP: a weight of each filter at every tap, from the middle to one side.
#ifndef UNGHOST_FLIP_FILTERS_GLSL
#define UNGHOST_FLIP_FILTERS_GLSL

#include "shared/flip.h"

#define FLIP_TAP(i)                                                                                          \
  layout(constant_id = 7 * i) const float achromatic_##i = 0;                                                \
  layout(constant_id = 7 * i + 1) const float red_green_##i = 0;                                             \
  layout(constant_id = 7 * i + 2) const float blue_yellow_##i = 0;                                           \
  layout(constant_id = 7 * i + 3) const float blue_yellow_wide_##i = 0;                                      \
  layout(constant_id = 7 * i + 4) const float gaussian_##i = 0;                                              \
  layout(constant_id = 7 * i + 5) const float edge_##i = 0;                                                  \
  layout(constant_id = 7 * i + 6) const float point_##i = 0;
#define FLIP_COLOUR_TAP(i) vec4(achromatic_##i, red_green_##i, blue_yellow_##i, blue_yellow_wide_##i)
#define FLIP_FEATURE_TAP(i) vec3(gaussian_##i, edge_##i, point_##i)

FLIP_TAP(0) FLIP_TAP(1) FLIP_TAP(2) FLIP_TAP(3) FLIP_TAP(4) FLIP_TAP(5)
FLIP_TAP(6) FLIP_TAP(7) FLIP_TAP(8) FLIP_TAP(9) FLIP_TAP(10)

vec4 colour_taps[FLIP_TAPS] =
    vec4[](FLIP_COLOUR_TAP(0), FLIP_COLOUR_TAP(1), FLIP_COLOUR_TAP(2), FLIP_COLOUR_TAP(3), FLIP_COLOUR_TAP(4),
           FLIP_COLOUR_TAP(5), FLIP_COLOUR_TAP(6), FLIP_COLOUR_TAP(7), FLIP_COLOUR_TAP(8), FLIP_COLOUR_TAP(9),
           FLIP_COLOUR_TAP(10));
vec3 feature_taps[FLIP_TAPS] =
    vec3[](FLIP_FEATURE_TAP(0), FLIP_FEATURE_TAP(1), FLIP_FEATURE_TAP(2), FLIP_FEATURE_TAP(3), FLIP_FEATURE_TAP(4),
           FLIP_FEATURE_TAP(5), FLIP_FEATURE_TAP(6), FLIP_FEATURE_TAP(7), FLIP_FEATURE_TAP(8), FLIP_FEATURE_TAP(9),
           FLIP_FEATURE_TAP(10));

const int reach = int(FLIP_TAPS) - 1, batch = int(FLIP_BATCH);
/// What the filters at a batch of pixels see.
const int window_size = batch + 2 * reach;

#endif
