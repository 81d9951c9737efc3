#include "assets/generator/panel_mesh.h"

#include <algorithm>
#include <cmath>

#include "assets/generator/body_shape.h"

namespace unghost::author {

using glm::dvec3;

namespace {

// Rays leave an inner plate for the body, so that they meet the flanks, the top and the ends nearly square.
dvec3 from_plate(dvec3 cage) {
  const dvec3 plate(std::clamp(cage.x, 0.0, 0.45), 0.52, std::clamp(cage.z, -1.75, 1.70));
  dvec3 p = body_along(plate, glm::normalize(cage - plate));
  if (cage.x == 0) p.x = 0;
  return p;
}

bool flatter(const std::array<dvec3, 4>& q) { return glm::distance(q[0], q[2]) <= glm::distance(q[1], q[3]); }

} // namespace

PanelMesh::PanelMesh() {
  const double side = 0.9, low = 0.16, high = 1.15, front = 2.2, back = -2.2;
  const int across = 7, up = 9, along = 28;
  const auto z = [&](double t) { return back + (front - back) * t; };
  add_face(across, along, [&](double u, double v) { return dvec3(side * (1 - u), high, z(v)); });
  add_face(up, along, [&](double u, double v) { return dvec3(side, low + (high - low) * u, z(v)); });
  add_face(across, along, [&](double u, double v) { return dvec3(side * u, low, z(v)); });
  add_face(across, up, [&](double u, double v) { return dvec3(side * u, low + (high - low) * v, front); });
  add_face(across, up,
           [&](double u, double v) { return dvec3(side * (1 - u), low + (high - low) * v, back); });
  weld();
  for (const Crease& crease : creases()) {
    divide(crease.across, 0.03);
    for (const double edge : {-crease.half_width, crease.half_width})
      if (edge != 0) divide([&](dvec3 p) { return crease.across(p) - edge; }, 0.4 * crease.half_width);
  }
  for (int round = 0; round < 5 && refine(0.0032, 0.035); ++round) {
  }
}

void PanelMesh::add_face(int columns, int rows, const std::function<dvec3(double, double)>& cage) {
  const auto first = uint32_t(points_.size());
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      points_.push_back(from_plate(cage(double(column) / columns, double(row) / rows)));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const uint32_t a = first + uint32_t(row * (columns + 1) + column), b = a + 1,
                     d = a + uint32_t(columns) + 1, c = d + 1;
      if (flatter({points_[a], points_[b], points_[c], points_[d]})) {
        triangles_.push_back({{a, b, c}, Panel::paint});
        triangles_.push_back({{a, c, d}, Panel::paint});
      } else {
        triangles_.push_back({{a, b, d}, Panel::paint});
        triangles_.push_back({{b, c, d}, Panel::paint});
      }
    }
  }
}

void PanelMesh::weld() {
  std::vector<uint32_t> kept(points_.size());
  std::vector<dvec3> unique;
  for (size_t i = 0; i < points_.size(); ++i) {
    const auto same = [&](dvec3 p) { return glm::distance(p, points_[i]) < 1e-5; };
    const auto found = std::find_if(unique.begin(), unique.end(), same);
    kept[i] = uint32_t(found - unique.begin());
    if (found == unique.end()) unique.push_back(points_[i]);
  }
  points_.clear();
  for (const dvec3 p : unique) add_point(p);
  for (Triangle& t : triangles_)
    for (uint32_t& corner : t.corner) corner = kept[corner];
}

uint32_t PanelMesh::add_point(dvec3 near_body) {
  points_.push_back(on_body(near_body));
  normals_.push_back(body_normal(points_.back()));
  on_cut_.push_back(false);
  return uint32_t(points_.size() - 1);
}

dvec3 PanelMesh::centroid(const Triangle& t) const {
  return (points_[t.corner[0]] + points_[t.corner[1]] + points_[t.corner[2]]) / 3.0;
}

// Splits every edge whose middle is further than `tolerance` from the body; true if there was one.
bool PanelMesh::refine(double tolerance, double shortest) {
  std::map<Edge, uint32_t> middles;
  for (const Triangle& t : std::vector<Triangle>(triangles_)) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(t.corner[size_t(i)], t.corner[size_t(i + 1) % 3]);
      if (middles.contains({a, b}) || glm::distance(points_[a], points_[b]) < 2 * shortest) continue;
      const dvec3 middle = 0.5 * (points_[a] + points_[b]);
      const double bend = glm::dot(normals_[a], normals_[b]);
      const bool hidden = middle.y < 0.18;
      if (!hidden && (std::abs(body_distance(middle)) > tolerance || bend < 0.87))
        middles[{a, b}] = add_point(middle);
    }
  }
  split(middles);
  return !middles.empty();
}

