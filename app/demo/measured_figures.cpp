#include "app/demo/measured_figures.h"

#include <algorithm>

#include "app/failure.h"
#include "app/paths.h"
#include "app/shards.h"
#include "app/table.h"

namespace unghost {
namespace {

constexpr const char* told[] = {"ghosting", "shimmer", "trail"};

} // namespace

MeasuredFigures measured_figures(const std::filesystem::path& results) {
  MeasuredFigures figures;
  try {
    uint64_t largest = 0;
    for (const Measured& scene : results_from_json(read_json(results), results.string()).scenes) {
      const uint64_t pixels = uint64_t(scene.width) * scene.height;
      if (scene.scene != own_scene || pixels < largest) continue;
      if (pixels > largest) figures.clear(), largest = pixels;
      for (const MeasuredMode& row : scene.rows) figures[scene.rig][row.mode] = row;
    }
  } catch (const Failure&) {
    return {};
  }
  return figures;
}

std::string figures_text(const MeasuredFigures& figures, const std::string& rig, const std::string& mode) {
  const auto of_rig = figures.find(rig);
  if (of_rig == figures.end()) return {};
  const auto row = of_rig->second.find(mode);
  if (row == of_rig->second.end()) return {};
  std::string text;
  for (const FigureKind& kind : figure_kinds()) {
    const auto found = row->second.figures.find(std::string(kind.name));
    if (found == row->second.figures.end() || std::ranges::find(told, kind.name) == std::end(told)) continue;
    text += (text.empty() ? "" : ", ") + std::string(kind.label) + " " + fixed(found->second, kind.decimals);
  }
  return text;
}

} // namespace unghost
