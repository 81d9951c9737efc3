// FLIP once more, by its description alone: in double, with whole filters and the library's own pow, and
// nothing of the program's. Slow, and plain enough to be checked against the paper (Andersson et al. 2020).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "renderer/scene/scene.h"

namespace unghost {
namespace flip_oracle {

using Colour = std::array<double, 3>;
using Plane = std::vector<double>;

struct Size {
  std::ptrdiff_t width = 0, height = 0;
};

inline Colour times(const std::array<double, 9>& m, const Colour& c) {
  return {m[0] * c[0] + m[1] * c[1] + m[2] * c[2], m[3] * c[0] + m[4] * c[1] + m[5] * c[2],
          m[6] * c[0] + m[7] * c[1] + m[8] * c[2]};
}

/// XYZ over that of white (D65).
inline Colour normalized_xyz(const Colour& linear) {
  constexpr double a = 24577794, b = 12288897, c = 73733382;
  const Colour xyz = times({10135552 / a, 8788810 / a, 4435075 / a, 2613072 / b, 8788810 / b, 887015 / b,
                            1425312 / c, 8788810 / c, 70074185 / c},
                           linear);
  return {xyz[0] / 0.950428545, xyz[1], xyz[2] / 1.088900371};
}

inline Colour linear_of_xyz(const Colour& normalized) {
  return times({3.241003275, -1.537398934, -0.498615861, -0.969224334, 1.875930071, 0.041554224, 0.055639423,
                -0.204011202, 1.057148933},
               {normalized[0] * 0.950428545, normalized[1], normalized[2] * 1.088900371});
}

inline double linear_of_byte(int byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// CIELab, with Hunt's effect on a and b.
inline Colour lab(const Colour& linear) {
  const auto root = [](double t) {
    const double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const Colour xyz = normalized_xyz(linear);
  const double l = 116 * root(xyz[1]) - 16;
  return {l, 0.01 * l * 500 * (root(xyz[0]) - root(xyz[1])), 0.01 * l * 200 * (root(xyz[1]) - root(xyz[2]))};
}

inline double hyab(const Colour& p, const Colour& q) {
  return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

/// `weight(x)` for x of -radius to radius.
template <class Weight> Plane filter_of(int radius, const Weight& weight) {
  Plane filter;
  for (int x = -radius; x <= radius; ++x) filter.push_back(weight(x));
  return filter;
}

inline double sum_of(const Plane& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

/// Along the rows or down the columns; the border goes on.
inline Plane correlated(const Plane& plane, Size size, const Plane& filter, bool along) {
  Plane out(plane.size());
  const auto radius = std::ptrdiff_t(filter.size() / 2);
  for (std::ptrdiff_t y = 0; y < size.height; ++y)
    for (std::ptrdiff_t x = 0; x < size.width; ++x) {
      double sum = 0;
      for (std::ptrdiff_t i = -radius; i <= radius; ++i) {
        const std::ptrdiff_t column = std::clamp<std::ptrdiff_t>(x + (along ? i : 0), 0, size.width - 1);
        const std::ptrdiff_t row = std::clamp<std::ptrdiff_t>(y + (along ? 0 : i), 0, size.height - 1);
        sum += filter[size_t(i + radius)] * plane[size_t(row * size.width + column)];
      }
      out[size_t(y * size.width + x)] = sum;
    }
  return out;
}

inline Plane correlated(const Plane& plane, Size size, const Plane& along, const Plane& down) {
  return correlated(correlated(plane, size, along, true), size, down, false);
}

/// a sqrt(pi / b) exp(-pi^2 r^2 / b), r in degrees.
struct Gaussian {
  double a, b;
};

/// A sum of round Gaussians, normalised as a whole: each of them is a product of two along the axes.
inline Plane contrast_filtered(const Plane& plane, Size size, const std::vector<Gaussian>& terms,
                               double ppd) {
  constexpr double pi = std::numbers::pi;
  const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
  Plane out(plane.size(), 0.0);
  double whole = 0;
  for (const Gaussian& term : terms) {
    const Plane one =
        filter_of(radius, [&](int x) { return std::exp(-pi * pi * (x / ppd) * (x / ppd) / term.b); });
    const double scale = term.a * std::sqrt(pi / term.b);
    const Plane part = correlated(plane, size, one, one);
    for (size_t i = 0; i < out.size(); ++i) out[i] += scale * part[i];
    whole += scale * sum_of(one) * sum_of(one);
  }
  for (double& value : out) value /= whole;
  return out;
}

/// A derivative's filter whose positive weights add up to 1 and its negative ones to -1.
inline Plane balanced(Plane filter) {
  double positive = 0, negative = 0;
  for (const double weight : filter) (weight > 0 ? positive : negative) += std::abs(weight);
  for (double& weight : filter) weight /= weight > 0 ? positive : negative;
  return filter;
}

/// Of the lightness: how strong a derivative is, whichever way it points.
inline Plane strength(const Plane& lightness, Size size, const Plane& derivative, const Plane& gaussian) {
  const Plane x = correlated(lightness, size, derivative, gaussian),
              y = correlated(lightness, size, gaussian, derivative);
  Plane out;
  for (size_t i = 0; i < x.size(); ++i) out.push_back(std::hypot(x[i], y[i]));
  return out;
}

struct Looked {
  std::vector<Colour> colours; // CIELab after Hunt's effect
  Plane edge, point;
};

inline Looked looked_at(const Image& picture, double ppd) {
  const Size size{.width = picture.width, .height = picture.height};
  std::array<Plane, 4> planes; // Y, Cx, Cz, and lightness of 0 to 1
  for (size_t i = 0; i < size_t(size.width * size.height); ++i) {
    const uint8_t* c = &picture.rgba[4 * i];
    const Colour n = normalized_xyz({linear_of_byte(c[0]), linear_of_byte(c[1]), linear_of_byte(c[2])});
    const Colour opponent{116 * n[1] - 16, 500 * (n[0] - n[1]), 200 * (n[1] - n[2])};
    for (size_t plane = 0; plane < 3; ++plane) planes[plane].push_back(opponent[plane]);
    planes[3].push_back((opponent[0] + 16) / 116);
  }
  const Plane yy = contrast_filtered(planes[0], size, {{1, 0.0047}, {0, 1e-5}}, ppd),
              cx = contrast_filtered(planes[1], size, {{1, 0.0053}, {0, 1e-5}}, ppd),
              cz = contrast_filtered(planes[2], size, {{34.1, 0.04}, {13.5, 0.025}}, ppd);
  Looked out;
  for (size_t i = 0; i < yy.size(); ++i) {
    const double y = (yy[i] + 16) / 116;
    Colour linear = linear_of_xyz({y + cx[i] / 500, y, y - cz[i] / 200});
    for (double& channel : linear) channel = std::clamp(channel, 0.0, 1.0);
    out.colours.push_back(lab(linear));
  }
  const double sd = 0.5 * 0.082 * ppd;
  const int radius = int(std::ceil(3 * sd));
  const auto g = [sd](int x) { return std::exp(-x * x / (2 * sd * sd)); };
  Plane gaussian = filter_of(radius, g);
  const double sum = sum_of(gaussian);
  for (double& weight : gaussian) weight /= sum;
  const Plane first = balanced(filter_of(radius, [&](int x) { return -x * g(x); })),
              second = balanced(filter_of(radius, [&](int x) { return (x * x / (sd * sd) - 1) * g(x); }));
  out.edge = strength(planes[3], size, first, gaussian);
  out.point = strength(planes[3], size, second, gaussian);
  return out;
}

/// Of a distance between colours, 0 to 1.
inline double colour_error(double distance) {
  const double most = std::pow(hyab(lab({0, 1, 0}), lab({0, 0, 1})), 0.7), knee = 0.4 * most;
  const double far = std::pow(distance, 0.7);
  return far < knee ? 0.95 * far / knee : 0.95 + 0.05 * (far - knee) / (most - knee);
}

} // namespace flip_oracle

/// The error of each pixel of two 8-bit sRGB pictures of one size, row by row.
inline std::vector<double> oracle_flip(const Image& reference, const Image& test, double ppd) {
  using namespace flip_oracle;
  const Looked r = looked_at(reference, ppd), t = looked_at(test, ppd);
  std::vector<double> errors;
  for (size_t i = 0; i < r.colours.size(); ++i) {
    const double edge = std::abs(r.edge[i] - t.edge[i]), point = std::abs(r.point[i] - t.point[i]);
    const double feature = std::sqrt(std::max(edge, point) / std::sqrt(2.0));
    errors.push_back(std::pow(colour_error(hyab(r.colours[i], t.colours[i])), 1 - feature));
  }
  return errors;
}

} // namespace unghost
