#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "fullscreen.glsl"
#include "brdf.glsl"
#include "sky.glsl"
#include "shared/shadow.h"
#include "shared/taa_key.h"

layout(constant_id = 0) const bool has_emissive = false;
layout(constant_id = 1) const uint light_count = 0;
layout(constant_id = 2) const bool keeps_visibility = false;
layout(constant_id = 3) const bool has_surfaces = false;
layout(constant_id = 4) const bool has_lit = false;  // surfaces that light changes
layout(constant_id = 5) const bool has_sun = false;
layout(constant_id = 6) const bool keeps_irradiance = false;

layout(set = 0, binding = LIGHT_ALBEDO) uniform texture2D albedo_map;
layout(set = 0, binding = LIGHT_NORMAL) uniform texture2D normal_map;
layout(set = 0, binding = LIGHT_MATERIAL) uniform texture2D material_map;
layout(set = 0, binding = LIGHT_EMISSIVE) uniform texture2D emissive_map;
layout(set = 0, binding = LIGHT_DEPTH) uniform texture2D depth_map;
layout(set = 0, binding = LIGHT_SHADOW_MAP) uniform texture2D shadow_map;
layout(set = 0, binding = LIGHT_LIGHTS, scalar) readonly buffer Lights { LightData lights[]; };
layout(set = 0, binding = LIGHT_OUT, rgba16f) uniform writeonly image2D lit_out;
layout(set = 0, binding = LIGHT_VISIBILITY_OUT, r8) uniform writeonly image2D visibility_out;
layout(set = 0, binding = LIGHT_IRRADIANCE_OUT, r8ui) uniform writeonly uimage2D irradiance_out;

/// GGX of this width peaks where the sun's disc in visible_sky does: nothing mirrors more than there is.
const float sun_alpha = 0.036;
const float brightest = 60000;  // what a half float holds, and a little less

/// How much of the sun is seen: 16 comparisons, weighted as a bilinear 3x3 filter of shadow texels.
float sun_visibility(vec3 position_eye, vec3 normal) {
  vec3 above = position_eye + normal * (SHADOW_OFFSET_TEXELS * frame.shadow_texel_m);
  vec4 at = frame.shadow_from_eye * vec4(above, 1);
  vec2 edge = abs(at.xy - 0.5) * 2;
  float inside = 1 - smoothstep(0.9, 1.0, max(edge.x, edge.y));
  if (inside <= 0 || at.z >= 1) return 1;
  vec2 texel = at.xy * frame.shadow_texels - 0.5;
  const int half_width = int(SHADOW_FILTER_TEXELS);
  ivec2 corner = ivec2(floor(texel)) - (half_width - 1);
  vec2 f = fract(texel);
  vec4 across = vec4(1 - f.x, 1, 1, f.x), down = vec4(1 - f.y, 1, 1, f.y);
  ivec2 last = ivec2(int(frame.shadow_texels) - 1);
  float seen = 0;
  for (int y = 0; y < 2 * half_width; ++y) {
    vec4 row;
    for (int x = 0; x < 2 * half_width; ++x)
      row[x] = texelFetch(shadow_map, clamp(corner + ivec2(x, y), ivec2(0), last), 0).r >= at.z ? 1.0 : 0.0;
    seen += dot(row, across) * down[y];
  }
  return mix(1, seen / 9, inside);
}

/// A quarter of the share of a level surface's sky that a rectangle above hides: its corner lies over the surface, its
/// sides are x and z long, y above (the form factor of Hottel 1931, without the pi / 2).
float corner_share(float x, float z, float y) {
  float a = x * inversesqrt(x * x + y * y), b = z * inversesqrt(z * z + y * y);
  return a * atan(z * inversesqrt(x * x + y * y)) + b * atan(x * inversesqrt(z * z + y * y));
}

const float underside_reach = 2.5;  // metres beyond which nothing is to be seen of it

/// How much of the sky the vehicle leaves to what lies below it: a shadow map knows the sun alone.
float sky_share(vec3 position_eye, vec3 normal) {
  vec3 at = frame.underside_from_eye * vec4(position_eye, 1);
  vec2 half_side = frame.underside_half;
  if (half_side.x <= 0 || at.y > -0.02 || any(greaterThan(abs(at.xz), half_side + underside_reach))) return 1;
  vec2 low = -half_side - at.xz, high = half_side - at.xz;
  float hidden = corner_share(high.x, high.y, at.y) - corner_share(low.x, high.y, at.y) -
                 corner_share(high.x, low.y, at.y) + corner_share(low.x, low.y, at.y);
  return 1 - clamp(hidden / (2 * pi), 0, 1) * max(normal.y, 0);
}

vec3 from_environment(Surface s, vec3 to_eye) {
  float n_v = clamp(dot(s.normal, to_eye), 1e-3, 1);
  vec3 f0 = mix(vec3(0.04), s.albedo, s.metalness);
  vec3 diffuse = s.albedo * (1 - s.metalness) * sky_radiance(s.normal, 1);
  vec3 r = reflect(-to_eye, s.normal);
  vec3 specular = sky_radiance(r, s.roughness) * environment_share(f0, s.roughness, n_v);
  vec3 base = diffuse + specular;
  if (s.coat > 0) {
    float fresnel = (0.04 + 0.96 * fresnel_weight(n_v)) * s.coat;
    base = base * (1 - fresnel) + sky_radiance(r, s.coat_roughness) * fresnel;
  }
  return base * s.occlusion;
}

