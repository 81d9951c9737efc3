// Whose motion a pixel follows, and what the keys around it say.
#ifndef UNGHOST_TAA_SPEAKER_GLSL
#define UNGHOST_TAA_SPEAKER_GLSL

#include "taa_inputs.glsl"

/// What the keys of a pixel's 3x3 say of it.
struct Around {
  uint own;           // its key
  bool mixed;         // another object, or depth, within
  bool moving;        // some of them moves, or did
  float mean;         // lightness
};

/// What speaks for a pixel. Its depth and tag are 0 where no test asks for them, key and what is around where none is kept.
struct Speaker {
  ivec2 at;
  float depth;
  uint tag;
  uint key;
  Around around;
};
const Around nothing_around = Around(0, false, false, 0);

bool may_move(uint id) { return id > RESTING_IDS; }

/// Whether the closer of two keys lies across an edge of depth, or of an object. The ground is closer than what stands on
/// it: that is no edge of what may move.
bool is_edge(uint own, uint closest) {
  bool other = ((own ^ closest) & KEY_ID) != 0, ground = may_move(id_of_key(own)) && !may_move(id_of_key(closest));
  return rank_of_key(closest) > rank_of_key(own) &&
         ((other && !ground) || depth_of_key(closest) > 1.2 * depth_of_key(own));
}

/// Of the sum of nine keys' light bits.
float mean_lightness(uint sum) { return float(sum) * (1.0 / (9 * KEY_LIGHT_STEPS << KEY_LIGHT_SHIFT)); }

/// Whether one of these depths is none of a surface that goes on from `own`.
bool mixes_depths(uint own, uint closest, uint farthest) {
  float depth = depth_of_key(own);
  return depth_of_key(closest) > 1.25 * depth || depth_of_key(farthest) < 0.8 * depth;
}

bool is_glossy(Speaker speaker) { return ((speaker.key | speaker.around.own) & KEY_GLOSSY) != 0; }

uint class_of(Speaker speaker) {
  return (is_glossy(speaker) ? TAA_CLASS_GLOSSY : 0) | (speaker.around.mixed ? TAA_CLASS_MIXED : 0) |
         (speaker.around.moving ? TAA_CLASS_MOVING : 0);
}

#endif
