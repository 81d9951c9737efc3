// One picture's part of the window. Where it is as large as it is shown, its pixels are copied. Enlarged, it is filtered
// by Catmull-Rom and kept within the four texels around, so that no edge rings; reduced, by area. An invocation does
// SCREEN_ROWS pixels above one another: each row of texels is loaded and filtered across once for all of them.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/magma.h"
#include "shared/screen.h"
#include "shared/workgroup.h"

layout(local_size_x = WORKGROUP_WIDTH) in;

layout(constant_id = 0) const uint mode = 0;
layout(constant_id = 1) const uint shows = SCREEN_SHOWS_PICTURE;
layout(constant_id = 2) const uint scaling = SCREEN_COPIED;
layout(constant_id = 3) const int columns = 1;
layout(constant_id = 4) const int rows = 1;
layout(constant_id = 5) const bool magnified = false;

layout(set = 0, binding = SCREEN_PICTURE_0, rgba8) uniform readonly image2D picture_0;
layout(set = 0, binding = SCREEN_PICTURE_1, rgba8) uniform readonly image2D picture_1;
layout(set = 0, binding = SCREEN_PICTURE_2, rgba8) uniform readonly image2D picture_2;
layout(set = 0, binding = SCREEN_PICTURE_3, rgba8) uniform readonly image2D picture_3;
layout(set = 0, binding = SCREEN_ERROR, r32f) uniform readonly image2D error_map;
layout(set = 0, binding = SCREEN_OUT, rgba8) uniform writeonly image2D screen_out;
layout(push_constant, scalar) uniform Push { ScreenPush push; };

const int R = int(SCREEN_ROWS);
const float light = 1, dark = 0.06;

vec3 colour_of(ivec2 texel) {
  switch (mode) {
  case 0: return imageLoad(picture_0, texel).rgb;
  case 1: return imageLoad(picture_1, texel).rgb;
  case 2: return imageLoad(picture_2, texel).rgb;
  default: return imageLoad(picture_3, texel).rgb;
  }
}

/// What is filtered: of a difference, its sign is still there.
vec3 texel_at(ivec2 at) {
  ivec2 texel = clamp(at, ivec2(0), push.picture_px - 1);
  switch (shows) {
  case SCREEN_SHOWS_DIFFERENCE: return colour_of(texel) - imageLoad(picture_1, texel).rgb;
  case SCREEN_SHOWS_ERROR: return imageLoad(error_map, texel).rrr;
  default: return colour_of(texel);
  }
}

vec3 magma(float t) {
  vec3 colour = vec3(0);
#define MAGMA_TERM(red, green, blue) colour = vec3(red, green, blue) + t * colour;
  MAGMA_TERMS(MAGMA_TERM)
#undef MAGMA_TERM
  return clamp(colour, 0, 1);
}

vec3 shown(vec3 filtered) {
  if (shows == SCREEN_SHOWS_PICTURE) return filtered;
  if (shows == SCREEN_SHOWS_ERROR) return magma(clamp(filtered.r, 0, 1));
  vec3 each = abs(filtered);
  return magma(min(max(max(each.r, each.g), each.b) * SCREEN_DIFFERENCE_GAIN, 1));
}

/// Catmull and Rom 1974, at so many texels from the middle.
float catmull_rom(float far) {
  float near_part = (1.5 * far - 2.5) * far * far + 1, far_part = ((-0.5 * far + 2.5) * far - 4) * far + 2;
  return far < 1 ? near_part : far < 2 ? far_part : 0;
}

vec2 texels_a_pixel() { return vec2(push.picture_px) / vec2(push.picture.width, push.picture.height); }

/// Where the middle of a window's pixel lies in the picture.
vec2 place_of(ivec2 pixel) { return (vec2(pixel - ivec2(push.picture.x, push.picture.y)) + 0.5) * texels_a_pixel(); }

