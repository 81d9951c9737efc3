#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "fullscreen.glsl"
#include "shared/taa.h"
#include "shared/taa_key.h"
#include "shared/tonemap.h"
#include "shared/views.h"

layout(constant_id = 0) const uint view = 0;
layout(constant_id = 1) const bool resolved = false;

layout(set = 0, binding = VIEW_PICTURE) uniform texture2D picture_map;
layout(set = 0, binding = VIEW_ALBEDO) uniform texture2D albedo_map;
layout(set = 0, binding = VIEW_NORMAL) uniform texture2D normal_map;
layout(set = 0, binding = VIEW_DEPTH) uniform texture2D depth_map;
layout(set = 0, binding = VIEW_MOTION) uniform texture2D motion_map;
layout(set = 0, binding = VIEW_TAG) uniform utexture2D tag_map;
layout(set = 0, binding = VIEW_VISIBILITY) uniform texture2D visibility_map;
layout(set = 0, binding = VIEW_WHY) uniform texture2D why_map;
layout(set = 0, binding = VIEW_HISTORY) uniform texture2D history_map;
layout(set = 0, binding = VIEW_LIT) uniform texture2D lit_map;
layout(set = 0, binding = VIEW_IRRADIANCE) uniform utexture2D irradiance_map;
layout(set = 0, binding = VIEW_OUT, rgba8) uniform writeonly image2D view_out;

const vec3 red = vec3(0.92, 0.05, 0.03);

vec3 hue(float turn) { return clamp(abs(fract(turn + vec3(0, 2, 1) / 3.0) * 6 - 3) - 1, 0, 1); }

/// Hue says where to, strength how far: full at 32 px a frame, and still to be seen at a tenth of a pixel.
vec3 motion_colour(vec2 motion) {
  float far = length(motion);
  float strength = clamp(log2(1 + far * 8) / log2(1 + 32.0 * 8), 0, 1);
  return mix(vec3(0.5), hue(atan(motion.y, motion.x) / 6.2831853), strength);
}

/// Whether the pixel lies on the arrow of its cell of a grid; arrows point to where things move, not to where they were.
bool on_arrow(vec2 pixel) {
  const float cell = 32;
  vec2 middle = (floor(pixel / cell) + 0.5) * cell;
  ivec2 source = clamp(ivec2(middle), ivec2(0), ivec2(frame.size_px) - 1);
  vec2 going = -texelFetch(motion_map, source, 0).xy;
  float far = length(going);
  if (far < 0.05 || far > 1e6) return distance(pixel, middle) < 1;
  vec2 along = going / far;
  float half_length = clamp(far * 0.5, 3, cell * 0.45);
  vec2 at = pixel - middle;
  float s = dot(at, along), side = abs(dot(at, vec2(-along.y, along.x)));
  bool shaft = abs(s) <= half_length && side < 0.75;
  bool head = s <= half_length && s > half_length - 5 && side < (half_length - s) * 0.6 + 0.5;
  return shaft || head;
}

vec3 shown(vec3 colour) { return display_from_linear(colour * frame.exposure); }
vec4 why_at(ivec2 pixel) { return texelFetch(why_map, min(pixel, textureSize(why_map, 0) - 1), 0); }
uint causes_at(ivec2 pixel) { return uint(why_at(pixel).b) & ((1u << TAA_CLASS_SHIFT) - 1); }
uint class_at(ivec2 pixel) { return uint(why_at(pixel).b) >> TAA_CLASS_SHIFT; }
vec3 marked(vec3 grey, bool is) { return is ? mix(grey, red, 0.75) : grey; }

/// A colour a cause; the last of several.
vec3 cause_colour(uint causes) { return hue(float(findMSB(causes)) * 0.381966); }

