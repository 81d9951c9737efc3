// A comparison with a baseline, for people.
#pragma once

#include <string>

#include "app/measure/baseline.h"

namespace unghost {

/// A line a figure that has changed, what has become worse first; then, in sentences, how many are the same
/// and what could not be compared.
std::string comparison_text(const BaselineComparison& comparison);

} // namespace unghost
