// What a resolve leaves of a pixel.
#ifndef UNGHOST_TAA_STORE_GLSL
#define UNGHOST_TAA_STORE_GLSL

#include "taa_pixel.glsl"

/// A half float next to the colour, up or down in turns that are proportional to how near it is. Rounded to the nearest, an
/// average stops as soon as its step is less than half a unit: 2.5% short at a weight of .02; cut off, as a software device
/// stores it, it drifts down. The turns are a sequence of the golden ratio a pixel (a set of low discrepancy: Roberts 2018),
/// whose mean over time is nearer to the colour than that of chance. None is so near to either end that what arithmetic
/// leaves beside a half float would take it away: a history that stays, stays as it is to the bit.
const uint unit = 8192, arithmetic = 16;  // of a float's significand: of a half float, and that may be wrong
uint turn_of(ivec2 pixel) {  // of all channels: a grey stays grey
  uint seed = uint(pixel.x) * 3242174889u + uint(pixel.y) * 2447445413u + push.frame * 2654435769u;
  return clamp(seed >> 19, arithmetic, unit - arithmetic);
}
vec3 rounded(vec3 colour, ivec2 pixel) {
  uvec3 bits = floatBitsToUint(min(colour, vec3(65504)));
  return uintBitsToFloat((bits + turn_of(pixel)) & ~(unit - 1));
}
vec3 stored(vec3 colour, ivec2 pixel) {
  return store == store_dithered ? rounded(colour, pixel) : clamp(colour, vec3(0), vec3(65504));
}

/// Rounded up or down in the same turns.
uint light_step(float lightness, ivec2 pixel) {
  return uint(lightness * KEY_LIGHT_STEPS + float(turn_of(pixel)) / unit);
}

float reasons_of(Speaker speaker, Resolve r) { return r.causes | class_of(speaker) << TAA_CLASS_SHIFT; }

void write_probe(ivec2 pixel, Speaker speaker, Resolve r) {
  if (any(notEqual(pixel, push.probe_px))) return;
  ivec2 off = speaker.at - pixel + 1;
  imageStore(probe_out, ivec2(TAA_PROBE_FOUND, 0), vec4(r.found, 3 * off.y + off.x));
  imageStore(probe_out, ivec2(TAA_PROBE_BOUNDED, 0), vec4(r.bounded, r.weight));
  imageStore(probe_out, ivec2(TAA_PROBE_WHY, 0), vec4(r.rectified, reasons_of(speaker, r), r.count, r.has_history));
  imageStore(probe_out, ivec2(TAA_PROBE_INPUT, 0), vec4(r.mixed_in, r.bounds));
}

/// Writes all that is asked for. What goes with the history, a tag or what stays of a key, costs no image of its own.
void write_pixel(ivec2 pixel, Speaker speaker, vec3 centre, Resolve r) {
  float alpha = tests_tags() ? speaker.tag : 0;
  if (keyed()) alpha = kept_as_half(id_of_key(speaker.key), r.count, light_step(r.lightness, pixel));
  imageStore(colour_out, pixel, vec4(stored(r.colour, pixel), alpha));
  if (keeps == keeps_input) imageStore(input_out, pixel, vec4(min(centre, vec3(65504)), alpha));
  if (writes_to(TAA_WRITES_COUNT)) imageStore(count_out, pixel, vec4(r.count));
  if (writes_to(TAA_WRITES_MOTION)) imageStore(motion_out, pixel, vec4(motion_at(speaker.at), 0, 0));
  if (writes_to(TAA_WRITES_DEPTH)) imageStore(depth_out, pixel, vec4(linear_depth(depth_at(speaker.at))));
  if (writes_to(TAA_WRITES_OBJECT))
    imageStore(object_out, pixel,
               uvec4(object_at(speaker.at) | (keeps_tags_apart() ? speaker.tag << OBJECT_TAG_SHIFT : 0)));
  if (writes_to(TAA_WRITES_WHY))
    imageStore(why_out, pixel, vec4(r.weight, r.rectified, reasons_of(speaker, r), r.count));
  if (writes_to(TAA_WRITES_HISTORY)) imageStore(history_out, pixel, vec4(r.history, 1));
  if (writes_to(TAA_WRITES_PROBE)) write_probe(pixel, speaker, r);
}

#endif