void PanelMesh::split(const std::map<Edge, uint32_t>& middles) {
  std::vector<Triangle> out;
  for (const Triangle& t : triangles_) {
    std::array<uint32_t, 3> middle; // of the edge from corner i to the next
    std::array<bool, 3> has;
    for (size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(t.corner[i], t.corner[(i + 1) % 3]);
      const auto found = middles.find({a, b});
      has[i] = found != middles.end();
      middle[i] = has[i] ? found->second : 0;
    }
    const int count = has[0] + has[1] + has[2];
    // Turned so that the odd edge out comes first: the only split one, or the only whole one.
    size_t first = 0;
    while (count != 0 && count != 3 && has[first] != (count == 1)) ++first;
    const auto corner = [&](size_t i) { return t.corner[(first + i) % 3]; };
    const auto mid = [&](size_t i) { return middle[(first + i) % 3]; };
    const auto emit = [&](uint32_t a, uint32_t b, uint32_t c) { out.push_back({{a, b, c}, t.panel}); };
    if (count == 0) {
      out.push_back(t);
    } else if (count == 1) {
      emit(corner(0), mid(0), corner(2));
      emit(mid(0), corner(1), corner(2));
    } else if (count == 2) {
      emit(mid(1), corner(2), mid(2));
      const bool short_way = glm::distance(points_[corner(0)], points_[mid(1)]) <
                             glm::distance(points_[corner(1)], points_[mid(2)]);
      emit(corner(0), corner(1), short_way ? mid(1) : mid(2));
      short_way ? emit(corner(0), mid(1), mid(2)) : emit(corner(1), mid(1), mid(2));
    } else {
      emit(corner(0), mid(0), mid(2));
      emit(mid(0), corner(1), mid(1));
      emit(mid(2), mid(1), corner(2));
      emit(mid(0), mid(1), mid(2));
    }
  }
  triangles_ = std::move(out);
}

bool PanelMesh::faces_out(const Triangle& t) const {
  const dvec3 a = points_[t.corner[0]], b = points_[t.corner[1]], c = points_[t.corner[2]];
  return glm::dot(glm::cross(b - a, c - a),
                  normals_[t.corner[0]] + normals_[t.corner[1]] + normals_[t.corner[2]]) > 0;
}

// Whether `v` may go: inside one panel, where the body hardly bends, off the plane of symmetry. Glass keeps
// its points: it mirrors the sky, and shows the least change of a normal.
bool PanelMesh::spare(uint32_t v, const std::vector<size_t>& fan) const {
  if (points_[v].x == 0 || fan.empty()) return false;
  std::map<uint32_t, int> rim;
  for (const size_t i : fan) {
    const Triangle& t = triangles_[i];
    if (t.panel != triangles_[fan.front()].panel || t.panel == Panel::glass) return false;
    for (const uint32_t corner : t.corner) {
      if (corner == v) continue;
      ++rim[corner];
      if (glm::dot(normals_[corner], normals_[v]) < 0.975) return false;
    }
  }
  return std::all_of(rim.begin(), rim.end(), [](const auto& seen) { return seen.second == 2; });
}

// Whether the fan still lies on the body, and faces out, once `v` has been moved onto `onto`.
bool PanelMesh::collapses(uint32_t v, uint32_t onto, const std::vector<size_t>& fan, double tolerance) const {
  for (const size_t i : fan) {
    Triangle t = triangles_[i];
    if (std::find(t.corner.begin(), t.corner.end(), onto) != t.corner.end()) continue;
    std::replace(t.corner.begin(), t.corner.end(), v, onto);
    const dvec3 a = points_[t.corner[0]], b = points_[t.corner[1]], c = points_[t.corner[2]];
    const dvec3 face = glm::cross(b - a, c - a), normal = normals_[onto];
    if (glm::dot(face, normal) < 0.9 * glm::length(face) + 1e-7) return false;
    for (const dvec3 middle : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0})
      if (std::abs(body_distance(middle)) > tolerance) return false;
  }
  return true;
}

