// Names beside the points of a chart, where they hide as little as can be.
#pragma once

#include <string>
#include <vector>

namespace unghost {

struct Label {
  std::string text;
  double x = 0, y = 0; // the point that it names, pixels, y down
  bool bold = false;
};
struct PlacedLabel {
  double x = 0, y = 0; // the left end of the text's baseline
  bool far = false;    // from its point: wants a line there
};
struct Area {
  double left = 0, top = 0, right = 0, bottom = 0;
};
constexpr double label_size = 11;
/// No less than a browser takes, whatever its font.
double text_width(const Label& label);
/// One for each, in their order. `taken`: points that no label should cover.
std::vector<PlacedLabel> place_labels(const std::vector<Label>& labels, const std::vector<Area>& taken,
                                      const Area& within);
/// To the right of their points, in the order of their heights: the names of lines.
std::vector<PlacedLabel> place_at_ends(const std::vector<Label>& labels);

} // namespace unghost
