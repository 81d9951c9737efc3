// What a resolve is made of and what it reads. The naive one fetches texels, the fast one loads from storage images,
// which a software device does faster; everything else goes through the functions below.
#ifndef UNGHOST_TAA_INPUTS_GLSL
#define UNGHOST_TAA_INPUTS_GLSL

#include "frame.glsl"
#include "shared/taa.h"
#include "taa_key.glsl"

layout(constant_id = TAA_DILATION_ID) const uint dilation = 0;
layout(constant_id = TAA_HISTORY_ID) const uint history_filter = 0;
layout(constant_id = TAA_RINGING_ID) const uint ringing = 0;
layout(constant_id = TAA_SPACE_ID) const uint space = 0;
layout(constant_id = TAA_WEIGHTING_ID) const uint weighting = 0;
layout(constant_id = TAA_RECTIFY_ID) const uint rectify = 0;
layout(constant_id = TAA_AXES_ID) const uint axes = 0;
layout(constant_id = TAA_REJECT_ID) const uint reject = 0;
layout(constant_id = TAA_BLEND_ID) const uint blend = 0;
layout(constant_id = TAA_KEEPS_ID) const uint keeps = 0;
layout(constant_id = TAA_HAS_HISTORY_ID) const bool has_history = false;
layout(constant_id = TAA_READS_TAGS_ID) const bool reads_tags = false;
layout(constant_id = TAA_WRITES_ID) const uint writes = 0;
layout(constant_id = TAA_STORE_ID) const uint store = 0;
layout(constant_id = TAA_HAS_MOTION_ID) const bool has_motion = false;
layout(constant_id = TAA_HAS_SURFACES_ID) const bool has_surfaces = false;
layout(constant_id = TAA_ASKS_NEIGHBOURS_ID) const bool asks_neighbours = false;
layout(constant_id = TAA_WHERE_ID) const uint where = 0;
layout(constant_id = TAA_FILL_ID) const uint fill = 0;
layout(constant_id = TAA_INPUT_ID) const uint input_frame = 0;
layout(constant_id = TAA_RELIGHTS_ID) const bool relights = false;
layout(constant_id = TAA_BOUNDS_ID) const bool may_need_bounds = false;

bool rejects(uint test) { return (reject & test) != 0; }
bool writes_to(uint what) { return (writes & what) != 0; }
bool rectifies_unknown_only() { return where == where_unknown && rectify != rectify_none; }
/// Whether a pixel's key is asked: what rejects, weighs or bounds by known causes.
bool keyed() {
  return rejects(reject_moved_object | reject_visibility) || blend == blend_speed || rectifies_unknown_only();
}

const uint filled_flags =
    reject_tag | reject_near_moving | reject_velocity | reject_depth | reject_object | reject_moved_object;
bool needs_blurred() { return fill == fill_blurred && rejects(filled_flags); }
bool tests_tags() { return rejects(reject_tag) && reads_tags; }
/// The history's alpha has one place: of a keyed row, tags go with the objects.
bool keeps_tags_apart() { return tests_tags() && keyed(); }
bool reads_alpha() { return tests_tags() || keyed(); }
bool needs_volume() { return rectify != rectify_none && may_need_bounds; }
bool counts() { return writes_to(TAA_WRITES_COUNT); }
/// Of the count that goes with a key; blend_counting has one of its own, which goes further.
bool takes_age() { return keyed() && blend != blend_counting; }
float most_frames() { return keeps == keeps_input ? 2 : takes_age() ? KEPT_AGES : 1024; }
bool centres_input() { return input_frame == input_centred; }
bool asks_for_depth() { return rejects(reject_near_moving); }