/// `arriving`: their light, whatever the surface makes of it.
vec3 from_lamps(Surface s, vec3 position_eye, vec3 to_eye, out float arriving) {
  arriving = 0;
  vec3 sum = vec3(0);
  for (uint i = 0; i < light_count; ++i) {
    LightData lamp = lights[i];
    vec3 to_lamp = lamp.directional != 0 ? -lamp.direction_eye : lamp.position_eye - position_eye;
    float distance2 = max(dot(to_lamp, to_lamp), 1e-4);
    vec3 l = to_lamp * inversesqrt(distance2);
    float share = clamp(dot(lamp.direction_eye, -l) * lamp.spot_scale + lamp.spot_offset, 0, 1);
    float range = clamp(1 - pow(distance2 * lamp.inverse_range_squared, 2), 0, 1);
    float falloff = lamp.directional != 0 ? 1 : share * share * range / distance2;
    sum += lamp.intensity * falloff * reflect_light(s, to_eye, l, 0);
    if (keeps_irradiance) arriving += luminance(lamp.intensity) * falloff;
  }
  return sum;
}

vec3 own_light(ivec2 pixel) { return has_emissive ? texelFetch(emissive_map, pixel, 0).rgb : vec3(0); }

/// Light that would have to arrive at a level surface for what it shines by itself: that stays, whatever falls on it.
float light_instead_of(vec3 own, Surface s) { return pi * luminance(own) / max(luminance(s.albedo), 0.04); }

/// Light that arrives at a level surface, whatever it makes of it, in FrameConstants::light_unit; `of_others` from lamps, and
/// instead of what it shines by itself.
float demodulated(float visibility, float of_sky, float of_others) {
  return (has_sun ? frame.open_sun_light * visibility : 0) + frame.open_sky_light * of_sky + of_others / frame.light_unit;
}

/// Whether it may be another than in the last frame.
bool light_may_change(vec3 position_eye) {
  vec2 at = (frame.shadow_from_eye * vec4(position_eye, 1)).xy,
       below = (frame.underside_from_eye * vec4(position_eye, 1)).xz;
  bool in_moving_shadow = has_sun && all(greaterThanEqual(at, frame.shadows_move_from)) &&
                          all(lessThanEqual(at, frame.shadows_move_to));
  bool below_vehicle = (frame.light_changes & LIGHT_CHANGES_UNDERSIDE) != 0 &&
                       all(greaterThan(below, frame.underside_swept_low - underside_reach)) &&
                       all(lessThan(below, frame.underside_swept_high + underside_reach));
  return in_moving_shadow || below_vehicle || (frame.light_changes & LIGHT_CHANGES_ALL) != 0;
}

/// What a surface sends to the eye, how much of the sun it sees, and how much light reaches it.
vec3 lit_surface(ivec2 pixel, vec3 ray, float depth, inout float visibility, inout uint irradiance) {
  vec4 material = texelFetch(material_map, pixel, 0);
  if (material.x == 0) return own_light(pixel);
  vec4 albedo = texelFetch(albedo_map, pixel, 0);
  vec3 normal = direction_from_octahedral(texelFetch(normal_map, pixel, 0).xy);
  Surface s = Surface(albedo.rgb * albedo.rgb, albedo.a, normal, material.x, material.y, material.z, material.w);
  vec3 position_eye = ray * linear_depth(depth);
  vec3 to_eye = normalize(-ray);
  if (has_sun) visibility = dot(normal, frame.towards_sun) > 0 ? sun_visibility(position_eye, normal) : 0;
  float of_others, of_sky = sky_share(position_eye, normal);
  vec3 colour = from_environment(s, to_eye) * of_sky + from_lamps(s, position_eye, to_eye, of_others);
  if (has_sun && visibility > 0)
    colour += reflect_light(s, to_eye, frame.towards_sun, sun_alpha) * frame.sun_illuminance * visibility;
  vec3 own = own_light(pixel);
  if (has_emissive) colour += own;
  if (keeps_irradiance) {
    if (has_emissive) of_others += light_instead_of(own, s);
    irradiance = light_word(demodulated(visibility, of_sky, of_others), light_may_change(position_eye));
  }
  return colour;
}

void main() {
  pixel_or_return(pixel);
  float depth = 0;
  if (has_surfaces) depth = texelFetch(depth_map, pixel, 0).r;
  vec3 ray = frame.eye_from_view * view_ray(vec2(pixel) + 0.5);
  float visibility = 1;
  // Of the sky, what falls on things in the open before it.
  uint irradiance = light_word(frame.open_sky_light + frame.open_sun_light, false);
  vec3 colour = vec3(0);
  if (!has_surfaces || depth <= 0) colour = visible_sky(normalize(ray));
  else if (has_lit) colour = lit_surface(pixel, ray, depth, visibility, irradiance);
  else colour = own_light(pixel);
  imageStore(lit_out, pixel, vec4(min(colour, vec3(brightest)), 1));
  if (keeps_visibility) imageStore(visibility_out, pixel, vec4(visibility));
  if (keeps_irradiance) imageStore(irradiance_out, pixel, uvec4(irradiance));
}
