// The charts of one scene, rig and size.
#pragma once

#include "app/measure/report/chart.h"

namespace unghost {

using Looks = std::map<std::string, Look>;

/// The figures that are weighed against time: each has its work-precision diagram.
std::vector<const FigureKind*> judged_by();
/// Those of them that any mode has, and that mean something there: nothing ghosts where nothing moves.
std::vector<const FigureKind*> errors_in(const Measured& m);
/// Whether it has that figure and a time, and the figure says something of it.
bool is_candidate(const Measured& m, const MeasuredMode& row, const FigureKind& kind);
/// Of the candidates, by rising time: indices of m.rows. Times that their rounds do not
/// tell apart are equal, as are errors that are shown alike. A mode that adds no time is the aliased frame;
/// what is measured against that frame (no jitter) says nothing of it.
std::vector<size_t> front_of(const Measured& m, const FigureKind& kind);

/// Where there is nothing to show, there is no chart.
std::vector<Chart> work_precision(const Measured& m, const Looks& looks, const std::string& id);
std::vector<Chart> convergence_charts(const Measured& m, const Looks& looks, const std::string& id);
std::vector<Chart> time_charts(const Measured& m, const Looks& looks, const std::string& id);
std::vector<Chart> trail_charts(const Measured& m, const Looks& looks, const std::string& id);

} // namespace unghost
