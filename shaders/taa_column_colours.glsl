// The colours around a column of pixels, and what they make of its histories.
#ifndef UNGHOST_TAA_COLUMN_COLOURS_GLSL
#define UNGHOST_TAA_COLUMN_COLOURS_GLSL

#include "shared/taa_axes.h"
#include "taa_column.glsl"

/// Three columns of colours, row by row, in the working space; and each row's 1 2 1 of linear colours.
struct Strip {
  vec3 colours[3 * COLUMN];
  vec3 centres[COLUMN];  // linear
  vec3 blurred_rows[COLUMN];
  vec3 centred_rows[COLUMN];
};

Strip gather(ivec2 first) {
  Strip s;
  int last_y = last_pixel().y, last_x = last_pixel().x;
  int left = max(first.x - 1, 0), right = min(first.x + 1, last_x);
  vec3 weights = centred_weights(frame.jitter_px.x);
  for (int y = 0; y < COLUMN; ++y) {
    int at = clamp(first.y + y - 1, 0, last_y);
    vec3 a = colour_at(ivec2(left, at)), b = colour_at(ivec2(first.x, at)), c = colour_at(ivec2(right, at));
    s.centres[y] = b;
    if (needs_blurred()) s.blurred_rows[y] = (a + c) + 2 * b;
    if (centres_input()) s.centred_rows[y] = weights.x * a + weights.y * b + weights.z * c;
    s.colours[3 * y] = to_working(a), s.colours[3 * y + 1] = to_working(b), s.colours[3 * y + 2] = to_working(c);
  }
  return s;
}

/// The box of each pixel's neighbourhood.
void boxes_of(Strip s, out vec3 low[R], out vec3 high[R]) {
  vec3 low_row[COLUMN], high_row[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    low_row[y] = min(min(s.colours[3 * y], s.colours[3 * y + 1]), s.colours[3 * y + 2]);
    high_row[y] = max(max(s.colours[3 * y], s.colours[3 * y + 1]), s.colours[3 * y + 2]);
  }
  for (int i = 0; i < R; ++i) {
    low[i] = min(min(low_row[i], low_row[i + 1]), low_row[i + 2]);
    high[i] = max(max(high_row[i], high_row[i + 1]), high_row[i + 2]);
  }
}

/// The frame at the middle of a pixel of the column.
vec3 centred_of(Strip s, int i) {
  vec3 down = centred_weights(frame.jitter_px.y);
  return down.x * s.centred_rows[i] + down.y * s.centred_rows[i + 1] + down.z * s.centred_rows[i + 2];
}

/// The box of mean and standard deviation.
void variance_boxes_of(Strip s, out vec3 low[R], out vec3 high[R]) {
  vec3 means[COLUMN], squares[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    ROW_MOMENTS(s.colours[3 * y], s.colours[3 * y + 1], s.colours[3 * y + 2], means[y], squares[y]);
  }
  for (int i = 0; i < R; ++i) {
    NINE_MOMENTS(vec3, i, means, squares, mean, reach);
    low[i] = mean - reach, high[i] = mean + reach;
  }
}

/// The slab across `axis`, for each pixel: what it leaves of the segment to its history.
void clip_along(vec3 axis, Strip s, vec3 histories[R], inout float share[R]) {
  float own[COLUMN], low[COLUMN], high[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    float a = dot(s.colours[3 * y], axis), b = dot(s.colours[3 * y + 1], axis), c = dot(s.colours[3 * y + 2], axis);
    own[y] = b, low[y] = min(min(a, b), c), high[y] = max(max(a, b), c);
  }
  for (int i = 0; i < R; ++i)
    share[i] = min(share[i], slab_share(min(min(low[i], low[i + 1]), low[i + 2]),
                                        max(max(high[i], high[i + 1]), high[i + 2]), own[i + 1],
                                        dot(histories[i], axis)));
}

void clip_variance_along(vec3 axis, Strip s, vec3 histories[R], inout float share[R]) {
  float own[COLUMN], means[COLUMN], squares[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    float a = dot(s.colours[3 * y], axis), b = dot(s.colours[3 * y + 1], axis), c = dot(s.colours[3 * y + 2], axis);
    own[y] = b;
    ROW_MOMENTS(a, b, c, means[y], squares[y]);
  }
  for (int i = 0; i < R; ++i) {
    NINE_MOMENTS(float, i, means, squares, mean, reach);
    float from = own[i + 1];
    share[i] = min(share[i], slab_share(min(mean - reach, from), max(mean + reach, from), from, dot(histories[i], axis)));
  }
}

void rectify_histories(Strip s, vec3 found[R], out vec3 bounded[R]) {
  float share[R];
  for (int i = 0; i < R; ++i) share[i] = 1e30;
  if (rectify == rectify_dop_clip || rectify == rectify_dop_variance) {
#define AXIS(x, y, z)                                                                                        \
  if (rectify == rectify_dop_clip) clip_along(vec3(x, y, z), s, found, share);                               \
  else clip_variance_along(vec3(x, y, z), s, found, share);
    TAA_EACH_AXIS
#undef AXIS
    for (int i = 0; i < R; ++i) bounded[i] = on_segment(s.colours[3 * i + 4], found[i], share[i]);
    return;
  }
  vec3 low[R], high[R];
  if (rectify == rectify_box_clamp || rectify == rectify_box_clip) boxes_of(s, low, high);
  else variance_boxes_of(s, low, high);
  float brightest[COLUMN];
  for (int y = 0; y < COLUMN && may_brighten(); ++y)
    brightest[y] = max(max(weighted_luminance(s.colours[3 * y]), weighted_luminance(s.colours[3 * y + 1])),
                       weighted_luminance(s.colours[3 * y + 2]));
  for (int i = 0; i < R; ++i) {
    vec3 centre = s.colours[3 * i + 4];
    if (may_brighten())
      bounded[i] = not_brighter(clamp(found[i], low[i], high[i]), found[i],
                                max(max(brightest[i], brightest[i + 1]), brightest[i + 2]));
    else if (rectify == rectify_box_clamp || rectify == rectify_variance_clamp) bounded[i] = clamp(found[i], low[i], high[i]);
    else bounded[i] = clip_to_box(found[i], centre, min(low[i], centre), max(high[i], centre));
  }
}

#endif
