// What can be drawn in place of the finished picture, to see why a pixel ghosts.
#ifndef UNGHOST_SHARED_VIEWS_H
#define UNGHOST_SHARED_VIEWS_H

#include "language.h"

#define UNGHOST_VIEWS(X)                                                                                     \
  X(view, colour, 0) X(view, albedo, 1) X(view, normal, 2) X(view, depth, 3) X(view, motion, 4)              \
  X(view, tag, 5) X(view, shadow, 6) X(view, weight, 7) X(view, rectified, 8) X(view, tag_rejected, 9)       \
  X(view, near_moving, 10) X(view, rejected, 11) X(view, history, 12) X(view, age, 13) X(view, volume, 14)     \
  X(view, light_channel, 15) X(view, pixel_class, 16)

#ifndef __cplusplus
#define VIEW_CONSTANT(column, answer, value) const uint column##_##answer = value;
UNGHOST_VIEWS(VIEW_CONSTANT)
#endif

#endif
