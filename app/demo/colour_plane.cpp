#include "app/demo/colour_plane.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/table.h"

namespace unghost {
namespace {

constexpr ImU32 paper = IM_COL32(38, 38, 42, 255), edge = IM_COL32(170, 170, 175, 255),
                volume_ink = IM_COL32(120, 170, 255, 255);

/// Counterclockwise, none of them on a line (Andrew 1979).
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points) {
  const auto before = [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::ranges::sort(points, before);
  std::vector<glm::dvec2> hull;
  const auto add = [&](glm::dvec2 point, size_t least) {
    const auto turns_right = [&] {
      const glm::dvec2 a = hull.back() - hull[hull.size() - 2], b = point - hull.back();
      return a.x * b.y - a.y * b.x <= 0;
    };
    while (hull.size() > least && turns_right()) hull.pop_back();
    hull.push_back(point);
  };
  for (const glm::dvec2& point : points) add(point, 1);
  const size_t lower = hull.size();
  for (auto point = points.rbegin(); point != points.rend(); ++point)
    if (point != points.rbegin()) add(*point, lower);
  return hull;
}

/// Where numbers lie in the square.
struct Frame {
  ImVec2 at;
  float width;
  glm::dvec2 low{1e30}, high{-1e30};

  void hold(glm::dvec2 point) { low = glm::min(low, point), high = glm::max(high, point); }
  void widen() {
    const glm::dvec2 margin = glm::max((high - low) * 0.08, 1e-4);
    low -= margin, high += margin;
  }
  ImVec2 operator()(glm::dvec2 point) const {
    const glm::dvec2 share = (point - low) / (high - low);
    return {at.x + width * float(share.x), at.y + width * float(1 - share.y)};
  }
};

/// Three decimals and no 0 before them: two of these have to fit below a square.
std::string brief(double value) {
  std::string words = fixed(value, std::abs(value) < 10 ? 3 : 1);
  if (const size_t zero = words.find("0."); zero <= 1 && std::abs(value) < 1) words.erase(zero, 1);
  return words;
}

/// Below the square: the least to the left, the most to the right.
void write_ends(Axis axis, double low, double high, const Frame& frame) {
  const std::string most = brief(high);
  const float y = ImGui::GetCursorScreenPos().y;
  ImGui::SetCursorScreenPos({frame.at.x, y});
  ImGui::TextDisabled("%s %s", axis.name, brief(low).c_str());
  ImGui::SetCursorScreenPos({frame.at.x + frame.width - ImGui::CalcTextSize(most.c_str()).x, y});
  ImGui::TextDisabled("%s", most.c_str());
}

} // namespace

void ColourPlane::draw(Axis across, Axis up, float width) const {
  const auto flat = [&](glm::dvec3 c) { return glm::dvec2(c[across.component], c[up.component]); };
  const Rectification& r = rectification;
  Frame frame{.at = ImGui::GetCursorScreenPos(), .width = width};
  std::vector<glm::dvec2> corners;
  for (const glm::dvec3& corner : corners_of(r.volume))
    corners.push_back(flat(corner)), frame.hold(corners.back());
  for (const glm::dvec3& colour : r.colours) frame.hold(flat(colour));
  if (has_history) frame.hold(flat(r.found)), frame.hold(flat(r.bounded));
  frame.widen();

  ImGui::BeginGroup();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{frame.at.x + width, frame.at.y + width};
  list.AddRectFilled(frame.at, end, paper);
  std::vector<ImVec2> outline;
  for (const glm::dvec2& corner : hull_of(corners)) outline.push_back(frame(corner));
  list.AddPolyline(outline.data(), int(outline.size()), volume_ink, ImDrawFlags_Closed, 1.5f);
  const float dot = width / 36;
  for (size_t i = 0; i < 9; ++i) {
    const ImVec2 at = frame(flat(r.colours[i]));
    const float half = i == 4 ? 1.6f * dot : dot;
    list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, inks[i]);
    list.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, i == 4 ? IM_COL32_WHITE : edge);
  }
  if (has_history) {
    const ImVec2 from = frame(flat(r.found)), to = frame(flat(r.bounded));
    list.AddLine(from, to, ImGui::ColorConvertFloat4ToU32(history_ink));
    list.AddCircle(from, 1.8f * dot, ImGui::ColorConvertFloat4ToU32(history_ink), 0, 1.5f);
    list.AddCircleFilled(to, 1.3f * dot, ImGui::ColorConvertFloat4ToU32(rectified_ink));
  }
  ImGui::Dummy({width, width});
  write_ends(up, frame.low.y, frame.high.y, frame);
  write_ends(across, frame.low.x, frame.high.x, frame);
  ImGui::EndGroup();
}

} // namespace unghost
