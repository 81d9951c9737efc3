// Rows that were measured with settings of their own, `rgb:alpha=0.05`, beside the row that they change: what
// each part of a mode costs and saves.
#pragma once

#include <string>

#include "app/measure/results.h"

namespace unghost {

/// Whether `mode` is another one of `m` with other settings.
bool is_variant(const Measured& m, const std::string& mode);
/// What it changes, as `--set` takes it, with commas between several.
std::string change_of(const std::string& mode);
/// All else.
Results without_variants(Results results);
/// By changed row, a table a figure: how much more or less of it there is with each change, in each case.
/// Empty where no row was changed.
std::string variants_section(const Results& results);

} // namespace unghost
