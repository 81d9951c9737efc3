// The curves a body is drawn with: heights and widths along one axis, and closed outlines in one view.
#pragma once

#include <initializer_list>
#include <vector>

#include <glm/glm.hpp>

namespace unghost::author {

/// A natural cubic spline through keys (x, y) with rising x; straight on beyond its ends. Its second
/// derivative is continuous, which is what keeps reflections in paint free of kinks.
class Curve {
public:
  Curve(std::initializer_list<glm::dvec2> keys);
  double operator()(double x) const;

private:
  std::vector<glm::dvec2> keys_;
  std::vector<double> second_; // the second derivative at each key
};

/// A closed outline in a plane, counter-clockwise or not; negative inside.
class Outline {
public:
  /// Corners joined by straight lines.
  explicit Outline(std::vector<glm::dvec2> corners);
  /// A closed Catmull-Rom spline through the points, as a fine polygon.
  static Outline smooth(const std::vector<glm::dvec2>& points);
  /// The polygon with each corner rounded by cutting it `rounds` times (Chaikin): stays close to straight
  /// sides.
  static Outline rounded(std::vector<glm::dvec2> corners, int rounds = 3);

  double distance(glm::dvec2 p) const;

private:
  std::vector<glm::dvec2> corners_;
};

/// 0 below `low`, 1 above `high`, smooth in between.
double smooth_step(double low, double high, double x);
double bell(double x, double width);

} // namespace unghost::author
