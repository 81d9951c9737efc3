// A mesh that lies on the car's body and knows, triangle by triangle, what it is made of: refined until it
// follows the body, then cut along outlines, so that a window or a shut line is a clean edge in the mesh and
// not a decal above it.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <vector>

#include <glm/glm.hpp>

#include "assets/generator/triangles.h"

namespace unghost::author {

enum class Panel { paint, glass, gap, trim, lamp, lamp_bowl, tail_lamp, grille, duct, plastic, nothing };

class PanelMesh {
public:
  /// The left half of the body (x >= 0), all paint.
  PanelMesh();

  /// Negative inside an outline, positive outside, in the body's frame.
  using Field = std::function<double(glm::dvec3)>;

  /// Splits the triangles that `field` crosses; what is inside and was `from` becomes `to`.
  void cut(const Field& field, Panel from, Panel to);
  /// Cuts a seam `width` wide along the outline into what is `from`.
  void score(const Field& field, double width, Panel from, Panel to);
  /// Takes out points that the body's shape and the outlines can do without, to `tolerance` metres.
  void simplify(double tolerance);
  /// Moves all of `panel` along `by`, and closes the step with walls of `wall`.
  void sink(Panel panel, glm::dvec3 by, Panel wall);

  /// Everything of one panel, on both sides of the car.
  Triangles both_sides(Panel panel) const;
  /// The edges of what was cut away to `nothing`, the body to their left. Ask before anything is sunk.
  std::vector<std::array<glm::dvec3, 2>> rims() const;

private:
  struct Triangle {
    std::array<uint32_t, 3> corner;
    Panel panel;
  };
  using Edge = std::pair<uint32_t, uint32_t>; // the lower index first

  void add_face(int columns, int rows, const std::function<glm::dvec3(double, double)>& cage);
  void weld();
  bool refine(double tolerance, double shortest);
  uint32_t add_point(glm::dvec3 near_body);
  void split(const std::map<Edge, uint32_t>& middles);
  void settle(const Field& field, double within, size_t first);
  bool spare(uint32_t v, const std::vector<size_t>& fan) const;
  bool collapses(uint32_t v, uint32_t onto, const std::vector<size_t>& fan, double tolerance) const;
  void resolve(const Field& field);
  void divide(const Field& field, double within);
  glm::dvec3 centroid(const Triangle& t) const;
  bool faces_out(const Triangle& t) const;

  std::vector<glm::dvec3> points_, normals_;
  std::vector<bool> on_cut_; // a point of an outline: no later cut may move it
  std::vector<Triangle> triangles_;
};

} // namespace unghost::author
