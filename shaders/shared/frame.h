// What every pass is told of the frame, and the conventions of the whole program:
// - world: right-handed, y up, metres. `_eye` is world axes with the origin at this frame's camera, so that numbers
//   stay small however far from the world's origin the camera is; `_view` turns them so that the camera looks along -z.
// - depth: reversed, near / distance along the view axis, 1 at the near plane, 0 at infinity.
// - pixels: x right, y down, centres at .5. Motion is in pixels, from this frame's pixel to where it was last frame
//   (previous minus current), without either frame's jitter.
// - jitter: what lies at x without jitter lies at x + jitter_px in this frame's picture.
// - colours: linear, until the tone map makes sRGB of them.
#ifndef UNGHOST_SHARED_FRAME_H
#define UNGHOST_SHARED_FRAME_H

#include "language.h"

SHARED_BEGIN
#ifdef __cplusplus
using glm::dot;
#endif

/// Of linear sRGB.
SHARED_FUNCTION float luminance(vec3 colour) { return dot(colour, vec3(0.2126f, 0.7152f, 0.0722f)); }

/// Binding of FrameConstants in set 0 of every pass.
SHARED_CONSTANT FRAME_BINDING = 0;
/// Motion of what was behind last frame's camera or somewhere unknown: far outside of every picture.
#define MOTION_UNKNOWN 1e9

struct FrameConstants {
  mat4 clip_from_eye;           // with jitter
  mat4 previous_clip_from_eye;  // last frame's, from its own `_eye`, without jitter
  mat4 shadow_from_eye;         // to the shadow map: xy 0 to 1, z 0 (near the sun) to 1
  mat3 eye_from_view;
  mat3 reprojection_turn;       // last frame's view from this frame's view, minus the identity
  vec3 reprojection_shift;      // of the view's origin, in last frame's view
  vec3 towards_sun;
  vec3 sun_illuminance;         // of a surface that faces the sun
  vec3 sky_zenith, sky_horizon, ground;
  vec2 size_px, inverse_size_px;
  vec2 jitter_px;
  vec2 tangent;                 // of half the field of view, across and down
  vec2 previous_over_tangent;   // last frame's 1 / tangent minus this frame's
  float near_plane;
  float exposure;
  float shadow_texels;          // along a side of the shadow map
  float shadow_texel_m;
  vec2 texture_jitter_px;       // what textures are shifted by, so that the jitter does not move them
  float mip_bias;
  mat4x3 underside_from_eye;    // the vehicle's underside: a rectangle about the origin in the plane y = 0, y upwards
  vec2 underside_half;          // metres along its x and z; 0 where there is no vehicle
  vec2 underside_swept_low, underside_swept_high;  // in its plane: what it covers, or did in the last frame
  float light_unit;             // arriving light that is 1 in keys: about what the exposure is made for
  float open_sky_light, open_sun_light;  // luminance of what arrives at a level surface in the open, in light_unit
  float sky_lightness, open_lightness;   // of what of these arrives without and with the sun (shared/taa_key.h)
  vec3 open_over_sky;           // by what share a colour in sun and sky differs from its in the sky alone, for each lightness
  uint light_changes;           // LIGHT_CHANGES_ bits
  uint mirrors_change;          // 0: nothing moves and no light changes, so that what glossy surfaces mirror rests
  vec2 shadows_move_from, shadows_move_to;  // of the shadow map, 0 to 1: where what moves, or did, throws its shadow
};

/// What may change light from the last frame to this one, beside shadows of what moves.
SHARED_CONSTANT LIGHT_CHANGES_ALL = 1;        // the sun, the sky or a lamp
SHARED_CONSTANT LIGHT_CHANGES_UNDERSIDE = 2;  // the vehicle moves

/// The textures of a material: their bindings in set 1, and their places in every array of textures.
SHARED_CONSTANT TEXTURE_BASE_COLOUR = 0;
SHARED_CONSTANT TEXTURE_METALLIC_ROUGHNESS = 1;
SHARED_CONSTANT TEXTURE_NORMAL = 2;
SHARED_CONSTANT TEXTURE_OCCLUSION = 3;
SHARED_CONSTANT TEXTURE_EMISSIVE = 4;
SHARED_CONSTANT TEXTURE_COAT = 5;
SHARED_CONSTANT TEXTURE_COAT_ROUGHNESS = 6;
SHARED_CONSTANT MATERIAL_TEXTURES = 7;

/// What a draw is made with: specialization constants. Bit i: it has texture i.
SHARED_CONSTANT HAS_ALPHA_MASK = 128;
SHARED_CONSTANT IS_UNLIT = 256;
SHARED_CONSTANT HAS_TEXTURE_PLACES = 512;  // some texture reads uv1, or a transformed uv
SHARED_CONSTANT SHIFTS_TEXTURES = 1024;
SHARED_CONSTANT BIASES_TEXTURES = 2048;

struct MaterialData {
  vec4 base_colour;
  vec3 emissive;
  float metalness, roughness;
  float coat, coat_roughness;
  float normal_scale, occlusion_strength;
  float alpha_cutoff;
};

/// Where a material with HAS_TEXTURE_PLACES reads its textures.
struct TexturePlaces {
  mat3x2 uv_transforms[MATERIAL_TEXTURES];
  uint uv_sets;  // bit i: texture i reads uv1
};

/// All that a draw of something at rest needs. Push constants, because a software device reads them once for a whole
/// vector of pixels, and a buffer once for each.
struct DrawPush {
  mat4x3 eye_from_object;
  MaterialData material;
  uint material_index;
  uint object_word;  // shared/taa_key.h: node index + 1, and the id of what moves with it
};

/// KHR_lights_punctual, in this frame's eye space.
struct LightData {
  vec3 position_eye;
  float inverse_range_squared;  // 0: infinite
  vec3 intensity;
  float spot_scale;             // attenuation = saturate(cos * scale + offset)^2; 0 and 1: not a spot
  vec3 direction_eye;           // towards which it shines
  float spot_offset;
  uint directional;
};

SHARED_END

#endif
