// The report: one HTML file of what was measured, which opens without a network.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/measure/baseline.h"
#include "app/measure/results.h"
#include "app/measure/stability_table.h"
#include "renderer/scene/scene.h"

namespace unghost {

/// A frame's picture that a shard kept; `file` as in KeptFrame. Nothing where it is not there.
using FindPicture = std::function<std::optional<Image>(const KeptFrame&, const std::string& file)>;
/// Other results that these are compared with.
struct Baseline {
  std::string file;
  BaselineComparison comparison;
};
/// What the page says beside the results.
struct PageNotes {
  std::vector<std::string>
      paragraphs; // measured explanations beside the comparison with the paper: plain text
  std::optional<Baseline> baseline;
  std::optional<StabilityTable> stability;
};

/// UTF-8. The same bytes for the same data. What was not measured is not there.
std::string report_page(const Results& results, const FindPicture& pictures, const PageNotes& notes);

} // namespace unghost
