// The questions that every temporal resolve answers, and the answers there are. Each answer stands here once:
// C++ makes an enumerator and its spelling out of it, GLSL the constant that its `switch` compares with.
#ifndef UNGHOST_SHARED_TAA_H
#define UNGHOST_SHARED_TAA_H

#include "language.h"

#define TAA_JITTER(X)                                                                                        \
  X(jitter, none, 0) X(jitter, halton_8, 1) X(jitter, halton_16, 2) X(jitter, blue_noise_16, 3)              \
  X(jitter, r2_10, 4) X(jitter, two_samples, 5) X(jitter, rotated_grid, 6)
#define TAA_DILATION(X)                                                                                      \
  X(dilation, centre, 0) X(dilation, closest_depth, 1) X(dilation, depth_edges, 2) X(dilation, longest, 3)
// catmull_rom is the way to compute it that suits the device; the two after it force one. catmull_rom_5 has no corners, and
// catmull_rom_12 is the same by loads.
#define TAA_HISTORY(X)                                                                                       \
  X(history, nearest, 0) X(history, bilinear, 1) X(history, catmull_rom, 2) X(history, catmull_rom_16, 3)    \
  X(history, catmull_rom_9, 4) X(history, catmull_rom_5, 5) X(history, catmull_rom_12, 6)
#define TAA_RINGING(X) X(ringing, kept, 0) X(ringing, clamped, 1)
#define TAA_SPACE(X) X(space, rgb, 0) X(space, ycocg, 1)
#define TAA_WEIGHTING(X) X(weighting, none, 0) X(weighting, inverse_luminance, 1) X(weighting, log, 2)
#define TAA_RECTIFY(X)                                                                                       \
  X(rectify, none, 0) X(rectify, box_clamp, 1) X(rectify, box_clip, 2) X(rectify, variance_clamp, 3)         \
  X(rectify, variance_clip, 4) X(rectify, dop_clip, 5) X(rectify, dop_variance, 6)
#define TAA_WHERE(X) X(where, everywhere, 0) X(where, unknown, 1)
#define TAA_AXES(X)                                                                                          \
  X(axes, xyz, 0) X(axes, dop16, 1) X(axes, dop22, 2) X(axes, dop32, 3) X(axes, dop16_grass, 4)              \
  X(axes, dop16_asphalt, 5) X(axes, dop16_ours, 6)
#define TAA_REJECT(X)                                                                                        \
  X(reject, off_screen, 1) X(reject, tag, 2) X(reject, near_moving, 4) X(reject, velocity, 8)                \
  X(reject, motion_length, 16) X(reject, speed, 32) X(reject, depth, 64) X(reject, object, 128)              \
  X(reject, moved_object, 256) X(reject, visibility, 512)
#define TAA_FILL(X) X(fill, blurred, 0) X(fill, plain, 1)
#define TAA_BLEND(X)                                                                                         \
  X(blend, current, 0) X(blend, constant, 1) X(blend, counting, 2) X(blend, attenuated, 3) X(blend, speed, 4)
#define TAA_INPUT(X) X(input, sampled, 0) X(input, centred, 1)
#define TAA_KEEPS(X) X(keeps, result, 0) X(keeps, input, 1)
#define TAA_STORE(X) X(store, dithered, 0) X(store, plain, 1)
// of the textures of what is drawn; and which implementation resolves
#define TAA_TEXTURE_JITTER(X) X(texture_jitter, kept, 0) X(texture_jitter, removed, 1)
#define TAA_RESOLVER(X) X(resolver, fast, 0) X(resolver, naive, 1)

#ifndef __cplusplus
#define TAA_CONSTANT(column, answer, value) const uint column##_##answer = value;
TAA_DILATION(TAA_CONSTANT)
TAA_HISTORY(TAA_CONSTANT)
TAA_RINGING(TAA_CONSTANT)
TAA_SPACE(TAA_CONSTANT)
TAA_WEIGHTING(TAA_CONSTANT)
TAA_RECTIFY(TAA_CONSTANT)
TAA_WHERE(TAA_CONSTANT)
TAA_AXES(TAA_CONSTANT)
TAA_REJECT(TAA_CONSTANT)
TAA_FILL(TAA_CONSTANT)
TAA_BLEND(TAA_CONSTANT)
TAA_INPUT(TAA_CONSTANT)
TAA_KEEPS(TAA_CONSTANT)
TAA_STORE(TAA_CONSTANT)
#endif

SHARED_BEGIN

