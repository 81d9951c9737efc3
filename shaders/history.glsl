// Reading the history between its pixels. `at` is in pixels, centres at .5; beyond the edge the edge goes on.
#ifndef UNGHOST_HISTORY_GLSL
#define UNGHOST_HISTORY_GLSL

vec3 history_texel(texture2D map, ivec2 pixel, ivec2 last) {
  return texelFetch(map, clamp(pixel, ivec2(0), last), 0).rgb;
}

vec3 bilinear(texture2D map, vec2 at, ivec2 last) {
  vec2 texel = at - 0.5, f = fract(texel);
  ivec2 corner = ivec2(floor(texel));
  vec3 top = mix(history_texel(map, corner, last), history_texel(map, corner + ivec2(1, 0), last), f.x);
  vec3 bottom = mix(history_texel(map, corner + ivec2(0, 1), last), history_texel(map, corner + 1, last), f.x);
  return mix(top, bottom, f.y);
}

/// Weights of the four taps around f, for the two in the middle lying at 0 and 1 (Catmull and Rom 1974).
vec4 catmull_rom_weights(float f) {
  return vec4(((-0.5 * f + 1) * f - 0.5) * f, (1.5 * f - 2.5) * f * f + 1, ((-1.5 * f + 2) * f + 0.5) * f,
              (0.5 * f - 0.5) * f * f);
}

/// 16 loads. Overshoots, but never below 0.
vec3 catmull_rom(texture2D map, vec2 at, ivec2 last) {
  vec2 texel = at - 0.5, f = fract(texel);
  ivec2 corner = ivec2(floor(texel)) - 1;
  vec4 across = catmull_rom_weights(f.x), down = catmull_rom_weights(f.y);
  vec3 sum = vec3(0);
  for (int y = 0; y < 4; ++y) {
    vec3 row = vec3(0);
    for (int x = 0; x < 4; ++x) row += across[x] * history_texel(map, corner + ivec2(x, y), last);
    sum += down[y] * row;
  }
  return max(sum, vec3(0));
}

#endif
