// A render scale that holds a frame time.
#pragma once

namespace unghost {

constexpr double least_scale = 0.5, scale_step = 0.05;
/// So many frames are drawn between two looks at their times: each change drops the histories.
constexpr unsigned frames_between_scales = 30;

/// The scale for the next frames, where those of the last took `measured_ms`; along each axis, from
/// least_scale to 1, in whole steps. It stays where it is within a tenth of what is wanted.
double next_scale(double scale, double measured_ms, double wanted_ms);

} // namespace unghost
