#include "assets/generator/car_wheel.h"

#include <cmath>
#include <numbers>

#include "assets/generator/body_shape.h"

namespace unghost::author {

using glm::dvec3;

namespace {

constexpr double tyre = Chassis::wheel_radius, half = Chassis::tyre_width / 2, rim = 0.243,
                 pi = std::numbers::pi;
const dvec3 axle(1, 0, 0);

// A groove runs around the tread; the shoulders are round and the sidewalls bulge a little past the rim.
Triangles tyre_shape() {
  Triangles t;
  add_lathe(t, dvec3(0), axle,
            {{rim - 0.004, -half + 0.012},
             {rim + 0.030, -half - 0.004},
             {tyre - 0.020, -half + 0.006},
             {tyre - 0.004, -half + 0.024},
             {tyre, -half + 0.05},
             {tyre, -0.008, true},
             {tyre - 0.008, -0.005, true},
             {tyre - 0.008, 0.005, true},
             {tyre, 0.008, true},
             {tyre, half - 0.05},
             {tyre - 0.004, half - 0.024},
             {tyre - 0.020, half - 0.006},
             {rim + 0.045, half + 0.004},
             {rim + 0.012, half - 0.003},
             {rim - 0.004, half - 0.012}},
            36);
  return t;
}

// Lip, barrel and back of the rim, seen from outside: the barrel faces the axle.
Triangles rim_shape() {
  Triangles t;
  add_lathe(t, dvec3(0), axle,
            {{rim, half - 0.014, true},
             {rim - 0.004, half - 0.004, true},
             {rim - 0.014, half - 0.006, true},
             {rim - 0.022, half - 0.030},
             {rim - 0.030, half - 0.10, true},
             {rim - 0.030, -half + 0.02}},
            36);
  return t;
}

// A spoke runs from the hub to the rim, dished inwards, with a flat face and chamfered flanks.
void add_spoke(Triangles& to, double angle, double lean) {
  const int rows = 3;
  const auto section = [&](double t, int corner) {
    const double radius = 0.045 + (rim - 0.014 - 0.045) * t, swing = angle + lean * t;
    const double width = 0.0165 - 0.004 * std::sin(pi * t), face = half - 0.046 + 0.036 * t * t;
    static const double across[] = {-1.15, -0.72, 0.72, 1.15}, depth[] = {0.034, 0.0, 0.0, 0.034};
    const double side = across[corner] * width;
    return dvec3(face - depth[corner], radius * std::cos(swing) - side * std::sin(swing),
                 radius * std::sin(swing) + side * std::cos(swing));
  };
  for (int strip = 0; strip < 3; ++strip) {
    for (int row = 0; row < rows; ++row) {
      const double t0 = double(row) / rows, t1 = double(row + 1) / rows;
      add_flat_quad(to, section(t0, strip), section(t1, strip), section(t1, strip + 1),
                    section(t0, strip + 1));
    }
  }
}

Triangles spokes() {
  Triangles t;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * pi * i / 5;
    add_spoke(t, angle - 0.17, 0.075);
    add_spoke(t, angle + 0.17, -0.075);
  }
  add_lathe(t, dvec3(0), axle,
            {{0.074, half - 0.085},
             {0.072, half - 0.050, true},
             {0.060, half - 0.040, true},
             {0.034, half - 0.038, true},
             {0.031, half - 0.034, true},
             {0, half - 0.031}},
            15);
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * pi * (i + 0.5) / 5;
    const dvec3 nut(half - 0.042, 0.050 * std::cos(angle), 0.050 * std::sin(angle));
    add_lathe(t, nut, axle, {{0.009, 0, true}, {0.008, 0.010, true}, {0, 0.011}}, 6);
  }
  return t;
}

Triangles disc() {
  Triangles t;
  add_lathe(t, dvec3(0), axle,
            {{0.178, -0.028, true}, {0.178, 0.0, true}, {0.105, 0.0, true}, {0.100, 0.022, true}, {0, 0.022}},
            28);
  return t;
}

// The dark back of the wheel: nobody looks through the spokes at the far side of the road.
Triangles backing() {
  Triangles t;
  add_lathe(t, dvec3(0), axle, {{rim - 0.028, -half + 0.022}, {0, -half + 0.022}}, 24);
  add_lathe(t, dvec3(0), -axle, {{rim, half - 0.016}, {0, half - 0.016}}, 24);
  return t;
}

} // namespace

std::vector<Part> car_wheel(const CarMaterials& m) {
  Triangles alloy = rim_shape();
  alloy.append(spokes());
  return {{m.rubber, tyre_shape()}, {m.alloy, alloy}, {m.steel, disc()}, {m.plastic, backing()}};
}

std::vector<Part> brake_caliper(const CarMaterials& m, double lead) {
  Triangles t;
  const double inner = 0.112, outer = 0.200, face = 0.028, back = -0.045;
  const auto arc = [&](double u, double radius, double x) {
    const double angle = lead * pi / 2 + 0.62 * (1 - 2 * u);
    return dvec3(x, radius * std::cos(angle), radius * std::sin(angle));
  };
  add_grid(t, 6, 1, [&](double u, double v) { return arc(u, inner + (outer - inner) * v, face); });
  add_grid(t, 6, 1, [&](double u, double v) { return arc(u, outer, face + (back - face) * v); });
  add_grid(t, 6, 1, [&](double u, double v) { return arc(u, inner, back + (face - back) * v); });
  for (const double u : {0.0, 1.0}) {
    const dvec3 a = arc(u, inner, face), b = arc(u, outer, face), c = arc(u, outer, back),
                d = arc(u, inner, back);
    u == 0 ? add_flat_quad(t, a, b, c, d) : add_flat_quad(t, d, c, b, a);
  }
  return {{m.caliper, t}};
}

} // namespace unghost::author
