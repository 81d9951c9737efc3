#include "app/measure/axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "renderer/spelling.h"
#include "renderer/taa_modes.h"
#include "shaders/shared/taa_axes.h"

namespace unghost {
namespace {

constexpr size_t sphere_directions = 4096, few_directions = 128;

/// Evenly on the sphere: a spiral of the golden angle.
std::vector<glm::dvec3> directions(size_t count) {
  std::vector<glm::dvec3> all;
  for (size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * double(i) + 1) / double(count), flat = std::sqrt(1 - z * z);
    const double turn = double(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    all.emplace_back(flat * std::cos(turn), flat * std::sin(turn), z);
  }
  return all;
}

struct Slab {
  double low = 0, high = 0; // from the neighbourhood's mean
};

/// Volume over that of the unit sphere, by how far the polytope reaches along each direction from a point
/// inside.
double volume(std::span<const glm::dvec3> axes, std::span<const Slab> slabs,
              std::span<const glm::dvec3> towards) {
  double sum = 0;
  for (const glm::dvec3& direction : towards) {
    double reach = std::numeric_limits<double>::max();
    for (size_t i = 0; i < axes.size(); ++i) {
      const double along = glm::dot(axes[i], direction);
      if (along != 0) reach = std::min(reach, (along > 0 ? slabs[i].high : slabs[i].low) / along);
    }
    sum += reach * reach * reach;
  }
  return sum / double(towards.size());
}

double size_of(std::span<const glm::dvec3> axes, const Neighbourhood& colours,
               std::span<const glm::dvec3> towards) {
  glm::dvec3 mean(0);
  for (const glm::dvec3& colour : colours) mean += colour / 9.0;
  std::vector<Slab> slabs(axes.size());
  for (size_t i = 0; i < axes.size(); ++i)
    for (const glm::dvec3& colour : colours) {
      const double at = glm::dot(colour - mean, axes[i]);
      slabs[i] = {std::min(slabs[i].low, at), std::max(slabs[i].high, at)};
    }
  return std::cbrt(volume(axes, slabs, towards) * 4 / 3 * std::numbers::pi);
}

glm::dvec3 random_axis(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)) + glm::dvec3(1e-9));
}

} // namespace

double volume_around_sphere(std::span<const glm::dvec3> axes) {
  static const std::vector<glm::dvec3> towards = directions(sphere_directions);
  const std::vector<Slab> slabs(axes.size(), {-1, 1});
  return volume(axes, slabs, towards);
}

double size_around(std::span<const glm::dvec3> axes, std::span<const Neighbourhood> neighbourhoods) {
  static const std::vector<glm::dvec3> towards = directions(few_directions);
  double sum = 0;
  for (const Neighbourhood& colours : neighbourhoods) sum += size_of(axes, colours, towards);
  return sum / double(std::max<size_t>(neighbourhoods.size(), 1));
}

FoundAxes find_axes(const AxisSearch& search, const AxisCost& cost,
                    const std::function<void(double)>& progress) {
  constexpr size_t starts = 4;
  std::mt19937_64 random(search.seed);
  std::normal_distribution<double> normal;
  FoundAxes best;
  double least = std::numeric_limits<double>::max();
  for (size_t start = 0; start < starts; ++start) {
    std::vector<glm::dvec3> axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    axes.resize(search.fixed);
    while (axes.size() < search.count) axes.push_back(random_axis(random));
    const std::vector<glm::dvec3> first = axes;
    double now = cost(axes);
    const size_t steps = search.steps / starts;
    for (size_t step = 0; step < steps; ++step) {
      const double turn = 0.5 * std::pow(0.004, double(step) / double(steps));
      glm::dvec3& axis = axes[search.fixed + random() % (search.count - search.fixed)];
      const glm::dvec3 before = axis;
      axis = glm::normalize(axis + turn * glm::dvec3(normal(random), normal(random), normal(random)));
      const double after = cost(axes);
      if (after < now)
        now = after;
      else
        axis = before;
      if (step % 64 == 0) progress((double(start) + double(step) / double(steps)) / starts);
    }
    if (now < least) least = now, best = {axes, first};
  }
  progress(1);
  return best;
}

std::vector<glm::dvec3> shipped_axes(std::string_view name) {
#define UNGHOST_AXIS(x, y, z) glm::dvec3(x, y, z),
#define UNGHOST_LIST(answer, list) {Axes::answer, {list(UNGHOST_AXIS)}},
  const std::pair<Axes, std::vector<glm::dvec3>> lists[] = {TAA_AXIS_LISTS(UNGHOST_LIST)};
#undef UNGHOST_LIST
#undef UNGHOST_AXIS
  for (const auto& [axes, list] : lists)
    if (spelling(axes) == name) return list;
  return {};
}

} // namespace unghost
