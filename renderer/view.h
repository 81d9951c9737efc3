// The camera as numbers for the device. All differences between frames are taken in double precision here, so
// that a camera far from the world's origin has motion as exact as one at it.
#pragma once

#include "renderer/frame_input.h"
#include "shaders/shared/frame.h"

namespace unghost {

/// The camera part of FrameConstants: matrices, reprojection, jitter, sizes.
void describe_camera(FrameConstants& constants, const FrameInput& input, glm::dvec2 jitter_px);

/// After so many frames the sequence begins again.
uint32_t jitter_cycle(Jitter sequence);
/// Offset of frame `index` in pixels, each axis in [-0.5, 0.5).
glm::dvec2 jitter_offset(Jitter sequence, uint64_t index);
/// Whether what rests is elsewhere in the picture than in the frame before.
bool camera_moves(const FrameInput& input);
/// Of the square that a mode's jitter fills, in pixels; 0 without.
double jitter_side(const TaaSettings& taa, const FrameInput& input);
/// By how many pixels the frame of a mode is shifted, as shaders/shared/frame.h has it; the input's own
/// jitter, where it has one, is every mode's.
glm::dvec2 jitter_of(const TaaSettings& taa, const FrameInput& input);
/// Point `n` of R2, which never repeats (Roberts 2018), each axis in [-0.5, 0.5).
glm::dvec2 r2_sequence(uint64_t n);

/// Where on the picture a world position lies, in pixels without jitter; and its depth in metres along the
/// view axis. Double precision throughout: the oracle for motion vectors. Not meaningful for depth <= 0.
struct Projected {
  glm::dvec2 pixel;
  double depth = 0;
};
Projected project(const Instant& instant, glm::dvec3 position_world, uint32_t width, uint32_t height);

} // namespace unghost
