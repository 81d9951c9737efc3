// FLIP's second pass: both pictures filtered along the rows, seen as an eye sees them, and compared. An
// invocation goes along a band of a row; what its filters see moves along with it.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_control_flow_attributes : require
#include "flip_colour.glsl"
#include "flip_filters.glsl"

layout(local_size_x = FLIP_GROUP_BANDS, local_size_y = FLIP_GROUP_ROWS) in;

layout(set = 0, binding = FLIP_COLOURS, rgba32f) uniform readonly image2D reference_colours;
layout(set = 0, binding = FLIP_FEATURES, rgba32f) uniform readonly image2D reference_features;
layout(set = 0, binding = FLIP_TEST_COLOURS, rgba32f) uniform readonly image2D test_colours;
layout(set = 0, binding = FLIP_TEST_FEATURES, rgba32f) uniform readonly image2D test_features;
layout(set = 0, binding = FLIP_OUT, r32f) uniform writeonly image2D error_out;
layout(push_constant, scalar) uniform Push { ivec2 size_px; };

float lab_root(float t) {
  const float d = FLIP_LAB_DELTA;
  return t > d * d * d ? pow(t, 1.0 / 3) : t / (3 * d * d) + 4.0 / 29;
}

/// CIELab after Hunt's effect, of linear light: colours weigh less where it is dark.
vec3 hunted(vec3 c) {
  vec3 xyz = xyz_over_white(c);
  float x = lab_root(xyz.x), y = lab_root(xyz.y), z = lab_root(xyz.z), l = 116 * y - 16;
  return vec3(l, FLIP_HUNT * l * 500 * (x - y), FLIP_HUNT * l * 200 * (y - z));
}

/// From filtered opponent colours, which may lie outside of what a screen shows.
vec3 hunted_opponent(vec3 filtered) {
  float y = (filtered.x + 16) / 116;
  vec3 xyz = vec3((y + filtered.y / 500) * FLIP_WHITE_X, y, (y - filtered.z / 200) * FLIP_WHITE_Z);
  return hunted(clamp(vec3(dot(vec3(FLIP_RED_OF_X, FLIP_RED_OF_Y, FLIP_RED_OF_Z), xyz),
                           dot(vec3(FLIP_GREEN_OF_X, FLIP_GREEN_OF_Y, FLIP_GREEN_OF_Z), xyz),
                           dot(vec3(FLIP_BLUE_OF_X, FLIP_BLUE_OF_Y, FLIP_BLUE_OF_Z), xyz)),
                      0, 1));
}

float power(float x, float p) { return x > 0 ? pow(x, p) : 0; }

float colour_distance(vec3 p, vec3 q) {
  return power(abs(p.x - q.x) + distance(p.yz, q.yz), FLIP_DISTANCE_POWER);
}

struct Seen {
  vec3 lab;
  vec2 features; // how strong edges and points are
};

float error_between(Seen r, Seen t) {
  float most = colour_distance(hunted(vec3(0, 1, 0)), hunted(vec3(0, 0, 1))), knee = FLIP_KNEE * most;
  float far = colour_distance(r.lab, t.lab);
  float above = FLIP_AT_KNEE + (far - knee) / (most - knee) * FLIP_ABOVE_KNEE;
  float colour = far < knee ? FLIP_AT_KNEE / knee * far : above;
  vec2 apart = abs(r.features - t.features) / FLIP_LIGHTNESS_RANGE;
  return power(colour, 1 - sqrt(max(apart.x, apart.y) * FLIP_FEATURE_SHARE));
}

struct Window {
  vec4 colours[window_size];
  vec3 features[window_size];
};

/// The edge goes on.
ivec2 place(int x, int y) { return ivec2(clamp(x, 0, size_px.x - 1), y); }

#define LOAD(window, at, picture, x, y)                                                                      \
  window.colours[at] = imageLoad(picture##_colours, place(x, y));                                            \
  window.features[at] = imageLoad(picture##_features, place(x, y)).xyz

/// Around the middle of a window's pixel, so many after its first.
Seen seen_at(Window window, int middle) {
  vec4 colours = colour_taps[0] * window.colours[middle];
  vec3 features = window.features[middle];
  vec2 edge = vec2(0, feature_taps[0].x * features.y), point = feature_taps[0].zx * features.xz;
  [[unroll]] for (int i = 1; i <= reach; ++i) {
    colours += colour_taps[i] * (window.colours[middle - i] + window.colours[middle + i]);
    vec3 before = window.features[middle - i], after = window.features[middle + i], both = before + after;
    edge += feature_taps[i].yx * vec2(before.x - after.x, both.y);
    point += feature_taps[i].zx * both.xz;
  }
  return Seen(hunted_opponent(vec3(colours.xy, colours.z + colours.w)), vec2(length(edge), length(point)));
}

void main() {
  int first = int(gl_GlobalInvocationID.x * FLIP_BAND_COLUMNS), y = int(gl_GlobalInvocationID.y);
  if (first >= size_px.x || y >= size_px.y) return;
  int last = min(first + int(FLIP_BAND_COLUMNS), size_px.x);
  Window reference, test;
  [[unroll]] for (int i = 0; i < 2 * reach; ++i) {
    LOAD(reference, batch + i, reference, first - reach + i, y);
    LOAD(test, batch + i, test, first - reach + i, y);
  }
  [[dont_unroll]] for (int x = first; x < last; x += batch) {
    [[unroll]] for (int i = 0; i < 2 * reach; ++i) {
      reference.colours[i] = reference.colours[batch + i],
      reference.features[i] = reference.features[batch + i];
      test.colours[i] = test.colours[batch + i], test.features[i] = test.features[batch + i];
    }
    [[unroll]] for (int i = 0; i < batch; ++i) {
      LOAD(reference, 2 * reach + i, reference, x + reach + i, y);
      LOAD(test, 2 * reach + i, test, x + reach + i, y);
    }
    // beyond the picture nothing is stored
    [[unroll]] for (int i = 0; i < batch; ++i)
        imageStore(error_out, ivec2(x + i, y),
                   vec4(error_between(seen_at(reference, reach + i), seen_at(test, reach + i))));
  }
}
