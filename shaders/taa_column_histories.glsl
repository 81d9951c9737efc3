// The histories of a column of pixels, most of them read at once.
#ifndef UNGHOST_TAA_COLUMN_HISTORIES_GLSL
#define UNGHOST_TAA_COLUMN_HISTORIES_GLSL

#include "taa_column.glsl"

const int WINDOW_WIDTH = 5, WINDOW_HEIGHT = R + 4;

/// The four weights at one of two places of five.
float[5] placed(vec4 weights, bool later) {
  return later ? float[5](0, weights.x, weights.y, weights.z, weights.w)
               : float[5](weights.x, weights.y, weights.z, weights.w, 0);
}

/// A window of the history, from `corner` on; pixel i of the column looks i rows further down, and may look one more to
/// the right and down.
struct Window {
  ivec2 corner;
  vec3 texels[WINDOW_WIDTH * WINDOW_HEIGHT];
  float alphas[WINDOW_WIDTH * WINDOW_HEIGHT];
};

Window load_window(ivec2 corner) {
  Window w;
  w.corner = corner;
  for (int y = 0; y < WINDOW_HEIGHT; ++y)
    for (int x = 0; x < WINDOW_WIDTH; ++x) {
      vec4 texel = history_texel(corner + ivec2(x, y));
      w.texels[WINDOW_WIDTH * y + x] = texel.rgb;
      if (reads_alpha()) w.alphas[WINDOW_WIDTH * y + x] = texel.a;
    }
  return w;
}

/// As read_alphas.
vec4 alphas_in(Window w, int i, bvec2 later) {
  int at = WINDOW_WIDTH * (i + 1) + 1, below = at + WINDOW_WIDTH, last = below + WINDOW_WIDTH;
  vec3 first_row = vec3(w.alphas[at], w.alphas[at + 1], w.alphas[at + 2]),
       second_row = vec3(w.alphas[below], w.alphas[below + 1], w.alphas[below + 2]),
       third_row = vec3(w.alphas[last], w.alphas[last + 1], w.alphas[last + 2]);
  vec3 top = later.y ? second_row : first_row, bottom = later.y ? third_row : second_row;
  return later.x ? vec4(top.yz, bottom.yz) : vec4(top.xy, bottom.xy);
}

vec3 catmull_rom_in(Window w, int i, vec2 at) {
  vec2 f = fract(at - 0.5);
  bvec2 later = greaterThan(catmull_rom_corner(at) - ivec2(0, i), w.corner);
  float across[5] = placed(catmull_rom_weights(f.x), later.x), down[5] = placed(catmull_rom_weights(f.y), later.y);
  vec3 sum = vec3(0);
  for (int y = 0; y < 5; ++y) {
    vec3 row = vec3(0);
    for (int x = 0; x < 5; ++x) row += across[x] * w.texels[WINDOW_WIDTH * (i + y) + x];
    sum += down[y] * row;
  }
  return sum;
}

/// Without the corners: the middle two columns whole, of the outer two only the middle two rows.
vec3 catmull_rom_cross_in(Window w, int i, vec2 at) {
  vec2 f = fract(at - 0.5);
  bvec2 later = greaterThan(catmull_rom_corner(at) - ivec2(0, i), w.corner);
  vec4 across = catmull_rom_weights(f.x), down = catmull_rom_weights(f.y);
  float inner[5] = placed(vec4(0, across.yz, 0), later.x), outer[5] = placed(vec4(across.x, 0, 0, across.w), later.x),
        all_down[5] = placed(down, later.y), inner_down[5] = placed(vec4(0, down.yz, 0), later.y);
  vec3 sum = vec3(0);
  for (int y = 0; y < 5; ++y) {
    int row = WINDOW_WIDTH * (i + y);
    sum += all_down[y] * (inner[1] * w.texels[row + 1] + inner[2] * w.texels[row + 2] + inner[3] * w.texels[row + 3]);
    if (y > 0 && y < 4)
      sum += inner_down[y] * (outer[0] * w.texels[row] + outer[1] * w.texels[row + 1] + outer[3] * w.texels[row + 3] +
                              outer[4] * w.texels[row + 4]);
  }
  return sum * cross_scale(across, down);
}

/// The bounds of the four texels around `at`.
void bounds_in(Window w, int i, vec2 at, out vec3 low, out vec3 high) {
  bvec2 later = greaterThan(catmull_rom_corner(at) - ivec2(0, i), w.corner);
  int above = WINDOW_WIDTH * (i + 1) + 1, middle = above + WINDOW_WIDTH, below = middle + WINDOW_WIDTH;
  vec3 near = w.texels[middle + 1], beside = later.x ? w.texels[middle + 2] : w.texels[middle],
       far = later.y ? w.texels[below + 1] : w.texels[above + 1],
       across = later.x ? (later.y ? w.texels[below + 2] : w.texels[above + 2])
                        : (later.y ? w.texels[below] : w.texels[above]);
  low = min(min(near, beside), min(far, across)), high = max(max(near, beside), max(far, across));
}

Filtered filtered_in(Window w, int i, vec2 at) {
  Filtered r;
  r.colour = history_filter == history_catmull_rom_12 ? catmull_rom_cross_in(w, i, at) : catmull_rom_in(w, i, at);
  if (ringing == ringing_clamped) bounds_in(w, i, at, r.low, r.high);
  return r;
}

/// Pixels above one another mostly come from pixels above one another, give or take one: then 5 x (R + 4) loads do the
/// work of 16 x R. Those that come from elsewhere wait for another round.
void read_shared_histories(inout Reprojected r[R]) {
  bool done[R];
  ivec2 corners[R];
  for (int i = 0; i < R; ++i) done[i] = false, corners[i] = catmull_rom_corner(r[i].at) - ivec2(0, i);
  for (int round = 0; round < R; ++round) {
    ivec2 of_first = corners[R - 1];
    for (int i = R - 2; i >= 0; --i) of_first = done[i] ? of_first : corners[i];
    ivec2 corner = of_first;
    for (int i = 0; i < R; ++i)
      if (!done[i] && all(lessThanEqual(abs(corners[i] - of_first), ivec2(1)))) corner = min(corner, corners[i]);
    Window w = load_window(corner);
    bool all_done = true;
    for (int i = 0; i < R; ++i) {
      ivec2 off = corners[i] - w.corner;
      if (!done[i] && all(greaterThanEqual(off, ivec2(0))) && all(lessThanEqual(off, ivec2(1)))) {
        take_history(r[i], filtered_in(w, i, r[i].at));
        if (reads_alpha()) r[i].alphas = alphas_in(w, i, greaterThan(off, ivec2(0)));
        done[i] = true;
      }
      all_done = all_done && done[i];
    }
    if (all_done) break;
  }
}

void read_histories(inout Reprojected r[R]) {
  bool by_loads = history_filter == history_catmull_rom || history_filter == history_catmull_rom_16 ||
                  history_filter == history_catmull_rom_12;
  if (by_loads) read_shared_histories(r);
  else
    for (int i = 0; i < R; ++i) {
      take_history(r[i], read_history(r[i].at));
      if (reads_alpha()) r[i].alphas = read_alphas(r[i].at);
    }
}

#endif