/// The specialization constants of the resolve, in the order of their ids.
SHARED_CONSTANT TAA_DILATION_ID = 0;
SHARED_CONSTANT TAA_HISTORY_ID = 1;
SHARED_CONSTANT TAA_RINGING_ID = 2;
SHARED_CONSTANT TAA_SPACE_ID = 3;
SHARED_CONSTANT TAA_WEIGHTING_ID = 4;
SHARED_CONSTANT TAA_RECTIFY_ID = 5;
SHARED_CONSTANT TAA_AXES_ID = 6;
SHARED_CONSTANT TAA_REJECT_ID = 7;
SHARED_CONSTANT TAA_BLEND_ID = 8;
SHARED_CONSTANT TAA_KEEPS_ID = 9;
SHARED_CONSTANT TAA_HAS_HISTORY_ID = 10; // without one the frame is taken as it is
SHARED_CONSTANT TAA_READS_TAGS_ID = 11;
SHARED_CONSTANT TAA_WRITES_ID = 12; // the TAA_WRITES_ bits
SHARED_CONSTANT TAA_STORE_ID = 13;
SHARED_CONSTANT TAA_HAS_MOTION_ID = 14;
SHARED_CONSTANT TAA_HAS_SURFACES_ID = 15;
SHARED_CONSTANT TAA_ASKS_NEIGHBOURS_ID = 16; // of a row without dilation, whom they tell nothing
SHARED_CONSTANT TAA_WHERE_ID = 17;
SHARED_CONSTANT TAA_FILL_ID = 18;
SHARED_CONSTANT TAA_INPUT_ID = 19;
SHARED_CONSTANT TAA_RELIGHTS_ID = 20; // of a row that rejects by visibility: some light changes
SHARED_CONSTANT TAA_BOUNDS_ID = 21; // of a row that rectifies: something may have to be

/// What a resolve writes beside its result.
SHARED_CONSTANT TAA_WRITES_COUNT = 1;   // of the frames that a history holds
SHARED_CONSTANT TAA_WRITES_MOTION = 2;  // for the next frame's rejections
SHARED_CONSTANT TAA_WRITES_DEPTH = 4;
SHARED_CONSTANT TAA_WRITES_OBJECT = 8;
SHARED_CONSTANT TAA_WRITES_WHY = 16;  // for the views
SHARED_CONSTANT TAA_WRITES_HISTORY = 32;
SHARED_CONSTANT TAA_WRITES_PROBE = 64;  // of one pixel

/// Beside the causes among the reasons that views are drawn from: what kind of pixel it is.
SHARED_CONSTANT TAA_CLASS_SHIFT = 16;
SHARED_CONSTANT TAA_CLASS_GLOSSY = 1;
SHARED_CONSTANT TAA_CLASS_MIXED = 2;
SHARED_CONSTANT TAA_CLASS_MOVING = 4;

/// What it writes of the one pixel: a texel each, of four floats.
SHARED_CONSTANT TAA_PROBE_FOUND = 0;    // linear colour of the history as it was read, or lit anew; which of 3x3 speaks for it
SHARED_CONSTANT TAA_PROBE_BOUNDED = 1;  // the same after rectification, in the working space; weight of the frame
SHARED_CONSTANT TAA_PROBE_WHY = 2;      // how far it was moved; causes and class; frames that it holds; 1: there is a history
SHARED_CONSTANT TAA_PROBE_INPUT = 3;    // linear colour of the frame that is mixed in; 1: colours bound the history
SHARED_CONSTANT TAA_PROBE_TEXELS = 4;

/// How much of each answer; push constants of the resolve.
struct TaaPush {
  float alpha;
  float gamma;                    // variance: this many standard deviations
  float motion_threshold_px;      // near and moving, moved object: faster than this
  float near_m, far_m;            // near and moving: fades from all to nothing
  float velocity_min, velocity_slope;  // velocity: shares of the picture's sides, and what a share more costs
  float motion_length_px;         // motion length: differs by more than this
  float speed_px;                 // speed: faster than this
  float depth_share;              // depth: differs by more than this share
  float fast_alpha;               // blend by speed: the weight of what is fast
  float inverse_fast_squared;     // one over the square of a motion in pixels that is
  float centred_rest;             // input centred: how much of it is taken at rest
  float zoom_weight;              // and by how much more, for each share that it came nearer
  float cubic;                    // history: the sharpness of Catmull-Rom, 0.5, or another
  uint moved_ids;                 // bit i: something of that id moves, or did in the last frame
  uint frame;                     // seeds the rounding
  uint dilates;                   // 0: where neighbours are asked in vain
  ivec2 probe_px;                 // of which more is written
};

SHARED_END

#endif
