// What a report says where its order of modes is not that of the paper: measured explanations.
#pragma once

#include "app/measure/report/report_page.h"

namespace unghost {

/// A paragraph for each pair of methods that the paper has in another order, in shimmer or ghosting: how far
/// apart the two lie here with a 95% interval over frames, how far apart in the paper, and in which order
/// they stand in the paper's other scene.
PageNotes report_notes(const Results& results);

} // namespace unghost
