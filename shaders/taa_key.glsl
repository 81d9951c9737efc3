// Reading keys (shared/taa_key.h), and what stays of them with a history: object id, how many frames
// it holds, and the light that fell on it, as a number from 0 to 61439 in a half float's alpha.
#ifndef UNGHOST_TAA_KEY_GLSL
#define UNGHOST_TAA_KEY_GLSL

#include "shared/taa_key.h"

uint rank_of_key(uint key) { return key >> KEY_DEPTH_SHIFT; }
float depth_of_key(uint key) { return uintBitsToFloat(key >> KEY_DEPTH_SHIFT << KEY_DEPTH_IN_FLOAT); }
uint light_step_of(uint key) { return key >> KEY_LIGHT_SHIFT & KEY_LIGHT_STEPS; }
float lightness_of_key(uint key) { return float(light_step_of(key)) / KEY_LIGHT_STEPS; }
float zoom_of(uint key) { return float(key & KEY_ZOOM_STEPS) * KEY_ZOOM_STEP; }
uint id_of_key(uint key) { return (key & KEY_ID) >> KEY_ID_SHIFT; }
uint id_bit_of_key(uint key) { return 1u << id_of_key(key); }
/// Of a set of bits.
bool several(uint bits) { return (bits & (bits - 1)) != 0; }

struct Kept {
  uint id;
  float age;   // frames, 1 to KEPT_AGES
  float lightness;
};

// A half float has 30720 positive numbers that are neither infinite nor denormal, and as many negative ones: every device
// stores and loads those to the bit.
const uint half_numbers = 30720, least_half_in_float = 113u << 23;

float kept_as_half(uint id, float age, uint light_step) {
  uint number = (id * KEPT_AGES + uint(clamp(age, 1, KEPT_AGES) - 0.5)) * (KEY_LIGHT_STEPS + 1) + light_step;
  bool negative = number >= half_numbers;
  uint magnitude = (number - (negative ? half_numbers : 0)) << 13;
  return uintBitsToFloat((magnitude + least_half_in_float) | (negative ? 1u << 31 : 0));
}

Kept kept_of_half(float alpha) {
  uint bits = floatBitsToUint(alpha), magnitude = max(bits & 0x7fffffffu, least_half_in_float) - least_half_in_float;
  uint number = min(magnitude >> 13, half_numbers - 1) + ((bits >> 31) != 0 ? half_numbers : 0);
  uint upper = number / (KEY_LIGHT_STEPS + 1);
  return Kept(upper / KEPT_AGES, float(upper % KEPT_AGES + 1), float(number & KEY_LIGHT_STEPS) / KEY_LIGHT_STEPS);
}

#endif
