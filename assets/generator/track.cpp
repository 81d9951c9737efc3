#include "assets/generator/track.h"

#include <cmath>

#include "assets/generator/curve.h"
#include "assets/generator/noise.h"

namespace unghost::author {

using glm::dquat, glm::dvec2, glm::dvec3;

namespace {

const dvec3 centre(Track::radius, 0, 0);

dquat heading(double radians) { return dquat(std::cos(radians / 2), 0, std::sin(radians / 2), 0); }

} // namespace

dvec3 sector_point(double along, double left, double up) {
  const double angle = along / Track::radius, from_centre = Track::radius - left;
  return {-from_centre * std::cos(angle), up, from_centre * std::sin(angle)};
}

Placement sector_placement(int sector) {
  return {.translation = centre, .rotation = heading(2 * Track::pi * sector / Track::sectors)};
}

dvec3 track_point(double along, double left, double up) { return centre + sector_point(along, left, up); }

Placement on_track(double along, double left, double up, double turned) {
  return {.translation = track_point(along, left, up), .rotation = heading(along / Track::radius + turned)};
}

double ground_height(dvec3 place) {
  const double left = Track::radius - glm::distance(dvec2(place.x, place.z), dvec2(centre.x, centre.z));
  const dvec2 p = dvec2(place.x, place.z) / 1024.0 + 0.5;
  const double swell = tiled_noise(p, 9, 61) + 0.4 * tiled_noise(p, 23, 62), bumps = tiled_noise(p, 120, 63);
  const double outside =
      smooth_step(12, 120, -left) * (13 + 8 * swell) + smooth_step(7, 14, -left) * 0.25 * bumps;
  const double inside =
      smooth_step(14, 60, left) * (1.2 + 1.6 * swell) + smooth_step(11, 20, left) * 0.25 * bumps;
  return -0.05 + (left < 0 ? outside : inside);
}

} // namespace unghost::author
