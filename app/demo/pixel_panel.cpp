#include "app/demo/pixel_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "app/demo/colour_plane.h"
#include "app/demo/setting_widgets.h"
#include "app/measure/rectification.h"
#include "app/table.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/tonemap.h"

namespace unghost {
namespace {

constexpr ImU32 border = IM_COL32(110, 110, 115, 255); // black stands on black
const ImVec4 plain{0.9f, 0.9f, 0.9f, 1};

ImU32 displayed(glm::dvec3 linear, float exposure) {
  const glm::vec3 c = display_from_linear(glm::vec3(linear) * exposure);
  return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1});
}

std::string number(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : "infinite";
  return fixed(value, std::abs(value) < 100 ? 3 : 0);
}
std::string numbers(glm::dvec3 v) { return number(v.x) + " " + number(v.y) + " " + number(v.z); }
std::string pixels(glm::dvec2 v) { return fixed(v.x, 2) + ", " + fixed(v.y, 2) + " px"; }

/// A row's name, and what it is in lines that a person reads.
void begin_row(const char* name, const char* what, ImVec4 colour = plain) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(colour, "%s", name);
  if (ImGui::IsItemHovered()) tooltip(what);
  ImGui::TableNextColumn();
}

void text_row(const char* name, const std::string& value, const char* what) {
  begin_row(name, what);
  ImGui::TextWrapped("%s", value.c_str());
}

void swatch(ImU32 colour, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, colour);
  ImGui::GetWindowDrawList()->AddRect(at, {at.x + size.x, at.y + size.y}, border);
  ImGui::Dummy(size);
}

void colour_row(const char* name, glm::dvec3 linear, float exposure, const char* what, ImVec4 ink = plain) {
  begin_row(name, what, ink);
  const float side = ImGui::GetTextLineHeight();
  swatch(displayed(linear, exposure), {side, side});
  ImGui::SameLine();
  ImGui::TextUnformatted(numbers(linear).c_str());
}

std::string causes_of(const ProbedPixel& pixel) {
  std::string words;
  for (const Answer& test : answers<Reject>())
    if (has(pixel.causes, Reject(test.value))) words += (words.empty() ? "by " : ", ") + test.name;
  if (!words.empty()) return words;
  if (!pixel.mode.taa.policy.needs_history()) return "this mode keeps no history";
  return pixel.history ? "by no test" : "there is no history yet";
}

std::string weight_of(const ProbedPixel& pixel) {
  std::string words = number(double(pixel.weight));
  const Blend blend = pixel.mode.taa.policy.blend;
  if (blend == Blend::counting || blend == Blend::speed)
    words += ", of " + fixed(double(pixel.count), 0) + " frames";
  return words;
}

/// The space, as rows and planes call it.
std::string space_of(const TaaPolicy& policy) {
  const std::string name = policy.space == Space::ycocg ? "YCoCg" : "RGB";
  if (policy.weighting == Weighting::log) return name + " of logarithms";
  return policy.weighting == Weighting::inverse_luminance ? name + " / (1 + L)" : name;
}

void draw_colours(const ProbedPixel& pixel, const Rectification& r) {
  const TaaPolicy policy = pixel.taa().policy;
  colour_row("new frame", glm::dvec3(pixel.colours[4]), pixel.exposure, "As it was drawn, linear.");
  if (pixel.mixed_in != pixel.colours[4])
    colour_row("centred", glm::dvec3(pixel.mixed_in), pixel.exposure,
               "The same at the pixel's middle, as far as that is taken: what is mixed in.");
  if (pixel.history) {
    colour_row("history", glm::dvec3(pixel.history->found), pixel.exposure,
               "As it was read, or lit anew, before anything bounds it; the ring in the planes.",
               history_ink);
    colour_row("rectified", from_working(policy, glm::dvec3(pixel.history->bounded)), pixel.exposure,
               "What the neighbourhood's volume leaves of it; the disc in the planes.", rectified_ink);
  }
  colour_row("result", glm::dvec3(pixel.resolved), pixel.exposure, "After the resolve and its sharpening.");
  if (!pixel.history || policy.rectify == Rectify::none) return;
  if (policy.uses_variance()) {
    text_row("mean", numbers(r.mean), "Of the nine colours, in the space of the planes.");
    text_row("deviation", numbers(r.deviation * double(pixel.mode.taa.gamma)), "Times gamma.");
    return;
  }
  glm::dvec3 low = r.colours[4], high = low;
  for (const glm::dvec3& colour : r.colours) low = glm::min(low, colour), high = glm::max(high, colour);
  text_row("box from", numbers(low), "Least of the nine colours, in the space of the planes.");
  text_row("box to", numbers(high), "Most of them.");
}

