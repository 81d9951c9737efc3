// The scene that the demonstration drives through: a car on a closed circuit of noisy asphalt.
#pragma once

#include <cstdint>
#include <vector>

namespace unghost::author {

/// `asphalt.glb`, whole. The same bytes on every run.
std::vector<uint8_t> author_asphalt();

} // namespace unghost::author
