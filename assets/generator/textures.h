// The painted pictures of the world: asphalt, its relief, road paint, grass, leaves.
#pragma once

#include <cstdint>
#include <vector>

namespace unghost::author {

constexpr double asphalt_tile = 2.992; // metres; nine of them make a sector of the track
constexpr double grass_tile = 4.0;

std::vector<uint8_t> asphalt_colour_png();
std::vector<uint8_t> asphalt_normal_png();
std::vector<uint8_t> road_paint_png();
std::vector<uint8_t> grass_png();
std::vector<uint8_t> leaves_png();

} // namespace unghost::author
