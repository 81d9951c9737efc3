#include "assets/generator/triangles.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace unghost::author {

using glm::dmat3, glm::dvec2, glm::dvec3, glm::dvec4;

uint32_t Triangles::add(dvec3 position, dvec3 normal) {
  positions.push_back(position);
  normals.push_back(glm::normalize(normal));
  return uint32_t(positions.size() - 1);
}

uint32_t Triangles::add(dvec3 position, dvec3 normal, dvec2 uv, dvec4 colour) {
  uvs.push_back(uv);
  colours.push_back(colour);
  return add(position, normal);
}

void Triangles::triangle(uint32_t a, uint32_t b, uint32_t c) { indices.insert(indices.end(), {a, b, c}); }

void Triangles::quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  triangle(a, b, c);
  triangle(a, c, d);
}

void Triangles::append(const Triangles& other) {
  const auto first = uint32_t(positions.size());
  positions.insert(positions.end(), other.positions.begin(), other.positions.end());
  normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
  colours.insert(colours.end(), other.colours.begin(), other.colours.end());
  for (const uint32_t index : other.indices) indices.push_back(first + index);
}

void add_flat_quad(Triangles& to, dvec3 a, dvec3 b, dvec3 c, dvec3 d) {
  const dvec3 normal = glm::cross(c - a, d - b);
  const uint32_t first = to.add(a, normal);
  to.add(b, normal);
  to.add(c, normal);
  to.add(d, normal);
  to.quad(first, first + 1, first + 2, first + 3);
}

void add_box(Triangles& to, dvec3 centre, dvec3 half, const dmat3& turn) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      dvec3 out(0), across(0), up(0);
      out[axis] = side * half[axis];
      across[(axis + 1) % 3] = side * half[(axis + 1) % 3];
      up[(axis + 2) % 3] = half[(axis + 2) % 3];
      const auto at = [&](dvec3 p) { return centre + turn * p; };
      add_flat_quad(to, at(out - across - up), at(out + across - up), at(out + across + up),
                    at(out - across + up));
    }
  }
}

namespace {

// The normals of a profile: for each point, what the segment before it and the one after it see.
std::vector<std::pair<dvec2, dvec2>> profile_normals(const std::vector<ProfilePoint>& profile) {
  std::vector<dvec2> segment;
  for (size_t i = 0; i + 1 < profile.size(); ++i) {
    const dvec2 d(profile[i + 1].radius - profile[i].radius, profile[i + 1].along - profile[i].along);
    segment.push_back(glm::normalize(dvec2(d.y, -d.x))); // (out from the axis, along it)
  }
  std::vector<std::pair<dvec2, dvec2>> normals;
  for (size_t i = 0; i < profile.size(); ++i) {
    const dvec2 before = segment[i == 0 ? 0 : i - 1], after = segment[i + 1 == profile.size() ? i - 1 : i];
    const dvec2 smooth = glm::normalize(before + after);
    normals.push_back(profile[i].crease ? std::pair(before, after) : std::pair(smooth, smooth));
  }
  return normals;
}

} // namespace

void add_lathe(Triangles& to, dvec3 centre, dvec3 axis, const std::vector<ProfilePoint>& profile,
               int segments) {
  axis = glm::normalize(axis);
  const dvec3 side =
      glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
  const dvec3 third = glm::cross(axis, side);
  const auto normals = profile_normals(profile);
  const auto spoke = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % segments) / segments;
    return std::cos(angle) * side + std::sin(angle) * third;
  };
  for (size_t row = 0; row + 1 < profile.size(); ++row) {
    const ProfilePoint &a = profile[row], &b = profile[row + 1];
    const dvec2 na = normals[row].second, nb = normals[row + 1].first;
    const auto first = uint32_t(to.positions.size());
    for (int i = 0; i <= segments; ++i) {
      const dvec3 out = spoke(i);
      to.add(centre + a.radius * out + a.along * axis, na.x * out + na.y * axis);
      to.add(centre + b.radius * out + b.along * axis, nb.x * out + nb.y * axis);
    }
    for (uint32_t i = 0; i < uint32_t(segments); ++i) {
      const uint32_t v = first + 2 * i;
      if (a.radius > 0) to.triangle(v, v + 2, v + 1);
      if (b.radius > 0) to.triangle(v + 1, v + 2, v + 3);
    }
  }
}

void add_grid(Triangles& to, int columns, int rows, const std::function<dvec3(double, double)>& surface) {
  const auto first = uint32_t(to.positions.size());
  const double step = 1e-4;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double u = double(column) / columns, v = double(row) / rows;
      const dvec3 du = surface(u + step, v) - surface(u - step, v),
                  dv = surface(u, v + step) - surface(u, v - step);
      to.add(surface(u, v), glm::cross(du, dv));
    }
  }
  const auto at = [&](int column, int row) { return first + uint32_t(row * (columns + 1) + column); };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      to.quad(at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1));
}

void add_rounded(Triangles& to, dvec3 centre, dvec3 half, double power, int cells, const dmat3& turn) {
  const auto lift = [power](dvec3 p) {
    return std::pow(std::pow(std::abs(p.x), power) + std::pow(std::abs(p.y), power) +
                        std::pow(std::abs(p.z), power),
                    1 / power);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto first = uint32_t(to.positions.size());
      for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
          dvec3 p(0);
          p[axis] = side;
          p[(axis + 1) % 3] = side * std::tan((2.0 * column / cells - 1) * std::numbers::pi / 4);
          p[(axis + 2) % 3] = std::tan((2.0 * row / cells - 1) * std::numbers::pi / 4);
          p /= lift(p);
          dvec3 n;
          for (int i = 0; i < 3; ++i)
            n[i] = std::copysign(std::pow(std::abs(p[i]), power - 1), p[i]) / half[i];
          to.add(centre + turn * (half * p), turn * n);
        }
      }
      const auto at = [&](int column, int row) { return first + uint32_t(row * (cells + 1) + column); };
      for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column)
          to.quad(at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1));
    }
  }
}

Triangles mirrored(const Triangles& from) {
  return transformed(from, dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), dvec3(0));
}

Triangles transformed(const Triangles& from, const dmat3& linear, dvec3 offset) {
  Triangles to = from;
  const dmat3 for_normals = glm::transpose(glm::inverse(linear));
  for (dvec3& p : to.positions) p = linear * p + offset;
  for (dvec3& n : to.normals) n = glm::normalize(for_normals * n);
  if (glm::determinant(linear) < 0)
    for (size_t i = 0; i < to.indices.size(); i += 3) std::swap(to.indices[i + 1], to.indices[i + 2]);
  return to;
}

dmat3 turn_about(dvec3 axis, double radians) { return dmat3(glm::rotate(glm::dmat4(1.0), radians, axis)); }

} // namespace unghost::author