void draw_place(const ProbedPixel& pixel) {
  text_row("weight", weight_of(pixel), "Of the new frame in the result; the rest is the rectified history.");
  text_row("rejected", causes_of(pixel),
           "Which tests gave up the history, in whole or in part; by visibility it was lit anew, or bounded "
           "where there is too much light to tell.");
  if (pixel.history) {
    text_row("read at", pixels(pixel.history->at_px),
             "Where the history was read; pixels' centres are at .5.");
    const int x = int(pixel.history->speaker % 3) - 1, y = int(pixel.history->speaker / 3) - 1;
    if (x != 0 || y != 0)
      text_row("follows", "the pixel at " + std::to_string(x) + ", " + std::to_string(y),
               "Whose motion is followed: the dilation's choice among the nine.");
  }
  const bool unknown = !(std::abs(double(pixel.motion_px.x)) < MOTION_UNKNOWN / 2);
  text_row("motion", unknown ? "unknown" : pixels(glm::dvec2(pixel.motion_px)),
           "To where this was in the last frame.");
  text_row("depth", std::isinf(pixel.depth_m) ? "sky" : fixed(double(pixel.depth_m), 2) + " m",
           "Along the view axis.");
  text_row("tag, object", std::to_string(pixel.tag) + ", " + std::to_string(pixel.object),
           "The vehicle's tag, and which object it is; 0: none.");
}

/// The nine as they are seen, and to their right the two planes.
void draw_neighbourhood(const ProbedPixel& pixel, const Rectification& r) {
  ColourPlane plane{.rectification = r, .has_history = pixel.history.has_value()};
  for (size_t i = 0; i < 9; ++i) plane.inks[i] = displayed(glm::dvec3(pixel.colours[i]), pixel.exposure);
  const float side = ImGui::GetTextLineHeight() * 1.1f, gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (size_t i = 0; i < 9; ++i) {
    const ImVec2 corner{at.x + side * float(i % 3), at.y + side * float(i / 3)};
    list.AddRectFilled(corner, {corner.x + side, corner.y + side}, plane.inks[i]);
  }
  list.AddRect({at.x - 1, at.y - 1}, {at.x + 3 * side + 1, at.y + 3 * side + 1}, border);
  list.AddRect({at.x + side - 1, at.y + side - 1}, {at.x + 2 * side + 1, at.y + 2 * side + 1},
               IM_COL32_WHITE);
  const float width = (ImGui::GetContentRegionAvail().x - 3 * side - 2 * gap) / 2;
  ImGui::Dummy({3 * side, 3 * side});
  const bool ycocg = pixel.mode.taa.policy.space == Space::ycocg;
  ImGui::SameLine();
  plane.draw(ycocg ? Axis{1, "Co"} : Axis{0, "R"}, ycocg ? Axis{0, "Y"} : Axis{1, "G"}, width);
  ImGui::SameLine();
  plane.draw(ycocg ? Axis{2, "Cg"} : Axis{2, "B"}, ycocg ? Axis{0, "Y"} : Axis{1, "G"}, width);
  ImGui::TextDisabled("planes of %s", space_of(pixel.mode.taa.policy).c_str());
}

} // namespace

void draw_pixel(const std::optional<ProbedPixel>& pixel) {
  if (!pixel)
    return ImGui::TextWrapped("Click into the picture: why a pixel there keeps its history, or loses it.");
  Neighbourhood linear;
  std::ranges::copy(pixel->colours, linear.begin());
  const Rectification r = rectification_of(pixel->taa(), linear,
                                           glm::dvec3(pixel->history ? pixel->history->found : glm::vec3(0)));
  ImGui::Text("%s at %u, %u", pixel->mode.name.c_str(), pixel->input.x, pixel->input.y);
  if (ImGui::BeginTable("pixel", 2, ImGuiTableFlags_SizingFixedFit)) {
    draw_colours(*pixel, r);
    draw_place(*pixel);
    ImGui::EndTable();
  }
  draw_neighbourhood(*pixel, r);
}

} // namespace unghost