/// Plain pixels grey; edges of what moves red; else what comes first.
vec3 class_colour(uint kind, vec3 picture) {
  vec3 grey = vec3(luminance(picture)), own = vec3(0);
  bool mixed = (kind & TAA_CLASS_MIXED) != 0, moving = (kind & TAA_CLASS_MOVING) != 0;
  if (mixed && moving) own = red;
  else if ((kind & TAA_CLASS_GLOSSY) != 0) own = vec3(0.1, 0.25, 0.95);
  else if (mixed) own = vec3(0.95, 0.75, 0.05);
  else if (moving) own = vec3(0.1, 0.7, 0.2);
  else return grey * 0.6;
  return mix(grey, own, 0.7);
}

/// Light that arrives, as a surface of that albedo would look; tinted where it may be another than in the last frame, beside
/// on what moves.
vec3 light_colour(uint word) {
  float lightness = float(word & KEY_LIGHT_STEPS) / KEY_LIGHT_STEPS;
  return (word & LIGHT_CHANGES) != 0 ? mix(vec3(lightness), vec3(1, 0.45, 0), 0.4) : vec3(lightness);
}

/// Of the box around the 3x3 neighbourhood, as tone-mapped colours have it: 1 is all that the screen shows.
float box_volume(ivec2 pixel) {
  vec3 low = vec3(1e30), high = vec3(0);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      vec3 colour = shown(texelFetch(lit_map, clamp(pixel + ivec2(x, y), ivec2(0), ivec2(frame.size_px) - 1), 0).rgb);
      low = min(low, colour), high = max(high, colour);
    }
  vec3 side = high - low;
  return side.x * side.y * side.z;
}

vec3 draw(ivec2 pixel) {
  vec3 picture = texelFetch(picture_map, min(pixel, textureSize(picture_map, 0) - 1), 0).rgb;
  vec3 grey = vec3(luminance(picture)) * 0.6;
  switch (view) {
  case view_albedo: {
    vec3 root = texelFetch(albedo_map, pixel, 0).rgb;  // the root of linear light is nearly sRGB
    return texelFetch(depth_map, pixel, 0).r > 0 ? root : vec3(0);
  }
  case view_normal:
    return texelFetch(depth_map, pixel, 0).r > 0
               ? direction_from_octahedral(texelFetch(normal_map, pixel, 0).xy) * 0.5 + 0.5
               : vec3(0);
  case view_depth: {
    float far = linear_depth(texelFetch(depth_map, pixel, 0).r);
    return vec3(clamp(1 - log2(max(far, 0.5) / 0.5) / log2(400.0), 0, 1));
  }
  case view_motion: {
    vec2 motion = texelFetch(motion_map, pixel, 0).xy;
    vec3 colour = mix(motion_colour(motion), picture, 0.25);
    return on_arrow(vec2(pixel) + 0.5) ? vec3(1) : colour;
  }
  case view_tag: {
    uint tag = texelFetch(tag_map, min(pixel, textureSize(tag_map, 0) - 1), 0).r;
    return tag == 0 ? grey : mix(picture, hue(float(tag) * 0.381966), 0.7);
  }
  case view_shadow: return vec3(texelFetch(visibility_map, pixel, 0).r);
  case view_weight: return vec3(resolved ? why_at(pixel).r : 1);
  case view_history:
    return resolved ? shown(texelFetch(history_map, min(pixel, textureSize(history_map, 0) - 1), 0).rgb) : vec3(0);
  case view_age: return resolved ? vec3(log2(1 + why_at(pixel).a) / 6) : vec3(0);
  case view_volume: return vec3(pow(box_volume(pixel), 1.0 / 3));
  case view_light_channel: return light_colour(texelFetch(irradiance_map, pixel, 0).r);
  case view_pixel_class: return class_colour(class_at(pixel), picture);
  case view_rejected: return mix(grey, cause_colour(causes_at(pixel)), causes_at(pixel) != 0 ? 0.75 : 0);
  case view_rectified: return marked(grey, why_at(pixel).g > 0.1);
  case view_tag_rejected: return marked(grey, (causes_at(pixel) & reject_tag) != 0);
  case view_near_moving: return marked(grey, (causes_at(pixel) & reject_near_moving) != 0);
  default: return picture;
  }
}

void main() {
  pixel_or_return(pixel);
  imageStore(view_out, pixel, vec4(draw(pixel), 1));
}
