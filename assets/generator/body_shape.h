// The car's body as one function: negative inside, positive outside, about metres near the surface. Side,
// top, nose and tail are drawn as curves and meet in fillets, so that every normal is the gradient of
// something smooth.
#pragma once

#include <functional>
#include <vector>

#include <glm/glm.hpp>

namespace unghost::author {

/// The running gear's measures, in the car's frame: metres, +z forward, +y up, +x left, the origin on the
/// ground below the middle between the axles.
struct Chassis {
  static constexpr double axle_z = 1.31; // front; the rear one is at -axle_z
  static constexpr double wheel_radius = 0.335;
  static constexpr double wheel_x = 0.80; // the middle of a tyre
  static constexpr double tyre_width = 0.235;
  static constexpr double arch_radius = 0.378;
  static constexpr double well_x = 0.50; // how far in a wheel well reaches
};

/// Left and right are alike: only |x| counts.
double body_distance(glm::dvec3 p);

/// A line along which the body bends in a short way: a mesh should have edges there, and where the bend
/// starts and ends.
struct Crease {
  std::function<double(glm::dvec3)> across; // changes its sign at the line; far from 0 where there is none
  double half_width;                        // of the bend, in what `across` measures; 0: only the line
};

/// Of the left half.
std::vector<Crease> creases();

/// The unit normal of the body's surface near `p`.
glm::dvec3 body_normal(glm::dvec3 p);

/// The point of the surface nearest to `p`, to a micrometre, for `p` within some centimetres of it.
glm::dvec3 on_body(glm::dvec3 p);

/// Where the ray from inside leaves the body for good.
glm::dvec3 body_along(glm::dvec3 from_inside, glm::dvec3 direction);

} // namespace unghost::author
