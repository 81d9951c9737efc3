// Reading the history between its pixels. `at` is in pixels, centres at .5; beyond the edge the edge goes on. Its alpha
// is the tag of what was there, or of a keyed row what it keeps of keys (taa_key.glsl).
#ifndef UNGHOST_HISTORY_GLSL
#define UNGHOST_HISTORY_GLSL

#include "taa_inputs.glsl"

/// Only these go through the sampler.
bool reads_by_taps() { return history_filter == history_catmull_rom_9 || history_filter == history_catmull_rom_5; }

vec4 history_texel(ivec2 pixel) {
  return reads_by_taps() ? texelFetch(history_sampler, inside(pixel), 0) : fetch(history_map, inside(pixel));
}

vec3 bilinear(vec2 at) {
  vec2 texel = at - 0.5, f = fract(texel);
  ivec2 corner = ivec2(floor(texel));
  vec3 top = mix(history_texel(corner).rgb, history_texel(corner + ivec2(1, 0)).rgb, f.x);
  vec3 bottom = mix(history_texel(corner + ivec2(0, 1)).rgb, history_texel(corner + 1).rgb, f.x);
  return mix(top, bottom, f.y);
}

/// Weights of the four texels around f, for the two in the middle lying at 0 and 1: the interpolating cubics of Keys 1981,
/// of which Catmull's and Rom's (1974) is that with c = 0.5.
vec4 catmull_rom_weights(float f) {
  float c = push.cubic;
  return vec4(((2 * c - c * f) * f - c) * f, ((2 - c) * f - (3 - c)) * f * f + 1, (((c - 2) * f + (3 - 2 * c)) * f + c) * f,
              (c * f - c) * f * f);
}

/// A colour, and the bounds of the four texels around it.
struct Filtered {
  vec3 colour, low, high;
};

ivec2 catmull_rom_corner(vec2 at) { return ivec2(floor(at - 0.5)) - 1; }

/// Without the corners, what makes the weights that remain one.
float cross_scale(vec4 across, vec4 down) { return 1 / (1 - (across.x + across.w) * (down.x + down.w)); }

/// 16 loads; or 12, without the corners, renormalised: the kernel of five taps.
Filtered catmull_rom_loads(vec2 at, bool corners) {
  ivec2 corner = catmull_rom_corner(at);
  vec2 f = fract(at - 0.5);
  vec4 across = catmull_rom_weights(f.x), down = catmull_rom_weights(f.y);
  Filtered r = Filtered(vec3(0), vec3(1e30), vec3(0));
  for (int y = 0; y < 4; ++y) {
    vec3 row[4];
    bool whole = corners || y == 1 || y == 2;
    for (int x = 0; x < 4; ++x)
      row[x] = whole || x == 1 || x == 2 ? history_texel(corner + ivec2(x, y)).rgb : vec3(0);
    if (corners)
      r.colour += down[y] * (across[0] * row[0] + across[1] * row[1] + across[2] * row[2] + across[3] * row[3]);
    else {  // in the order in which the fast resolve adds
      r.colour += down[y] * (across[1] * row[1] + across[2] * row[2]);
      if (whole) r.colour += down[y] * (across[0] * row[0] + across[3] * row[3]);
    }
    if (ringing == ringing_clamped && (y == 1 || y == 2))
      r.low = min(r.low, min(row[1], row[2])), r.high = max(r.high, max(row[1], row[2]));
  }
  if (!corners) r.colour *= cross_scale(across, down);
  return r;
}

vec3 tap(vec2 at) { return textureLod(history_sampler, at * frame.inverse_size_px, 0).rgb; }

/// The same kernel by 9 bilinear taps, the two weights in the middle joined into one (Sigg and Hadwiger 2005); or by 5,
/// without the corners, renormalised (Jimenez 2016).
Filtered catmull_rom_taps(vec2 at, bool corners) {
  vec2 middle = floor(at - 0.5) + 0.5, f = at - middle;
  vec4 across = catmull_rom_weights(f.x), down = catmull_rom_weights(f.y);
  vec3 x = vec3(across.x, across.y + across.z, across.w), y = vec3(down.x, down.y + down.z, down.w);
  vec2 joined = middle + vec2(across.z / x.y, down.z / y.y), before = middle - 1, after = middle + 2;
  vec3 sum = x.y * y.x * tap(vec2(joined.x, before.y)) + x.x * y.y * tap(vec2(before.x, joined.y)) +
             x.y * y.y * tap(joined) + x.z * y.y * tap(vec2(after.x, joined.y)) +
             x.y * y.z * tap(vec2(joined.x, after.y));
  if (corners)
    sum += x.x * y.x * tap(before) + x.z * y.x * tap(vec2(after.x, before.y)) +
           x.x * y.z * tap(vec2(before.x, after.y)) + x.z * y.z * tap(after);
  else sum /= x.y * y.x + x.x * y.y + x.y * y.y + x.z * y.y + x.y * y.z;
  Filtered r = Filtered(sum, vec3(1e30), vec3(0));
  if (ringing == ringing_clamped)
    for (int i = 0; i < 4; ++i) {
      vec3 colour = history_texel(ivec2(middle) + ivec2(i & 1, i >> 1)).rgb;
      r.low = min(r.low, colour), r.high = max(r.high, colour);
    }
  return r;
}

Filtered unbounded(vec3 colour) { return Filtered(colour, colour, colour); }

Filtered read_history(vec2 at) {
  switch (history_filter) {
  case history_nearest: return unbounded(history_texel(ivec2(floor(at))).rgb);
  case history_bilinear: return unbounded(bilinear(at));
  case history_catmull_rom_9: return catmull_rom_taps(at, true);
  case history_catmull_rom_5: return catmull_rom_taps(at, false);
  case history_catmull_rom_12: return catmull_rom_loads(at, false);
  default: return catmull_rom_loads(at, true);
  }
}

/// The alphas of the four pixels that it comes from: x first, then y.
vec4 read_alphas(vec2 at) {
  ivec2 corner = ivec2(floor(at - 0.5));
  vec4 alphas;
  for (int i = 0; i < 4; ++i) alphas[i] = history_texel(corner + ivec2(i & 1, i >> 1)).a;
  return alphas;
}

/// How many frames the history holds there.
float read_count(vec2 at) {
  ivec2 pixel = min(inside(ivec2(floor(at))), size_of(previous_count_map) - 1);  // 1x1 where none was kept
  return max(fetch(previous_count_map, pixel).r, 1);
}

#endif
