#include "app/demo/overlay.h"

#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/demo/actions.h"

namespace unghost {
namespace {

constexpr float margin = 8, padding = 4;
constexpr ImU32 paper = IM_COL32(0, 0, 0, 170), dark = IM_COL32(0, 0, 0, 255),
                recording_ink = IM_COL32(255, 80, 70, 255), picked_ink = IM_COL32(255, 210, 60, 255),
                ink = IM_COL32(255, 255, 255, 255);

/// Of words in lines of at most that width; 0: in one.
ImVec2 size_of(const std::string& words, float width) {
  return ImGui::CalcTextSize(words.c_str(), nullptr, false, width);
}

/// Words on a dark ground, so that they read on any picture.
void write(ImVec2 at, const std::string& words, float width = 0, ImU32 colour = ink) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 size = size_of(words, width);
  list.AddRectFilled({at.x - padding, at.y - padding}, {at.x + size.x + padding, at.y + size.y + padding},
                     paper, 2);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, colour, words.c_str(), nullptr, width);
}

bool is_digit(const Action& action) { return action.key >= GLFW_KEY_0 && action.key <= GLFW_KEY_9; }

void key_row(const DemoState& state, const Action& action) {
  const std::string why_not = action.why_not(state);
  if (!why_not.empty()) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  ImGui::TableNextRow();
  for (const std::string& cell : {key_text(action), std::string(button_text(action)), action.what,
                                  why_not.empty() ? action.present(state) : why_not}) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(cell.c_str());
  }
  if (!why_not.empty()) ImGui::PopStyleColor();
}

/// The keys of digits in one row: there are ten of them.
void numbers_row() {
  std::string names;
  for (const Action& action : actions())
    if (is_digit(action))
      names += (names.empty() ? "" : ", ") + action.what.substr(action.what.find(' ') + 1);
  ImGui::TableNextRow();
  ImGui::TableNextColumn(), ImGui::TextUnformatted("1 to 0");
  ImGui::TableNextColumn(), ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetFontSize() * 26);
  ImGui::TextUnformatted(names.c_str());
  ImGui::PopTextWrapPos();
}

} // namespace

std::vector<Label> labels_of(const DemoState& state, const ScreenInput& screen,
                             std::span<const size_t> shown) {
  const auto name = [&](size_t i) { return state.modes[shown[i]].name; };
  const auto of_both = [](std::string words) {
    return std::vector<Label>{{.at = {margin, margin}, .words = std::move(words)}};
  };
  if (state.arrangement == Arrangement::difference && shown.size() > 1)
    return of_both(name(0) + " - " + name(1) + ", times 8");
  if (state.arrangement == Arrangement::flip && shown.size() > 1)
    return of_both("FLIP of " + name(0) + " and " + name(1) + ": yellow is 1");
  std::vector<Label> labels;
  for (const ScreenCell& cell : cells_of(screen, shown.size())) {
    const bool right = state.arrangement == Arrangement::split && cell.mode == 1;
    const double x = right ? cell.shown.x + cell.shown.width - double(margin) : cell.shown.x + double(margin);
    labels.push_back(
        {.at = {x, cell.shown.y + double(margin)}, .words = name(cell.mode), .to_the_left = right});
  }
  return labels;
}

void draw_labels(const DemoState& state, const PicturePlace& place, std::span<const size_t> shown) {
  if (shown.size() < 2 && !state.flicker) return;
  for (const Label& label : labels_of(state, place.screen, shown)) {
    const float width = label.to_the_left ? ImGui::CalcTextSize(label.words.c_str()).x : 0;
    write({float(place.at.x + label.at.x) - width, float(place.at.y + label.at.y)}, label.words);
  }
}

void draw_marker(const DemoState& state, const PicturePlace& place, size_t modes, glm::ivec2 picture_px) {
  if (!state.picked) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const glm::dvec2 pixel = pixel_of(*state.picked, picture_px);
  for (const ScreenCell& cell : cells_of(place.screen, modes)) {
    const glm::dvec2 step = glm::dvec2(cell.picture.width, cell.picture.height) / glm::dvec2(picture_px);
    const glm::dvec2 corner = place.at + glm::dvec2(cell.picture.x, cell.picture.y) + pixel * step;
    const ScreenRect& seen = cell.shown;
    const ImVec2 low{float(place.at.x) + float(seen.x), float(place.at.y) + float(seen.y)};
    list.PushClipRect(low, {low.x + float(seen.width), low.y + float(seen.height)});
    const bool of_this = cell.mode == state.picked->mode || modes <= state.picked->mode;
    for (const auto& [gap, colour] : {std::pair(5.0, dark), std::pair(4.0, of_this ? picked_ink : ink)})
      list.AddRect({float(corner.x - gap), float(corner.y - gap)},
                   {float(corner.x + step.x + gap), float(corner.y + step.y + gap)}, colour);
    list.PopClipRect();
  }
}

void draw_message(const std::string& message, const PicturePlace& place) {
  if (message.empty()) return;
  const float width = std::max(float(place.screen.width) - 4 * margin, 1.0f);
  const ImVec2 size = size_of(message, width);
  write({float(place.at.x + place.screen.width / 2.0) - size.x / 2,
         float(place.at.y + place.screen.height) - size.y - 3 * margin},
        message, width);
}

void draw_path_notice(const DemoState& state, const PicturePlace& place) {
  const ImVec2 below_labels{float(place.at.x) + margin,
                            float(place.at.y) + 2 * margin + padding + ImGui::GetTextLineHeight()};
  if (state.recorded)
    write(below_labels, "recording, " + std::to_string(*state.recorded) + " frames", 0, recording_ink);
  if (state.replayed) write(below_labels, "replay, " + std::to_string(*state.replayed) + " frames");
}

void draw_keys(const DemoState& state, const PicturePlace& place) {
  // from the right edge over the panel, if need be: beside it, half of a small window is too little for words
  const ImVec2 window{float(place.at.x + place.screen.width), float(place.screen.height)};
  ImGui::SetNextWindowPos({window.x, window.y / 2}, ImGuiCond_Always, {1, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, window);
  constexpr auto plain = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("keys", nullptr, plain) &&
      ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) {
    for (const char* head : {"key", "gamepad", "what it does", "now"}) ImGui::TableSetupColumn(head);
    ImGui::TableHeadersRow();
    numbers_row();
    for (const Action& action : actions())
      if (!is_digit(action)) key_row(state, action);
    ImGui::EndTable();
    ImGui::TextUnformatted(
        "Mouse: drag to orbit, right drag to pan, wheel to come nearer, drag a split's bar\n"
        "W A S D Q E: fly, Shift: faster. Sticks: fly and look, or move the magnifier");
  }
  ImGui::End();
}

} // namespace unghost
