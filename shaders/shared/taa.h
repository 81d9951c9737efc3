// The questions that every temporal resolve answers, and the answers there are. Each answer stands here once:
// C++ makes an enumerator and its spelling out of it, GLSL the constant that its `switch` compares with.
#ifndef UNGHOST_SHARED_TAA_H
#define UNGHOST_SHARED_TAA_H

#include "language.h"

#define TAA_JITTER(X) X(jitter, none, 0) X(jitter, halton_8, 1)
#define TAA_DILATION(X) X(dilation, centre, 0) X(dilation, closest_depth, 1)
#define TAA_HISTORY(X) X(history, bilinear, 0) X(history, catmull_rom, 1)
#define TAA_RECTIFY(X) X(rectify, none, 0) X(rectify, box_clamp, 1)
#define TAA_REJECT(X) X(reject, off_screen, 1) X(reject, tag, 2) X(reject, near_moving, 4)
#define TAA_BLEND(X) X(blend, current, 0) X(blend, constant, 1)

#ifndef __cplusplus
#define TAA_CONSTANT(column, answer, value) const uint column##_##answer = value;
TAA_JITTER(TAA_CONSTANT)
TAA_DILATION(TAA_CONSTANT)
TAA_HISTORY(TAA_CONSTANT)
TAA_RECTIFY(TAA_CONSTANT)
TAA_REJECT(TAA_CONSTANT)
TAA_BLEND(TAA_CONSTANT)
#endif

SHARED_BEGIN

/// How much of each answer; push constants of the resolve.
struct TaaPush {
  float alpha;
  float motion_threshold_px;
  float near_m, far_m;
  uint frame; // seeds the rounding
};

SHARED_END

#endif
