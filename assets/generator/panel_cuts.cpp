// Cutting a panel mesh along outlines.
#include <algorithm>
#include <cmath>

#include "assets/generator/body_shape.h"
#include "assets/generator/panel_mesh.h"

namespace unghost::author {

using glm::dvec3;

// Points that are already nearly on the outline are moved onto it: fewer slivers than cutting beside them.
void PanelMesh::settle(const Field& field, double within, size_t first) {
  std::vector<std::vector<size_t>> around(points_.size());
  for (size_t i = 0; i < triangles_.size(); ++i)
    for (const uint32_t corner : triangles_[i].corner) around[corner].push_back(i);
  for (size_t i = first; i < points_.size(); ++i) {
    const double value = field(points_[i]);
    if (on_cut_[i] || value == 0 || std::abs(value) > within) continue;
    dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 step(0);
      step[axis] = 1e-4;
      gradient[axis] = (field(points_[i] + step) - field(points_[i] - step)) / 2e-4;
    }
    gradient -= normals_[i] * glm::dot(gradient, normals_[i]);
    if (points_[i].x == 0) gradient.x = 0;
    const double rate = glm::dot(gradient, gradient);
    if (rate < 0.05) continue;
    const dvec3 point = points_[i], normal = normals_[i];
    points_[i] = on_body(point - gradient * (value / rate));
    normals_[i] = body_normal(points_[i]);
    const auto& fan = around[i];
    if (!std::all_of(fan.begin(), fan.end(), [&](size_t t) { return faces_out(triangles_[t]); })) {
      points_[i] = point;
      normals_[i] = normal;
    }
  }
}

// A corner of an outline may dip into a long edge and out of it again: such an edge gets a point between its
// ends.
void PanelMesh::resolve(const Field& field) {
  std::map<Edge, uint32_t> middles;
  for (const Triangle& t : std::vector<Triangle>(triangles_)) {
    for (size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(t.corner[i], t.corner[(i + 1) % 3]);
      const dvec3 middle = 0.5 * (points_[a] + points_[b]);
      if (middles.contains({a, b}) || glm::distance(points_[a], points_[b]) < 0.05) continue;
      const double at_a = field(points_[a]), at_b = field(points_[b]), between = field(middle);
      if (at_a * at_b > 0 && (at_a * between < 0 || std::abs(between) < 0.012))
        middles[{a, b}] = add_point(middle);
    }
  }
  split(middles);
}

void PanelMesh::divide(const Field& field, double within) {
  settle(field, within, 0);
  const size_t before = points_.size();
  std::vector<double> value;
  for (const dvec3 p : points_) value.push_back(field(p));
  const auto crossed = [&](uint32_t a, uint32_t b) {
    return value[a] * value[b] < 0 && std::min(std::abs(value[a]), std::abs(value[b])) > 1e-5;
  };
  std::map<Edge, uint32_t> middles;
  for (const Triangle& t : triangles_) {
    for (size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(t.corner[i], t.corner[(i + 1) % 3]);
      if (!crossed(a, b) || middles.contains({a, b})) continue;
      double low = 0, high = 1;
      for (int step = 0; step < 24; ++step) {
        const double t_middle = 0.5 * (low + high);
        (field(glm::mix(points_[a], points_[b], t_middle)) * value[a] > 0 ? low : high) = t_middle;
      }
      middles[{a, b}] = add_point(glm::mix(points_[a], points_[b], low));
    }
  }
  split(middles);
  settle(field, 0.01, before); // being moved onto the body took the new points off the outline
  for (const auto& [edge, middle] : middles) on_cut_[middle] = true;
  for (size_t i = 0; i < value.size(); ++i)
    if (std::abs(value[i]) <= 1e-5) on_cut_[i] = true;
}

void PanelMesh::cut(const Field& field, Panel from, Panel to) {
  resolve(field);
  divide(field, 0.006);
  for (Triangle& t : triangles_)
    if (t.panel == from && field(centroid(t)) < 0) t.panel = to;
}

void PanelMesh::score(const Field& field, double width, Panel from, Panel to) {
  resolve(field);
  divide([&](dvec3 p) { return field(p) - width / 2; }, 0.1 * width);
  divide([&](dvec3 p) { return field(p) + width / 2; }, 0.1 * width);
  for (Triangle& t : triangles_)
    if (t.panel == from && std::abs(field(centroid(t))) < width / 2) t.panel = to;
}

} // namespace unghost::author
