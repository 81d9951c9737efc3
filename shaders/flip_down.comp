// FLIP's first pass, of one picture: its colours filtered down the columns. An invocation goes down a band of
// a column; what its filters see moves along with it, so that each texel is loaded and decoded once a band.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#include "flip_colour.glsl"
#include "flip_filters.glsl"
#include "shared/workgroup.h"

layout(local_size_x = WORKGROUP_WIDTH) in;

layout(set = 0, binding = FLIP_DISPLAY, rgba8) uniform readonly image2D display;
layout(set = 0, binding = FLIP_COLOURS, rgba32f) uniform writeonly image2D colours_out;
layout(set = 0, binding = FLIP_FEATURES, rgba32f) uniform writeonly image2D features_out;
layout(push_constant, scalar) uniform Push { ivec2 size_px; };

/// sRGB as lightness and two opponent colours, linear (YyCxCz).
vec3 opponent(vec3 srgb) {
  vec3 c = mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThanEqual(srgb, vec3(0.04045)));
  vec3 xyz = xyz_over_white(c);
  return vec3(116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z));
}

/// The edge goes on.
vec3 opponent_at(int x, int y) {
  return opponent(imageLoad(display, ivec2(x, clamp(y, 0, size_px.y - 1))).rgb);
}

void main() {
  int x = int(gl_GlobalInvocationID.x), first = int(gl_WorkGroupID.y * FLIP_BAND_ROWS);
  if (x >= size_px.x) return;
  int last = min(first + int(FLIP_BAND_ROWS), size_px.y);
  vec3 seen[window_size];
  [[unroll]] for (int i = 0; i < 2 * reach; ++i) seen[batch + i] = opponent_at(x, first - reach + i);
  [[dont_unroll]] for (int y = first; y < last; y += batch) {
    [[unroll]] for (int i = 0; i < 2 * reach; ++i) seen[i] = seen[batch + i];
    [[unroll]] for (int i = 0; i < batch; ++i) seen[2 * reach + i] = opponent_at(x, y + reach + i);
    [[unroll]] for (int row = 0; row < batch; ++row) {
      vec3 middle = seen[reach + row];
      vec4 colours = colour_taps[0] * middle.xyzz;
      vec3 features = feature_taps[0] * middle.x;
      [[unroll]] for (int i = 1; i <= reach; ++i) {
        vec3 up = seen[reach + row - i], down = seen[reach + row + i], both = up + down;
        colours += colour_taps[i] * both.xyzz;
        features += feature_taps[i] * vec3(both.x, up.x - down.x, both.x);
      }
      // beyond the picture nothing is stored
      imageStore(colours_out, ivec2(x, y + row), colours);
      imageStore(features_out, ivec2(x, y + row), vec4(features, 0));
    }
  }
}
