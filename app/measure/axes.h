// Axes of polytopes that fit tightly (Ikkala et al. 2024, section 3): around the unit sphere for any scene,
// or around the neighbourhoods of one scene's aliased frames.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace unghost {

/// A 3x3 neighbourhood, linear RGB, the pixel itself in the middle.
using Neighbourhood = std::array<glm::dvec3, 9>;

/// Volume of the polytope whose slabs along `axes` touch the unit sphere, as a multiple of the sphere's: at
/// least 1.
double volume_around_sphere(std::span<const glm::dvec3> axes);
/// The mean over the neighbourhoods of the side of a cube as large as the polytope around each; those of one
/// colour count nothing. Linear units.
double size_around(std::span<const glm::dvec3> axes, std::span<const Neighbourhood> neighbourhoods);

struct AxisSearch {
  size_t count = 8; // axes: half the faces
  size_t fixed = 3; // of them X, Y and Z, which stay
  uint64_t seed = 1;
  size_t steps = 20'000;
};
using AxisCost = std::function<double(std::span<const glm::dvec3> axes)>;
/// The best of several starts, and what it began with.
struct FoundAxes {
  std::vector<glm::dvec3> axes, first;
};
/// Turns one axis at a time by less and less, and keeps what lowers the cost; several starts. The same seed
/// finds the same. `progress` is told the share done.
FoundAxes find_axes(const AxisSearch& search, const AxisCost& cost,
                    const std::function<void(double)>& progress);

/// The lists that shaders are made with, by the name of the answer: xyz, dop16, dop22, dop32, ...
std::vector<glm::dvec3> shipped_axes(std::string_view name);

} // namespace unghost
