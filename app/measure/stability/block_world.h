// A scene made by hand: a ground and a block on it that is the vehicle, in flat colours that no light
// changes.
#pragma once

#include "renderer/renderer.h"

namespace unghost {

/// `side`: of the block, metres; the ground is 40 times as long. `origin`: where the middle of the ground is.
struct BlockWorld {
  float side = 1;
  glm::vec3 origin{0};
  bool chequered = false; // the ground: a colour a square of a side, and the same ones again after eight
};

Scene block_scene(const BlockWorld& world);
/// Of the chequered world.
Renderer block_renderer(Device& device, const std::filesystem::path& shaders);
/// The camera looks down at the block, which is `moved` metres from its place.
Instant block_instant(const BlockWorld& world, glm::dvec3 moved);
/// The block drives over the usual chequered world and the camera follows: what lies between this frame and
/// the one before. Without end: after eight squares it goes on where the ground looks the same.
FrameInput block_drive(uint32_t frame);

} // namespace unghost
