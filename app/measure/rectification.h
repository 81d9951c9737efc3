// What a resolve makes of a history, in plain double precision: the volume that bounds it, and where in that
// it comes to lie. What shaders are tested with, and what the demo draws of a pixel.
#pragma once

#include <vector>

#include "app/measure/axes.h"
#include "renderer/settings.h"

namespace unghost {

/// The space in which the policy bounds and averages colours: weighted, then RGB or YCoCg.
glm::dvec3 to_working(const TaaPolicy& policy, glm::dvec3 linear);
glm::dvec3 from_working(const TaaPolicy& policy, glm::dvec3 working);

struct Slab {
  glm::dvec3 axis;
  double low, high;
};

/// What bounds a history: along each axis the extent of nine colours of the working space, or `gamma` of
/// their standard deviations about their mean. A clip begins at the current colour, which may lie outside of
/// the latter; its volume holds it. Empty where nothing bounds it.
std::vector<Slab> volume_of(const Neighbourhood& colours, const TaaPolicy& policy, double gamma);
/// How far a colour lies outside; negative: how far inside.
double outside_of(const std::vector<Slab>& volume, glm::dvec3 colour);
/// The corners of such a volume, many of them several times.
std::vector<glm::dvec3> corners_of(const std::vector<Slab>& volume);

/// All colours but `linear` ones are of the working space.
struct Rectification {
  Neighbourhood colours;
  std::vector<Slab> volume;
  glm::dvec3 mean{0}, deviation{0}; // of the nine
  glm::dvec3 found{0}, bounded{0};  // the history as it was read, and after
};
Rectification rectification_of(const TaaSettings& taa, const Neighbourhood& linear, glm::dvec3 found_linear);

} // namespace unghost
