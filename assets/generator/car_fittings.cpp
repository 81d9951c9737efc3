#include "assets/generator/car_fittings.h"

#include <cmath>

#include "assets/generator/body_shape.h"

namespace unghost::author {

using glm::dmat3, glm::dvec3;

namespace {

// Where a line along an axis meets the body, and a frame there: z out of the surface, y as upright as it
// goes.
struct Seat {
  dvec3 point;
  dmat3 frame;
};

Seat seat(dvec3 from_inside, dvec3 direction) {
  const dvec3 point = body_along(from_inside, direction), out = body_normal(point);
  const dvec3 right = glm::normalize(glm::cross(dvec3(0, 1, 0), out));
  return {point, dmat3(right, glm::cross(out, right), out)};
}

Seat on_nose(double x, double y) { return seat({x, y, 1.4}, {0, 0, 1}); }
Seat on_tail(double x, double y) { return seat({x, y, -1.6}, {0, 0, -1}); }
Seat on_flank(double y, double z) { return seat({0.3, y, z}, {1, 0, 0}); }
Seat on_top(double x, double z) { return seat({x, 0.5, z}, {0, 1, 0}); }

struct Fittings {
  Triangles paint, black, chrome, plastic, lamp, mirror, plate, indicator;
};

void add_mirror(Fittings& to) {
  const dvec3 centre(0.945, 0.975, 0.45);
  const dmat3 turn = turn_about({0, 1, 0}, -0.12);
  add_rounded(to.paint, centre, {0.105, 0.066, 0.075}, 2.7, 5, turn);
  add_rounded(to.mirror, centre + dvec3(0.006, -0.002, -0.062), {0.086, 0.050, 0.016}, 3.2, 3, turn);
  add_rounded(to.black, {0.835, 0.932, 0.475}, {0.085, 0.018, 0.030}, 3, 3, turn_about({0, 0, 1}, 0.38));
}

void add_handle(Fittings& to) {
  const Seat at = on_flank(0.775, -0.44);
  add_rounded(to.chrome, at.point + at.frame * dvec3(0, 0, 0.008), {0.085, 0.011, 0.012}, 3, 3, at.frame);
  const Seat side_lamp = on_flank(0.56, 0.80);
  add_rounded(to.indicator, side_lamp.point, {0.035, 0.009, 0.006}, 3, 2, side_lamp.frame);
}

void add_headlight(Fittings& to) {
  for (const dvec3 place : {dvec3(0.615, 0.588, 0.033), dvec3(0.715, 0.612, 0.031)}) {
    const Seat at = on_nose(place.x, place.y);
    const dvec3 axis = glm::normalize(dvec3(0.25, 0.1, 1)), bowl = at.point + dvec3(-0.012, -0.008, -0.045);
    add_lathe(
        to.chrome, bowl, axis,
        {{place.z, -0.01}, {place.z, 0.022, true}, {place.z - 0.006, 0.026, true}, {place.z - 0.010, 0.010}},
        14);
    add_lathe(to.lamp, bowl, axis, {{place.z - 0.009, 0.012}, {place.z - 0.016, 0.022}, {0, 0.026}}, 12);
  }
}

void add_exhaust(Fittings& to) {
  for (const double x : {0.40, 0.515}) {
    add_lathe(to.chrome, {x, 0.262, -2.06}, {0, 0, -1},
              {{0.044, -0.06}, {0.047, 0.088}, {0.045, 0.093, true}, {0.041, 0.090}, {0.039, 0.02}}, 16);
    add_lathe(to.plastic, {x, 0.262, -2.08}, {0, 0, -1}, {{0.042, 0}, {0, 0}}, 12);
  }
  for (const double x : {0.12, 0.27}) add_box(to.plastic, {x, 0.225, -2.06}, {0.006, 0.065, 0.10});
}

// A bar across the mouth, the nose's plan held back by `behind`: front, top and underside.
void add_grille_bar(Triangles& to, double y, double reach, double behind) {
  const int cells = 6;
  const auto at = [&](int i) {
    const double x = reach * i / cells;
    dvec3 p = on_nose(x, y).point;
    return p - dvec3(0, 0, behind);
  };
  const dvec3 up(0, 0.006, 0), back(0, 0, -0.03);
  for (int i = 0; i < cells; ++i) {
    const dvec3 a = at(i), b = at(i + 1);
    add_flat_quad(to, b - up, a - up, a + up, b + up);
    add_flat_quad(to, b + up, a + up, a + up + back, b + up + back);
    add_flat_quad(to, b - up + back, a - up + back, a - up, b - up);
  }
}

// A blade under the chin, following the bumper's plan: its top, its edge and its underside.
void add_splitter(Triangles& to) {
  const int cells = 12;
  const double top = 0.205, low = 0.180;
  const auto at = [&](int i, double out, double y) {
    const dvec3 p = on_nose(0.79 * i / cells, 0.215).point, n = body_normal(p);
    const double taper = out > 0 ? 1 - 0.75 * std::pow(double(i) / cells, 4) : 1;
    return dvec3(p.x, y, p.z) + out * taper * glm::normalize(dvec3(n.x, 0, n.z));
  };
  for (int i = 0; i < cells; ++i) {
    const dvec3 a = at(i, 0.055, top - 0.006), b = at(i + 1, 0.055, top - 0.006);
    const dvec3 c = at(i, 0.055, low), d = at(i + 1, 0.055, low);
    add_flat_quad(to, a, b, at(i + 1, -0.03, top), at(i, -0.03, top));
    add_flat_quad(to, c, d, b, a);
    add_flat_quad(to, at(i, -0.06, low), at(i + 1, -0.06, low), d, c);
  }
  add_flat_quad(to, at(cells, 0.055, low), at(cells, -0.06, low), at(cells, -0.03, top),
                at(cells, 0.055, top - 0.006));
}

void add_wiper(Fittings& to) {
  const auto lifted = [](double x, double z, double by) {
    const Seat at = on_top(x, z);
    return at.point + by * at.frame[2];
  };
  const auto bar = [&](dvec3 a, dvec3 b, double thick) {
    const dvec3 along = glm::normalize(b - a), out = body_normal(0.5 * (a + b));
    const dvec3 side = glm::normalize(glm::cross(out, along));
    add_box(to.black, 0.5 * (a + b), {thick, thick, glm::distance(a, b) / 2},
            dmat3(side, glm::cross(along, side), along));
  };
  for (const double x : {0.06, -0.50}) {
    bar(lifted(x, 0.84, 0.008), lifted(x + 0.30, 0.745, 0.016), 0.007);
    bar(lifted(x + 0.03, 0.755, 0.010), lifted(x + 0.52, 0.715 - (x > 0 ? 0.03 : 0), 0.010), 0.004);
  }
}

// A character of straight strokes, a bit each, in a box one wide and two high: top, right above, right below,
// bottom, left below, left above, middle, stem.
void add_character(Triangles& to, const Seat& at, uint32_t strokes, dvec3 corner, double size) {
  static const glm::dvec4 lines[] = {{0, 2, 1, 2}, {1, 1, 1, 2}, {1, 0, 1, 1}, {0, 0, 1, 0},
                                     {0, 0, 0, 1}, {0, 1, 0, 2}, {0, 1, 1, 1}, {0.5, 0, 0.5, 2}};
  for (uint32_t i = 0; i < 8; ++i) {
    if ((strokes >> i & 1) == 0) continue;
    const double thick = 0.13;
    const glm::dvec4 line = lines[i];
    const auto place = [&](double x, double y) {
      return at.point + at.frame * (corner + size * dvec3(x, y, 0));
    };
    const double left = line.x - thick, low = line.y - thick, right = line.z + thick, high = line.w + thick;
    add_flat_quad(to, place(left, low), place(right, low), place(right, high), place(left, high));
  }
}

void add_plate(Fittings& to, const Seat& at) {
  constexpr uint32_t ghost[] = {0b00111101, 0b01110110, 0b00111111, 0b01101101, 0b10000001}; // G H 0 5 T
  add_box(to.plate, at.point, {0.26, 0.056, 0.006}, at.frame);
  for (int i = 0; i < 5; ++i)
    add_character(to.plastic, at, ghost[i], {-0.20 + 0.085 * i, -0.035, 0.0075}, 0.035);
}

void add_middle(Fittings& to) {
  const Seat nose = on_nose(0, 0.545);
  add_lathe(to.chrome, nose.point, nose.frame[2],
            {{0.040, -0.01}, {0.040, 0.004, true}, {0.033, 0.007, true}, {0, 0.009}}, 24);
  const Seat tail = on_tail(0, 0.865);
  add_lathe(to.chrome, tail.point, tail.frame[2],
            {{0.034, -0.01}, {0.034, 0.004, true}, {0.028, 0.006, true}, {0, 0.008}}, 24);
  Seat rear_plate = on_tail(0, 0.60);
  rear_plate.point += 0.006 * rear_plate.frame[2];
  add_plate(to, rear_plate);
  add_plate(to, {on_nose(0, 0.335).point + dvec3(0, 0, -0.002), dmat3(1.0)});
  add_wiper(to);
}

} // namespace

std::vector<Part> car_fittings(const CarMaterials& m) {
  Fittings half;
  add_mirror(half);
  add_handle(half);
  add_headlight(half);
  add_exhaust(half);
  add_splitter(half.plastic);
  for (const double y : {0.30, 0.34, 0.38, 0.42})
    add_grille_bar(half.chrome, y, y > 0.40 ? 0.47 : 0.50, 0.018);
  Fittings middle;
  add_middle(middle);
  const auto both = [](const Triangles& mirrored_too, const Triangles& alone) {
    Triangles t = mirrored_too;
    t.append(mirrored(mirrored_too));
    t.append(alone);
    return t;
  };
  return {
      {m.paint, both(half.paint, middle.paint)},    {m.gloss_black, both(half.black, middle.black)},
      {m.chrome, both(half.chrome, middle.chrome)}, {m.plastic, both(half.plastic, middle.plastic)},
      {m.lamp, both(half.lamp, middle.lamp)},       {m.chrome, both(half.mirror, middle.mirror)},
      {m.plate, both(half.plate, middle.plate)},    {m.indicator, both(half.indicator, middle.indicator)}};
}

} // namespace unghost::author
