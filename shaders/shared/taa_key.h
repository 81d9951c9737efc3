// What a resolve that knows causes is told of a pixel: one word of 32 bits, and the 16 bits that stay with the history.
// A key, from its highest bit: depth (14 bits of reversed depth's float, which sort as the depth does), object id (5),
// whether it is glossy and what it mirrors may change, whether the light on it may change, how much of that arrives (7), and by
// how much it came nearer (4).
#ifndef UNGHOST_SHARED_TAA_KEY_H
#define UNGHOST_SHARED_TAA_KEY_H

#include "language.h"

SHARED_BEGIN

/// The word that the G-buffer writes of an object; its six upper bits lie as in a key.
SHARED_CONSTANT OBJECT_NODE = 0xffffffu;  // node index + 1
SHARED_CONSTANT OBJECT_TAG_SHIFT = 24;     // where a history of objects keeps tags beside the node
SHARED_CONSTANT OBJECT_KEYED_SHIFT = 26;   // what a key has of it
SHARED_CONSTANT OBJECT_GLOSSY = 1u << 26;
SHARED_CONSTANT OBJECT_ID_SHIFT = 27;
/// Ids of what rests, from 1: 0 is the sky's. Those above are of what moves as one body: so a collision never hides that
/// something moved away from before what rests, and of keys as close the highest is of what moves. The highest is 29: what
/// stays with a history has room for 30.
SHARED_CONSTANT RESTING_IDS = 15;
SHARED_CONSTANT OBJECT_IDS = 29;

SHARED_CONSTANT KEY_DEPTH_SHIFT = 18;
SHARED_CONSTANT KEY_OBJECT_SHIFT = 12;
SHARED_CONSTANT KEY_LIGHT_SHIFT = 4;
SHARED_CONSTANT KEY_DEPTH_IN_FLOAT = 16;  // its lowest bit in a float; the sign and the exponent's highest are always 0
SHARED_CONSTANT KEY_ID_SHIFT = OBJECT_ID_SHIFT - OBJECT_KEYED_SHIFT + KEY_OBJECT_SHIFT;
SHARED_CONSTANT KEY_ID = 31u << KEY_ID_SHIFT;
SHARED_CONSTANT KEY_GLOSSY = OBJECT_GLOSSY >> OBJECT_KEYED_SHIFT << KEY_OBJECT_SHIFT;
SHARED_CONSTANT KEY_LIGHT_STEPS = 127;
SHARED_CONSTANT KEY_ZOOM_STEPS = 15;
SHARED_NUMBER KEY_ZOOM_STEP = 0.02f;

/// Frames that a history counts, before it holds many.
SHARED_CONSTANT KEPT_AGES = 16;

#ifdef __cplusplus
using glm::floatBitsToUint, glm::clamp, glm::min, glm::sqrt;
#endif

/// Light that arrives, in FrameConstants::light_unit, as a number from 0 to 1 of about equal steps to the eye, and back.
SHARED_NUMBER UNIT_LIGHTNESS = 0.8f;
SHARED_FUNCTION float lightness_of(float light) {
  return light <= 1 ? UNIT_LIGHTNESS * sqrt(light) : 1 - (1 - UNIT_LIGHTNESS) / light;
}
/// As numerator and denominator.
SHARED_FUNCTION vec2 light_fraction(float lightness) {
  float root = lightness * (1 / UNIT_LIGHTNESS);
  return root <= 1 ? vec2(root * root, 1) : vec2(1 - UNIT_LIGHTNESS, 1 - min(lightness, 0.999f));
}

/// What the light pass says of a pixel: lightness in steps, and whether it may be another than in the last frame.
SHARED_CONSTANT LIGHT_CHANGES = KEY_LIGHT_STEPS + 1;
SHARED_CONSTANT KEY_LIGHT_CHANGES = LIGHT_CHANGES << KEY_LIGHT_SHIFT;
SHARED_FUNCTION uint light_word(float light, bool changes) {
  return uint(clamp(lightness_of(light), 0.0f, 1.0f) * float(KEY_LIGHT_STEPS) + 0.5f) | (changes ? LIGHT_CHANGES : 0);
}

/// `depth` reversed, at most 1; `object` as the G-buffer has it, `light` as the light pass; `zoom`: last frame's distance
/// over this frame's, minus 1.
SHARED_FUNCTION uint key_of(float depth, uint object, uint light, float zoom) {
  uint rank = floatBitsToUint(depth) >> KEY_DEPTH_IN_FLOAT; // 14 bits
  float steps = zoom > 0 ? zoom * (1 / KEY_ZOOM_STEP) + 0.5f : 0; // 0 of what is no number, too
  uint nearer = uint(min(steps, float(KEY_ZOOM_STEPS)));
  return rank << KEY_DEPTH_SHIFT | object >> OBJECT_KEYED_SHIFT << KEY_OBJECT_SHIFT | light << KEY_LIGHT_SHIFT | nearer;
}

SHARED_END

#endif
