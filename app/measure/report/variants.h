// Rows that were measured with settings of their own, `rgb:alpha=0.05`, beside the row that they change: what
// each part of a mode costs and saves.
#pragma once

#include <string>

#include "app/measure/results.h"

namespace unghost {

/// Whether `mode` is another one of `m` with other settings.
bool is_variant(const Measured& m, const std::string& mode);
/// All else.
Results without_variants(Results results);
/// Whether there is nothing but variants and the rows that they change.
bool is_of_variants(const Results& results);
/// By changed row, a table a case: a line a variant, a column a figure, and in it how much more or less there
/// is. Empty where no row was changed.
std::string variants_section(const Results& results);

} // namespace unghost