#ifdef TAA_FAST
#define TAA_MAP(format, Image, name, place) layout(set = 0, binding = place, format) uniform readonly Image name
#define fetch(map, pixel) imageLoad(map, pixel)
#define size_of(map) imageSize(map)
TAA_MAP(rgba16f, image2D, colour_map, TAA_COLOUR);
TAA_MAP(rgba16f, image2D, history_map, TAA_PREVIOUS);
TAA_MAP(rg32f, image2D, motion_map, TAA_MOTION);
TAA_MAP(r32f, image2D, depth_map, TAA_DEPTH);
TAA_MAP(r32f, image2D, previous_count_map, TAA_PREVIOUS_COUNT);
TAA_MAP(rg32f, image2D, previous_motion_map, TAA_PREVIOUS_MOTION);
TAA_MAP(r32f, image2D, previous_depth_map, TAA_PREVIOUS_DEPTH);
TAA_MAP(r32f, image2D, expected_depth_map, TAA_EXPECTED_DEPTH);
TAA_MAP(r32ui, uimage2D, previous_object_map, TAA_PREVIOUS_OBJECT);
TAA_MAP(r32ui, uimage2D, key_map, TAA_KEY);
#else
#define TAA_MAP(Texture, name, place) layout(set = 0, binding = place) uniform Texture name
#define fetch(map, pixel) texelFetch(map, pixel, 0)
#define size_of(map) textureSize(map, 0)
TAA_MAP(texture2D, colour_map, TAA_COLOUR);
TAA_MAP(texture2D, history_map, TAA_PREVIOUS);
TAA_MAP(texture2D, motion_map, TAA_MOTION);
TAA_MAP(texture2D, depth_map, TAA_DEPTH);
TAA_MAP(texture2D, previous_count_map, TAA_PREVIOUS_COUNT);
TAA_MAP(utexture2D, tag_map, TAA_TAG);
TAA_MAP(texture2D, previous_motion_map, TAA_PREVIOUS_MOTION);
TAA_MAP(texture2D, previous_depth_map, TAA_PREVIOUS_DEPTH);
TAA_MAP(texture2D, expected_depth_map, TAA_EXPECTED_DEPTH);
TAA_MAP(utexture2D, previous_object_map, TAA_PREVIOUS_OBJECT);
TAA_MAP(utexture2D, key_map, TAA_KEY);
#endif
// no device has to store to its format
layout(set = 0, binding = TAA_OBJECT) uniform utexture2D object_map;
layout(set = 0, binding = TAA_HISTORY_SAMPLER) uniform sampler2D history_sampler;

layout(set = 0, binding = TAA_OUT, rgba16f) uniform writeonly image2D colour_out;
layout(set = 0, binding = TAA_INPUT_OUT, rgba16f) uniform writeonly image2D input_out;
layout(set = 0, binding = TAA_COUNT_OUT, r32f) uniform writeonly image2D count_out;
layout(set = 0, binding = TAA_MOTION_OUT, rg32f) uniform writeonly image2D motion_out;
layout(set = 0, binding = TAA_DEPTH_OUT, r32f) uniform writeonly image2D depth_out;
layout(set = 0, binding = TAA_OBJECT_OUT, r32ui) uniform writeonly uimage2D object_out;
layout(set = 0, binding = TAA_WHY_OUT, rgba32f) uniform writeonly image2D why_out;
layout(set = 0, binding = TAA_HISTORY_OUT, rgba16f) uniform writeonly image2D history_out;
layout(set = 0, binding = TAA_PROBE_OUT, rgba32f) uniform writeonly image2D probe_out;
layout(push_constant, scalar) uniform Push { TaaPush pushed; };
TaaPush push = pushed;  // once, as the frame's constants

/// What is not a number ends here: it would spread through the history for ever.
vec3 finite(vec3 colour) {
  bvec3 bad = bvec3(uvec3(isnan(colour)) | uvec3(isinf(colour)));
  return mix(max(colour, vec3(0)), vec3(0), bad);
}

ivec2 last_pixel() { return ivec2(frame.size_px) - 1; }
ivec2 inside(ivec2 pixel) { return clamp(pixel, ivec2(0), last_pixel()); }

vec3 colour_at(ivec2 pixel) { return finite(fetch(colour_map, pixel).rgb); }
/// The sky's where there is nothing else.
float loaded_depth(ivec2 pixel) { return has_surfaces ? fetch(depth_map, pixel).r : 0; }
float comparable_depth(float loaded) { return without_tag(loaded); }
float depth_at(ivec2 pixel) { return comparable_depth(loaded_depth(pixel)); }
vec2 motion_at(ivec2 pixel) { return has_motion ? fetch(motion_map, pixel).xy : vec2(0); }
/// By what a pixel is chosen to speak for those around it, as it is loaded; and what of it counts.
float rank_at(ivec2 pixel) {
  if (dilation != dilation_longest) return loaded_depth(pixel);
  vec2 motion = motion_at(pixel);
  float length_squared = dot(motion, motion);
  return isnan(length_squared) ? -1 : length_squared;
}
float rank_of(float loaded) { return dilation == dilation_longest ? loaded : comparable_depth(loaded); }
uint object_at(ivec2 pixel) { return has_surfaces ? texelFetch(object_map, pixel, 0).r & OBJECT_NODE : 0; }
uint key_at(ivec2 pixel) { return fetch(key_map, pixel).r; }

#endif