void PanelMesh::simplify(double tolerance) {
  std::vector<std::vector<size_t>> around(points_.size());
  for (size_t i = 0; i < triangles_.size(); ++i)
    for (const uint32_t corner : triangles_[i].corner) around[corner].push_back(i);
  std::vector<bool> gone(triangles_.size(), false);
  for (uint32_t v = 0; v < points_.size(); ++v) {
    auto& fan = around[v];
    std::erase_if(fan, [&](size_t i) { return gone[i]; });
    if (!spare(v, fan)) continue;
    std::vector<uint32_t> rim;
    for (const size_t i : fan)
      for (const uint32_t corner : triangles_[i].corner)
        if (corner != v && std::find(rim.begin(), rim.end(), corner) == rim.end()) rim.push_back(corner);
    const auto nearer = [&](uint32_t a, uint32_t b) {
      return glm::distance(points_[a], points_[v]) < glm::distance(points_[b], points_[v]);
    };
    std::sort(rim.begin(), rim.end(), nearer);
    const auto onto =
        std::find_if(rim.begin(), rim.end(), [&](uint32_t w) { return collapses(v, w, fan, tolerance); });
    if (onto == rim.end()) continue;
    for (const size_t i : fan) {
      auto& corner = triangles_[i].corner;
      gone[i] = std::find(corner.begin(), corner.end(), *onto) != corner.end();
      std::replace(corner.begin(), corner.end(), v, *onto);
      if (!gone[i]) around[*onto].push_back(i);
    }
  }
  std::vector<Triangle> left;
  for (size_t i = 0; i < triangles_.size(); ++i)
    if (!gone[i]) left.push_back(triangles_[i]);
  triangles_ = std::move(left);
}

void PanelMesh::sink(Panel panel, dvec3 by, Panel wall) {
  std::map<uint32_t, uint32_t> moved;
  std::map<std::pair<uint32_t, uint32_t>, bool> inside; // directed edges of the panel
  for (const Triangle& t : triangles_)
    if (t.panel == panel)
      for (size_t i = 0; i < 3; ++i) inside[{t.corner[i], t.corner[(i + 1) % 3]}] = true;
  const auto copy = [&](dvec3 p, dvec3 n) {
    points_.push_back(p);
    normals_.push_back(n);
    on_cut_.push_back(true);
    return uint32_t(points_.size() - 1);
  };
  for (Triangle& t : triangles_) {
    if (t.panel != panel) continue;
    for (uint32_t& corner : t.corner) {
      if (!moved.contains(corner)) moved[corner] = copy(points_[corner] + by, normals_[corner]);
      corner = moved[corner];
    }
  }
  for (const auto& [edge, unused] : inside) {
    const dvec3 a = points_[edge.first], b = points_[edge.second];
    if (inside.contains({edge.second, edge.first}) || (a.x == 0 && b.x == 0)) continue;
    const dvec3 n = glm::normalize(glm::cross(b - a, by));
    const uint32_t top_a = copy(a, n), top_b = copy(b, n), low_a = copy(a + by, n), low_b = copy(b + by, n);
    triangles_.push_back({{top_a, low_b, low_a}, wall});
    triangles_.push_back({{top_a, top_b, low_b}, wall});
  }
}

Triangles PanelMesh::both_sides(Panel panel) const {
  std::vector<uint32_t> index(points_.size(), UINT32_MAX);
  Triangles half;
  for (const Triangle& t : triangles_) {
    const dvec3 a = points_[t.corner[0]], b = points_[t.corner[1]], c = points_[t.corner[2]];
    if (t.panel != panel || glm::length(glm::cross(b - a, c - a)) < 1e-8)
      continue; // cutting leaves splinters
    for (const uint32_t corner : t.corner) {
      if (index[corner] == UINT32_MAX) index[corner] = half.add(points_[corner], normals_[corner]);
      half.indices.push_back(index[corner]);
    }
  }
  Triangles both = half;
  both.append(mirrored(half));
  return both;
}

std::vector<std::array<dvec3, 2>> PanelMesh::rims() const {
  std::map<Edge, bool> body;
  for (const Triangle& t : triangles_)
    if (t.panel != Panel::nothing)
      for (size_t i = 0; i < 3; ++i) body[{t.corner[i], t.corner[(i + 1) % 3]}] = true;
  std::vector<std::array<dvec3, 2>> out;
  for (const auto& [edge, unused] : body) {
    const dvec3 a = points_[edge.first], b = points_[edge.second];
    if (!body.contains({edge.second, edge.first}) && std::max(a.x, b.x) > 0.01) out.push_back({a, b});
  }
  return out;
}

} // namespace unghost::author
