// What stands beside the road: lamps, marker posts, signs, a gantry.
#include "assets/generator/track.h"

#include <cmath>

namespace unghost::author {

using glm::dvec3;

namespace {

int add_lamp_mesh(Glb& glb, const WorldMaterials& m) {
  Triangles pole, head;
  add_lathe(pole, dvec3(0), {0, 1, 0}, {{0.11, -0.1}, {0.11, 0.9, true}, {0.085, 0.95, true}, {0.05, 7.6}},
            10);
  for (int i = 0; i < 4; ++i) { // the arm bends over towards the road
    const double a = Track::pi / 2 * i / 4, b = Track::pi / 2 * (i + 1) / 4;
    const dvec3 from(1.2 * (1 - std::cos(a)), 7.6 + 0.9 * std::sin(a), 0),
        to(1.2 * (1 - std::cos(b)), 7.6 + 0.9 * std::sin(b), 0);
    const dvec3 along = glm::normalize(to - from), out = glm::cross(along, dvec3(0, 0, 1));
    add_box(pole, 0.5 * (from + to), {0.042, glm::distance(from, to) / 2 + 0.02, 0.042},
            {out, along, glm::cross(out, along)});
  }
  add_rounded(head, {1.55, 8.50, 0}, {0.42, 0.07, 0.15}, 3, 3);
  return glb.add_mesh("lamp", {{m.post, pole}, {m.galvanised, head}});
}

int add_marker_mesh(Glb& glb, const WorldMaterials& m) {
  Triangles white, black, red;
  add_box(white, {0, 0.32, 0}, {0.055, 0.42, 0.03});
  add_box(black, {0, 0.83, 0}, {0.055, 0.09, 0.03});
  add_box(white, {0, 0.95, 0}, {0.055, 0.03, 0.03});
  add_box(red, {0, 0.83, 0}, {0.025, 0.05, 0.035});
  return glb.add_mesh("marker_post", {{m.kerb_white, white}, {m.dark, black}, {m.reflector, red}});
}

// Looks back along the road; its arrow points left.
int add_chevron_mesh(Glb& glb, const WorldMaterials& m) {
  Triangles board, arrow, post;
  add_box(board, {0, 1.45, 0}, {0.55, 0.40, 0.015});
  add_box(post, {-0.35, 0.5, 0.03}, {0.03, 0.75, 0.02});
  add_box(post, {0.35, 0.5, 0.03}, {0.03, 0.75, 0.02});
  for (const double x : {-0.42, 0.04}) {
    for (const double up : {-1.0, 1.0}) {
      const dvec3 tip(x + 0.34, 1.45, -0.018), wing(x, 1.45 + up * 0.33, -0.018), wide(0.16, 0, 0);
      up > 0 ? add_flat_quad(arrow, tip, tip - wide, wing - wide * 0.9, wing + wide * 0.1)
             : add_flat_quad(arrow, tip, wing + wide * 0.1, wing - wide * 0.9, tip - wide);
    }
  }
  return glb.add_mesh("chevron_board", {{m.kerb_red, board}, {m.kerb_white, arrow}, {m.post, post}});
}

int add_round_sign_mesh(Glb& glb, const WorldMaterials& m) {
  Triangles post, red, white, back;
  add_lathe(post, dvec3(0), {0, 1, 0}, {{0.035, -0.2}, {0.035, 2.5, true}, {0, 2.52}}, 8);
  const dvec3 face(0, 2.2, -0.05);
  add_lathe(red, face, {0, 0, -1}, {{0.38, -0.008}, {0.38, 0.006, true}, {0.29, 0.006}}, 28);
  add_lathe(white, face, {0, 0, -1}, {{0.29, 0.006}, {0, 0.006}}, 28);
  add_lathe(back, face, {0, 0, 1}, {{0.38, 0.008}, {0, 0.008}}, 28);
  Triangles digits; // "80"
  for (const double x : {0.10, -0.10}) {
    for (const double y : {-0.14, 0.0, 0.14})
      if (x > 0 || y != 0) add_box(digits, face + dvec3(x, y, -0.009), {0.075, 0.018, 0.002});
    for (const double side : {-0.058, 0.058})
      add_box(digits, face + dvec3(x + side, 0, -0.009), {0.018, 0.14, 0.0015});
  }
  return glb.add_mesh(
      "speed_sign",
      {{m.post, post}, {m.kerb_red, red}, {m.kerb_white, white}, {m.galvanised, back}, {m.dark, digits}});
}

// Over both lanes, between towers outside the shoulders: local x 0 is the path's middle.
int add_gantry_mesh(Glb& glb, const WorldMaterials& m) {
  Triangles steel, board, light;
  const double right = -4.4, left = 8.0, low = 5.6, high = 6.6;
  for (const double x : {right, left})
    for (const double z : {-0.4, 0.4}) add_box(steel, {x, high / 2, z}, {0.09, high / 2, 0.09});
  for (const double z : {-0.4, 0.4})
    for (const double y : {low, high})
      add_box(steel, {(left + right) / 2, y, z}, {(left - right) / 2, 0.06, 0.06});
  const int bays = 12;
  for (int i = 0; i < bays; ++i) {
    const double a = right + (left - right) * i / bays, b = right + (left - right) * (i + 1) / bays;
    for (const double z : {-0.4, 0.4}) {
      const dvec3 from(a, i % 2 == 0 ? low : high, z), to(b, i % 2 == 0 ? high : low, z);
      const dvec3 along = glm::normalize(to - from), out = glm::cross(along, dvec3(0, 0, 1));
      add_box(steel, 0.5 * (from + to), {0.035, glm::distance(from, to) / 2, 0.035},
              {out, along, glm::cross(out, along)});
    }
  }
  add_box(board, {1.8, 6.15, -0.55}, {3.6, 0.62, 0.05});
  for (int i = 0; i < 5; ++i)
    add_lathe(light, {-0.6 + 1.2 * i, 6.15, -0.61}, {0, 0, -1}, {{0.24, 0}, {0.22, 0.05, true}, {0, 0.06}},
              16);
  return glb.add_mesh("gantry", {{m.galvanised, steel}, {m.dark, board}, {m.reflector, light}});
}

} // namespace

void add_roadside(Glb& glb, const WorldMaterials& m) {
  const int lamp = add_lamp_mesh(glb, m), marker = add_marker_mesh(glb, m),
            chevron = add_chevron_mesh(glb, m);
  const auto place = [&](const char* name, int i, int mesh, const Placement& where) {
    glb.add_node(name + std::to_string(i), -1, where, {{"mesh", mesh}});
  };
  for (int i = 0; i < Track::sectors; ++i) {
    place("lamp_", i, lamp, on_track(Track::sector_length * (i + 0.25), -7.4));
    for (const int half : {0, 1}) {
      const double along = Track::sector_length * (i + 0.5 * half);
      place("marker_right_", 2 * i + half, marker, on_track(along, -3.15, -0.05));
      place("marker_left_", 2 * i + half, marker, on_track(along, 10.2, -0.05));
    }
  }
  for (int i = 0; i < 12; ++i) place("chevron_", i, chevron, on_track(64 + 8.0 * i, -6.7, -0.05, -0.15));
  const int speed = add_round_sign_mesh(glb, m);
  for (const int i : {0, 1, 2, 3}) place("speed_sign_", i, speed, on_track(38 + 230.0 * i, -5.0, -0.05));
  const int gantry = add_gantry_mesh(glb, m);
  place("gantry_", 0, gantry, on_track(128, 0));
  place("gantry_", 1, gantry, on_track(600, 0));
}

} // namespace unghost::author
