// Triangle lists while they are being authored, in double precision, and the few solids that most props are
// made of.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

namespace unghost::author {

/// `uvs` and `colours` are either empty or as long as `positions`. Counter-clockwise from outside.
struct Triangles {
  std::vector<glm::dvec3> positions, normals;
  std::vector<glm::dvec2> uvs;
  std::vector<glm::dvec4> colours; // linear
  std::vector<uint32_t> indices;

  uint32_t add(glm::dvec3 position, glm::dvec3 normal);
  uint32_t add(glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv, glm::dvec4 colour);
  void triangle(uint32_t a, uint32_t b, uint32_t c);
  /// Two triangles a b c, a c d.
  void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d);
  /// Both must have the same attributes.
  void append(const Triangles& other);
};

/// A flat quad with vertices of its own: a b c d counter-clockwise.
void add_flat_quad(Triangles& to, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d);

/// A box with flat faces, from its centre and half sizes along the axes of `turn`.
void add_box(Triangles& to, glm::dvec3 centre, glm::dvec3 half, const glm::dmat3& turn = glm::dmat3(1.0));

/// One point of a profile that turns about an axis: distance from it, place along it. `crease` splits the
/// normals.
struct ProfilePoint {
  double radius, along;
  bool crease = false;
};

/// A surface of revolution about `axis` through `centre`. It faces away from the axis where the profile runs
/// along +axis, and along +axis where the profile runs inwards.
void add_lathe(Triangles& to, glm::dvec3 centre, glm::dvec3 axis, const std::vector<ProfilePoint>& profile,
               int segments);

/// A grid of (columns + 1) x (rows + 1) points of a surface over the unit square, with normals from its
/// derivatives: they point along d/du x d/dv.
void add_grid(Triangles& to, int columns, int rows, const std::function<glm::dvec3(double, double)>& surface);

/// A closed, rounded solid: a cube's grid pushed out to the superellipsoid |x|^power + ... = 1, then mapped
/// to `centre` + `turn` * (half * p).
void add_rounded(Triangles& to, glm::dvec3 centre, glm::dvec3 half, double power, int cells,
                 const glm::dmat3& turn = glm::dmat3(1.0));

/// The mirror image in the plane x = 0.
Triangles mirrored(const Triangles& from);

/// The same triangles after `p -> linear * p + offset`; `linear` turns, mirrors or scales.
Triangles transformed(const Triangles& from, const glm::dmat3& linear, glm::dvec3 offset);

glm::dmat3 turn_about(glm::dvec3 axis, double radians);

} // namespace unghost::author
