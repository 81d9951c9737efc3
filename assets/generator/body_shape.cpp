#include "assets/generator/body_shape.h"

#include <algorithm>
#include <cmath>

#include "assets/generator/curve.h"

namespace unghost::author {

using glm::dvec2, glm::dvec3;

namespace {

// max(a, b) with a fillet about `width` wide (Quilez' polynomial form).
double filleted(double a, double b, double width) {
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::max(a, b) + h * h * width * 0.25;
}

double blended(double a, double b, double width) { return -filleted(-a, -b, width); }

// x for x > 0 and 0 below, turning over about `width`: a crease that still has a radius.
double ramp(double x, double width) { return 0.5 * (x + std::sqrt(x * x + width * width)); }

// The plan: half the width at the waist crease.
const Curve waist_width{{-2.30, 0.80},  {-2.00, 0.868}, {-1.65, 0.915}, {-1.31, 0.928}, {-0.95, 0.912},
                        {-0.45, 0.882}, {0.10, 0.872},  {0.70, 0.888},  {1.10, 0.908},  {1.40, 0.912},
                        {1.75, 0.892},  {2.05, 0.835},  {2.30, 0.76}};
constexpr double skirt_height = 0.295, chin_height = 0.40;
// The crease along the flank rises gently to the tail.
const Curve waist_height{{-2.30, 0.745}, {-1.31, 0.735}, {0.0, 0.675}, {1.31, 0.655}, {2.30, 0.60}};
// The lower body's top along the centre line: bonnet, then hidden below the cabin, then the deck with its
// lip.
const Curve deck_height{{-2.40, 1.00},  {-2.18, 0.968}, {-2.00, 0.925}, {-1.80, 0.915}, {-1.30, 0.925},
                        {-0.60, 0.915}, {0.00, 0.905},  {0.60, 0.893},  {0.95, 0.862},  {1.30, 0.818},
                        {1.65, 0.762},  {1.95, 0.694},  {2.15, 0.628},  {2.30, 0.56}};
// Windscreen, roof and fastback along the centre line.
const Curve roof_height{{-2.30, 0.72},  {-2.05, 0.850}, {-1.75, 0.985}, {-1.45, 1.088}, {-1.10, 1.180},
                        {-0.75, 1.243}, {-0.40, 1.272}, {-0.10, 1.262}, {0.15, 1.212},  {0.40, 1.115},
                        {0.65, 0.992},  {0.90, 0.862},  {1.15, 0.73}};
const Curve cabin_width{{-2.20, 0.50},  {-1.80, 0.575}, {-1.40, 0.648}, {-1.00, 0.705},
                        {-0.50, 0.742}, {0.00, 0.752},  {0.50, 0.742},  {1.00, 0.70}};

// How far the tail lies in from its rearmost: the lip above, lamps in the hollow below it, bumper, diffuser.
const Curve tail_depth{{0.10, 0.19},  {0.20, 0.115}, {0.30, 0.045}, {0.42, 0.008},
                       {0.54, 0.004}, {0.64, 0.022}, {0.72, 0.056}, {0.80, 0.078},
                       {0.87, 0.058}, {0.94, 0.010}, {1.02, -0.05}};

double flank(double x, double y, double z) {
  const double above = y - waist_height(z);
  double width = waist_width(z);
  width -= 0.34 * ramp(above, 0.03) + 0.6 * ramp(above - 0.13, 0.06) * ramp(above - 0.13, 0.06);
  width -= 0.13 * ramp(-above, 0.03);
  const double between_wheels = smooth_step(1.02, 0.55, std::abs(z));
  width -= 0.030 * between_wheels * bell(y - 0.42, 0.14); // the doors are hollow above the sill
  width += 0.42 * between_wheels * ramp(skirt_height - y, 0.02);
  for (const double axle : {Chassis::axle_z, -Chassis::axle_z}) {
    const double from_arch = std::hypot(z - axle, y - Chassis::wheel_radius) - Chassis::arch_radius;
    width += 0.026 * bell(std::max(from_arch, 0.0), 0.085); // flared lips
  }
  return x - width;
}

double deck(double x, double y, double z) {
  double height = deck_height(z) - 0.055 * x * x;
  height += 0.058 * bell(z - 1.38, 0.62) * bell(x - 0.74, 0.19); // front wings stand above the bonnet
  height += 0.050 * bell(z + 1.25, 0.60) * bell(x - 0.80, 0.20); // haunches
  height += 0.016 * smooth_step(0.40, 0.30, x) * smooth_step(2.15, 1.5, z);
  const double slope = (deck_height(z + 0.01) - deck_height(z - 0.01)) / 0.02;
  return (y - height) / std::sqrt(1 + slope * slope);
}

double nose(double x, double y, double z) {
  const double plan = 0.40 * std::pow(x / 0.85, 2.7);
  const double profile =
      0.9 * ramp(y - 0.53, 0.05) * ramp(y - 0.53, 0.05) / 0.2 + 0.28 * ramp(chin_height - y, 0.05);
  return z - (2.215 - plan - profile);
}

double tail(double x, double y, double z) {
  const double plan = 0.27 * std::pow(x / 0.85, 2.9);
  return (-2.215 + plan + tail_depth(y)) - z;
}

constexpr double floor_height = 0.165, tail_fillet = 0.05;

// Flanks and top; and nose and tail.
double around(dvec3 p) {
  const double x = std::abs(p.x);
  return filleted(flank(x, p.y, p.z), deck(x, p.y, p.z), 0.075);
}

double ends(dvec3 p) {
  const double x = std::abs(p.x);
  return std::max(nose(x, p.y, p.z), tail(x, p.y, p.z));
}

double lower_body(dvec3 p) {
  const double sides = filleted(around(p), ends(p), p.z > 0 ? 0.11 : tail_fillet);
  return filleted(sides, floor_height - p.y, 0.03);
}

double cabin(dvec3 p) {
  const double x = std::abs(p.x);
  const double z = p.z + (p.z > -0.4 ? 0.22 : -0.16) * x * x * smooth_step(0.0, 0.7, std::abs(p.z + 0.4));
  const double slope = (roof_height(z + 0.01) - roof_height(z - 0.01)) / 0.02;
  const double roof = (p.y - roof_height(z) + 0.075 * x * x) / std::sqrt(1 + slope * slope);
  const double above = std::max(p.y - 0.92, -0.03); // below the waist the cabin stays inside
  const double side = (x - cabin_width(p.z) + 0.50 * above + 0.45 * above * std::abs(above)) / 1.15;
  const double low = 0.70 + 0.15 * smooth_step(-1.5, -2.0, p.z); // inside the lower body all the way
  return std::max(filleted(roof, side, 0.13), low - p.y);
}

} // namespace

std::vector<Crease> creases() {
  // Where one is cut short, it ends in a wheel arch or under the floor, where an edge more does no harm.
  const auto waist = [](dvec3 p) { return p.y - waist_height(p.z); };
  const auto skirt = [](dvec3 p) { return std::abs(p.z) < 1.1 ? p.y - skirt_height : 1.0; };
  const auto chin = [](dvec3 p) { return p.z > 1.3 ? p.y - chin_height : 1.0; };
  const auto sill = [](dvec3 p) { return p.y - floor_height - 0.025; };
  const auto rear = [](dvec3 p) { return p.z < -1.3 ? around(p) - ends(p) : 1.0; };
  const auto cowl = [](dvec3 p) { return p.y > 0.72 ? lower_body(p) - cabin(p) : -1.0; };
  return {{waist, 0.03}, {skirt, 0.02}, {chin, 0.0}, {sill, 0.0}, {rear, 0.6 * tail_fillet}, {cowl, 0.03}};
}

double body_distance(dvec3 p) { return blended(lower_body(p), cabin(p), 0.035); }

dvec3 body_normal(dvec3 p) {
  const double e = 5e-4;
  dvec3 gradient;
  for (int i = 0; i < 3; ++i) {
    dvec3 step(0);
    step[i] = e;
    gradient[i] = body_distance(p + step) - body_distance(p - step);
  }
  return glm::normalize(gradient);
}

dvec3 on_body(dvec3 p) {
  for (int i = 0; i < 8; ++i) {
    const dvec3 n = body_normal(p);
    const double e = 1e-4;
    const double rate = (body_distance(p + e * n) - body_distance(p - e * n)) / (2 * e);
    p -= n * (body_distance(p) / std::max(rate, 0.3));
  }
  return p;
}

dvec3 body_along(dvec3 from_inside, dvec3 direction) {
  double outside = 3.0;
  while (outside > 0 && body_distance(from_inside + outside * direction) > 0) outside -= 0.02;
  double low = outside, high = outside + 0.02;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (body_distance(from_inside + middle * direction) > 0 ? high : low) = middle;
  }
  return from_inside + low * direction;
}

} // namespace unghost::author
