#include "app/measure/rectification.h"

#include <algorithm>
#include <cmath>

namespace unghost {
namespace {

constexpr double log_offset = 4.54e-5; // as taa_colour.glsl has it

double luminance(glm::dvec3 c) { return glm::dot(c, glm::dvec3(0.2126, 0.7152, 0.0722)); }

glm::dvec3 ycocg(glm::dvec3 c) {
  return {(c.x + 2 * c.y + c.z) / 4, (c.x - c.z) / 2, (2 * c.y - c.x - c.z) / 4};
}
glm::dvec3 rgb(glm::dvec3 c) { return {c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z}; }

/// What is not a number ends here.
glm::dvec3 finite(glm::dvec3 colour) {
  for (int i = 0; i < 3; ++i) colour[i] = std::isfinite(colour[i]) ? std::max(colour[i], 0.0) : 0;
  return colour;
}

bool clamps(const TaaPolicy& policy) {
  return policy.rectify == Rectify::box_clamp || policy.rectify == Rectify::variance_clamp;
}

/// The nearest place of the box, no brighter than the brightest of what it was made from.
glm::dvec3 clamped(const TaaPolicy& policy, const Rectification& r) {
  glm::dvec3 bounded;
  for (int i = 0; i < 3; ++i)
    bounded[i] = std::clamp(r.found[i], r.volume[size_t(i)].low, r.volume[size_t(i)].high);
  if (policy.weighting != Weighting::inverse_luminance) return bounded;
  const auto brightness = [&](glm::dvec3 c) { return luminance(policy.space == Space::ycocg ? rgb(c) : c); };
  double brightest = brightness(r.found);
  for (const glm::dvec3& colour : r.colours) brightest = std::max(brightest, brightness(colour));
  return bounded * std::min(1.0, brightest / std::max(brightness(bounded), 1e-6));
}

/// Along the segment from the current colour, as far as the volume reaches.
glm::dvec3 clipped(const Rectification& r) {
  double share = 1;
  const glm::dvec3 centre = r.colours[4], along = r.found - centre;
  for (const Slab& slab : r.volume) {
    const double d = glm::dot(along, slab.axis), from = glm::dot(centre, slab.axis);
    if (d != 0) share = std::min(share, std::max((d > 0 ? slab.high - from : slab.low - from) / d, 0.0));
  }
  return share >= 1 ? r.found : centre + along * share;
}

} // namespace

glm::dvec3 to_working(const TaaPolicy& policy, glm::dvec3 linear) {
  glm::dvec3 c = linear;
  if (policy.weighting == Weighting::inverse_luminance) c /= 1 + luminance(c);
  if (policy.weighting == Weighting::log) c = glm::log(glm::max(c, 0.0) + log_offset);
  return policy.space == Space::ycocg ? ycocg(c) : c;
}

glm::dvec3 from_working(const TaaPolicy& policy, glm::dvec3 working) {
  glm::dvec3 c = policy.space == Space::ycocg ? rgb(working) : working;
  if (policy.weighting == Weighting::log) c = glm::exp(c) - log_offset;
  c = glm::max(c, 0.0);
  return policy.weighting == Weighting::inverse_luminance ? c / std::max(1 - luminance(c), 1e-5) : c;
}

std::vector<Slab> volume_of(const Neighbourhood& colours, const TaaPolicy& policy, double gamma) {
  std::vector<Slab> slabs;
  if (policy.rectify == Rectify::none) return slabs;
  for (const glm::dvec3& axis :
       shipped_axes(policy.uses_dop() ? spelling(policy.axes) : spelling(Axes::xyz))) {
    double low = 1e30, high = -1e30, mean = 0, squares = 0;
    for (const glm::dvec3& colour : colours) {
      const double at = glm::dot(colour, axis);
      low = std::min(low, at), high = std::max(high, at), mean += at / 9;
    }
    for (const glm::dvec3& colour : colours) squares += std::pow(glm::dot(colour, axis) - mean, 2) / 9;
    const double reach = gamma * std::sqrt(squares);
    if (policy.uses_variance()) low = mean - reach, high = mean + reach;
    const double own = glm::dot(colours[4], axis);
    if (!clamps(policy)) low = std::min(low, own), high = std::max(high, own);
    slabs.push_back({axis, low, high});
  }
  return slabs;
}

double outside_of(const std::vector<Slab>& volume, glm::dvec3 colour) {
  double most = -1e30;
  for (const Slab& slab : volume) {
    const double at = glm::dot(colour, slab.axis);
    most = std::max({most, slab.low - at, at - slab.high});
  }
  return most;
}

// An edge lies where two faces meet, between the other faces; its ends are corners.
std::vector<glm::dvec3> corners_of(const std::vector<Slab>& volume) {
  std::vector<glm::dvec3> corners;
  const auto add_edge = [&](size_t a, size_t b, double at_a, double at_b) {
    const glm::dvec3 &p = volume[a].axis, &q = volume[b].axis, along = glm::cross(p, q);
    const double size = glm::dot(along, along);
    const glm::dvec3 on = (at_a * glm::cross(q, along) + at_b * glm::cross(along, p)) / size;
    double first = -1e30, last = 1e30;
    for (size_t i = 0; i < volume.size(); ++i) {
      if (i == a || i == b) continue;
      const double d = glm::dot(along, volume[i].axis), from = glm::dot(on, volume[i].axis);
      const double rounding = 1e-9 * (std::abs(from) + volume[i].high - volume[i].low);
      double low = volume[i].low - rounding - from, high = volume[i].high + rounding - from;
      if (std::abs(d) < 1e-12 && (low > 0 || high < 0)) return;
      if (std::abs(d) < 1e-12) continue;
      if (d < 0) std::swap(low, high);
      first = std::max(first, low / d), last = std::min(last, high / d);
    }
    if (first <= last && first > -1e29 && last < 1e29)
      corners.insert(corners.end(), {on + first * along, on + last * along});
  };
  for (size_t a = 0; a < volume.size(); ++a)
    for (size_t b = a + 1; b < volume.size(); ++b)
      for (const double at_a : {volume[a].low, volume[a].high})
        for (const double at_b : {volume[b].low, volume[b].high}) add_edge(a, b, at_a, at_b);
  return corners;
}

Rectification rectification_of(const TaaSettings& taa, const Neighbourhood& linear, glm::dvec3 found_linear) {
  const TaaPolicy& policy = taa.policy;
  Rectification r;
  for (size_t i = 0; i < 9; ++i) r.colours[i] = to_working(policy, finite(linear[i]));
  for (const glm::dvec3& colour : r.colours) r.mean += colour / 9.0;
  for (const glm::dvec3& colour : r.colours) r.deviation += (colour - r.mean) * (colour - r.mean) / 9.0;
  r.deviation = glm::sqrt(r.deviation);
  r.volume = volume_of(r.colours, policy, double(taa.gamma));
  r.found = r.bounded = to_working(policy, found_linear);
  if (!r.volume.empty()) r.bounded = clamps(policy) ? clamped(policy, r) : clipped(r);
  return r;
}

} // namespace unghost