void enlarge(ivec2 first, out vec3 colours[R]) {
  vec2 at = place_of(first);
  ivec2 corner = ivec2(floor(at - 0.5)) - 1;
  float f = at.x - 0.5 - float(corner.x + 1), step_down = texels_a_pixel().y;
  vec4 across = vec4(catmull_rom(1 + f), catmull_rom(f), catmull_rom(1 - f), catmull_rom(2 - f));
  vec3 low[R], high[R];
  for (int i = 0; i < R; ++i) colours[i] = vec3(0), low[i] = vec3(1), high[i] = vec3(-1);
  for (int y = 0; y < rows; ++y) {
    ivec2 from = corner + ivec2(0, y);
    vec3 b = texel_at(from + ivec2(1, 0)), c = texel_at(from + ivec2(2, 0));
    vec3 row = across[0] * texel_at(from) + across[1] * b + across[2] * c + across[3] * texel_at(from + ivec2(3, 0));
    vec3 row_low = min(b, c), row_high = max(b, c);
    for (int i = 0; i < R; ++i) {
      float far = abs(at.y + float(i) * step_down - 0.5 - float(from.y));
      colours[i] += catmull_rom(far) * row;
      low[i] = far < 1 ? min(low[i], row_low) : low[i], high[i] = far < 1 ? max(high[i], row_high) : high[i];
    }
  }
  for (int i = 0; i < R; ++i) colours[i] = clamp(colours[i], low[i], high[i]);
}

/// How much of a texel so far from the middle lies in a box that is `size` texels wide.
float in_box(float far, float size) { return clamp((size + 1) * 0.5 - far, 0, 1) / size; }

/// Of light, which the square of a colour nearly is; differences and errors are none.
vec3 light_at(ivec2 texel) {
  vec3 colour = texel_at(texel);
  return shows == SCREEN_SHOWS_PICTURE ? colour * colour : colour;
}

void reduce(ivec2 first, out vec3 colours[R]) {
  vec2 at = place_of(first), step = texels_a_pixel(), size = max(step, 1);
  ivec2 corner = ivec2(floor(at - size * 0.5)), texel;
  for (int i = 0; i < R; ++i) colours[i] = vec3(0);
  for (int y = 0; y < rows; ++y) {
    vec3 row = vec3(0);
    for (int x = 0; x < columns; ++x) {
      texel = corner + ivec2(x, y);
      row += in_box(abs(at.x - 0.5 - float(texel.x)), size.x) * light_at(texel);
    }
    for (int i = 0; i < R; ++i)
      colours[i] += in_box(abs(at.y + float(i) * step.y - 0.5 - float(texel.y)), size.y) * row;
  }
  if (shows == SCREEN_SHOWS_PICTURE)
    for (int i = 0; i < R; ++i) colours[i] = sqrt(colours[i]);
}

/// How many pixels outside of it; 0 inside.
int outside(ScreenRect rect, ivec2 pixel) {
  ivec2 before = ivec2(rect.x, rect.y) - pixel, after = pixel - ivec2(rect.x + rect.width, rect.y + rect.height) + 1;
  ivec2 most = max(before, after);
  return max(max(most.x, most.y), 0);
}

bool in_lens(ivec2 pixel) { return magnified && outside(push.inset, pixel) == 0; }

/// The pixel of the picture that is magnified there.
ivec2 magnified_texel(ivec2 pixel) { return push.region_px + (pixel - push.region_at) / push.block; }

/// What is drawn over the picture, and around it.
vec3 framed(vec3 colour, ivec2 pixel) {
  if (magnified) {
    int from_region = outside(push.region, pixel), from_inset = outside(push.inset, pixel);
    if (from_region > 0 && from_region <= int(SCREEN_OUTLINE)) colour = vec3(from_region == 1 ? light : dark);
    if (from_inset > 0 && from_inset <= int(SCREEN_BORDER))
      colour = vec3(from_inset <= int(SCREEN_LIGHT_BORDER) ? light : dark);
  }
  return outside(push.shown, pixel) > 0 ? vec3(push.beside) : colour;
}

void main() {
  ivec2 within = ivec2(gl_GlobalInvocationID.x, gl_WorkGroupID.y * SCREEN_ROWS);
  if (within.x >= push.covered.width) return;
  ivec2 first = within + ivec2(push.covered.x, push.covered.y);
  vec3 colours[R];
  if (scaling == SCREEN_ENLARGED) enlarge(first, colours);
  if (scaling == SCREEN_REDUCED) reduce(first, colours);
  for (int i = 0; i < R; ++i) {
    ivec2 pixel = first + ivec2(0, i);
    if (within.y + i >= push.covered.height) return;
    if (scaling == SCREEN_COPIED) {
      ivec2 texel = pixel - ivec2(push.picture.x, push.picture.y);
      colours[i] = texel_at(in_lens(pixel) ? magnified_texel(pixel) : texel);
    } else if (in_lens(pixel)) {
      colours[i] = texel_at(magnified_texel(pixel));
    }
    vec3 colour = framed(shown(colours[i]), pixel);
    // the store may truncate instead of rounding; a little more makes a rounding of that
    imageStore(screen_out, pixel, vec4(floor(colour * 255 + 0.5) / 255 + 1e-4, 1));
  }
}
