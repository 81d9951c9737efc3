// Reading keys (shared/taa_key.h), and what stays of them with a history: object id, how many frames
// it holds, and the light that fell on it, in the alpha of a half float.
#ifndef UNGHOST_TAA_KEY_GLSL
#define UNGHOST_TAA_KEY_GLSL

#include "shared/taa_key.h"

uint rank_of_key(uint key) { return key >> KEY_DEPTH_SHIFT; }
float depth_of_key(uint key) { return uintBitsToFloat(key >> KEY_DEPTH_SHIFT << KEY_DEPTH_IN_FLOAT); }
/// Sums of these are sums of steps.
uint light_bits_of(uint key) { return key & KEY_LIGHT_STEPS << KEY_LIGHT_SHIFT; }
uint light_step_of(uint key) { return light_bits_of(key) >> KEY_LIGHT_SHIFT; }
float lightness_of_key(uint key) { return float(light_step_of(key)) * (1.0 / KEY_LIGHT_STEPS); }
float zoom_of(uint key) { return float(key & KEY_ZOOM_STEPS) * KEY_ZOOM_STEP; }
uint id_of_key(uint key) { return (key & KEY_ID) >> KEY_ID_SHIFT; }
uint id_bit_of_key(uint key) { return 1u << id_of_key(key); }
/// Of a set of bits.
bool several(uint bits) { return (bits & (bits - 1)) != 0; }

struct Kept {
  uint id;
  float age;   // frames, 1 to KEPT_AGES
  float light_step;  // of KEY_LIGHT_STEPS
};

// A half float has 30720 positive numbers that are neither infinite nor denormal, and as many negative ones: every device
// stores and loads those to the bit. They have room for 15 ids each.
const uint half_ids = 15, least_half_in_float = 113u << 23;

float kept_as_half(uint id, float age, uint light_step) {
  bool upper = id >= half_ids;
  uint step = uint(clamp(age, 1, KEPT_AGES) - 0.5);
  uint number = ((id - (upper ? half_ids : 0)) * KEPT_AGES + step) * (KEY_LIGHT_STEPS + 1) + light_step;
  return uintBitsToFloat(((number << 13) + least_half_in_float) | (upper ? 1u << 31 : 0));
}

/// What is no such number comes out as another: its id is 30 at most.
Kept kept_of_half(float alpha) {
  uint bits = floatBitsToUint(alpha), number = (bits - least_half_in_float) >> 13, rest = number / (KEY_LIGHT_STEPS + 1);
  return Kept(rest / KEPT_AGES % (half_ids + 1) + (bits >> 31) * half_ids, float(rest % KEPT_AGES + 1),
              float(number & KEY_LIGHT_STEPS));
}

#endif
