// What the protocols have in common; protocols.h is for those who measure.
#pragma once

#include "app/measure/flip.h"
#include "app/measure/protocols.h"
#include "app/measure/steadiness.h"

namespace unghost {

void measure_motion(const Measurement& m, Measured& into);      // ghosting, trail
void measure_rest(const Measurement& m, Measured& into);        // shimmer
void measure_error(const Measurement& m, Measured& into);       // error, flicker
void measure_convergence(const Measurement& m, Measured& into); // convergence
void measure_time(const Measurement& m, Measured& into);        // time

/// What Steadiness reads, of the geometry that `mode` has.
std::vector<Wanted> surfaces_wanted(size_t mode = 0);
Surfaces surfaces_of(const std::vector<Wanted>& wanted, FrameResult& result, size_t mode = 0);

/// To 9 significant digits: more say nothing, and make files large.
double rounded(double value);
double mean_of(const std::vector<double>& samples);
void add_sample(MeasuredMode& row, const char* figure, double value);
/// The figure of each row becomes the mean of its samples.
void set_means(Measured& into, const char* figure);

} // namespace unghost
