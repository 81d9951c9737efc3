#include "app/demo/panel.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <imgui.h>

#include "app/demo/demo_scene.h"
#include "app/demo/pixel_panel.h"
#include "app/demo/render_scale.h"
#include "app/demo/setting_widgets.h"
#include "app/rigs.h"
#include "app/table.h"

namespace unghost {
namespace {

const char* text(std::string_view view) { return view.data(); } // rows of tables end in a zero

/// A list of rows to choose from; the tooltip is each one's summary. Returns the row chosen just now.
template <class Rows> const auto* choose(const char* label, const Rows& rows, std::string_view current) {
  const auto* chosen = rows.data();
  chosen = nullptr;
  ImGui::SetNextItemWidth(-ImGui::CalcTextSize("rig    ").x);
  if (!ImGui::BeginCombo(label, text(current), ImGuiComboFlags_HeightLarge)) return chosen;
  for (const auto& row : rows) {
    if (ImGui::Selectable(text(row.name), row.name == current)) chosen = &row;
    if (ImGui::IsItemHovered()) tooltip(std::string(row.summary));
  }
  ImGui::EndCombo();
  return chosen;
}

/// Of the table's rows; nothing where none was chosen just now.
std::optional<size_t> chosen_mode(const char* label, const DemoState& state, size_t mode) {
  const TaaMode* row = choose(label, taa_modes(), state.modes[mode].name);
  return row != nullptr ? std::optional(size_t(row - taa_modes().data())) : std::nullopt;
}

void draw_mode(DemoState& state, const DemoFacts& facts) {
  if (const auto chosen = chosen_mode("mode", state, state.mode)) show_mode(state, *chosen);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", text(taa_modes()[state.mode].summary));
  if (const std::string figures = figures_text(facts.measured, state.rig, state.modes[state.mode].name);
      !figures.empty())
    ImGui::TextWrapped("Measured on %s: %s.", state.rig.c_str(), figures.c_str());
  ImGui::PopStyleColor();
  if (state.arrangement == Arrangement::single) {
    if (ImGui::Button("compare (B)")) state.arrangement = Arrangement::split;
    return;
  }
  ImGui::SetNextItemWidth(-ImGui::CalcTextSize("rig    ").x);
  if (ImGui::BeginCombo("as", text(spelling(state.arrangement)))) {
    for (const Answer& answer : answers<Arrangement>())
      if (ImGui::Selectable(answer.name.c_str(), uint32_t(state.arrangement) == answer.value))
        state.arrangement = Arrangement(answer.value);
    ImGui::EndCombo();
  }
  for (size_t i = 0; i < state.compared.size(); ++i) {
    ImGui::PushID(int(i));
    if (const auto chosen = chosen_mode("with", state, state.compared[i])) compare_with(state, i, *chosen);
    ImGui::PopID();
  }
  if (state.arrangement != Arrangement::grid) return;
  const bool more = state.compared.size()<most_compared, less = state.compared.size()> 1;
  if (more && ImGui::SmallButton("one more (=)")) compare_one_more(state);
  if (more && less) ImGui::SameLine();
  if (less && ImGui::SmallButton("one less (-)")) compare_one_less(state);
}

void draw_scenes(DemoState& state, const std::vector<std::string>& scenes) {
  ImGui::SetNextItemWidth(-ImGui::CalcTextSize("scene  ").x);
  if (!ImGui::BeginCombo("scene", short_name(state.scene).c_str())) return;
  for (const std::string& scene : scenes) {
    if (ImGui::Selectable(short_name(scene).c_str(), scene == state.scene)) state.requests.scene = scene;
    if (ImGui::IsItemHovered()) tooltip(scene);
  }
  ImGui::TextDisabled("a .glb dropped on the window");
  ImGui::EndCombo();
}

void draw_bookmarks(DemoState& state) {
  if (state.bookmarks.size() < most_bookmarks && ImGui::SmallButton("keep this view (M)"))
    keep_bookmark(state);
  std::optional<size_t> forgotten;
  for (size_t place = 0; place < state.bookmarks.size(); ++place) {
    const Bookmark& mark = state.bookmarks[place];
    ImGui::PushID(int(place));
    if (ImGui::RadioButton("##shown", state.bookmark == place)) go_to_bookmark(state, place);
    ImGui::SameLine();
    ImGui::Text("%s, frame %s", mark.rig.c_str(), std::to_string(mark.rig_frame).c_str());
    if (ImGui::SmallButton("go")) go_to_bookmark(state, place);
    if (ImGui::IsItemHovered()) tooltip("The same view again");
    ImGui::SameLine();
    if (ImGui::SmallButton("camera")) look_as_bookmark(state, place);
    if (ImGui::IsItemHovered()) tooltip("Its camera, while the rig goes on");
    ImGui::SameLine();
    if (ImGui::SmallButton("forget")) forgotten = place;
    ImGui::PopID();
  }
  if (forgotten) forget_bookmark(state, *forgotten);
}

void draw_world(DemoState& state, const DemoFacts& facts) {
  draw_scenes(state, facts.scenes);
  if (const Rig* rig = choose("rig", rigs(), state.rig)) state.rig = rig->name;
  Settings shared = settings_of(state, state.mode);
  if (edit_settings(shared, Settings{}, SettingsPart::shared, state.message)) state.settings = shared;
  if (state.camera != CameraOffset{} && ImGui::SmallButton("the rig's camera")) state.camera = {};
  draw_bookmarks(state);
}

void draw_row(DemoState& state) {
  ModeRun& run = state.modes[state.mode];
  Settings settings = settings_of(state, state.mode);
  if (edit_settings(settings, settings_for_mode(run.name), SettingsPart::per_mode, state.message))
    run.taa = settings.taa;
  if (is_changed(state) && ImGui::SmallButton("as its row has it (Delete)")) reset_mode(state);
}

std::string mib(uint64_t bytes) { return fixed(double(bytes) / (1 << 20), 1); }

void draw_chart(const char* label, const std::deque<float>& ms) {
  if (ms.empty()) return;
  const std::vector<float> values(ms.begin(), ms.end());
  const float most = *std::ranges::max_element(values);
  std::vector<float> sorted = values;
  std::ranges::nth_element(sorted, sorted.begin() + ptrdiff_t(sorted.size() / 2));
  const std::string over = std::string(label) + " " + fixed(double(sorted[sorted.size() / 2]), 1) + " ms";
  ImGui::PlotLines("##chart", values.data(), int(values.size()), 0, over.c_str(), 0, most * 1.3f,
                   {ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight() * 3});
}

/// How many pixels are drawn: so many a pixel shown, or as many as a frame time allows.
void draw_scale(DemoState& state) {
  constexpr float usual_ms = 1000.0f / 60, least_ms = 4, most_ms = 200;
  bool holds = state.frame_ms.has_value();
  if (ImGui::Checkbox("hold a frame time", &holds))
    state.frame_ms = holds ? std::optional<double>(usual_ms) : std::nullopt;
  auto value = float(state.frame_ms.value_or(state.render_scale));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
  if (state.frame_ms) {
    if (ImGui::SliderFloat("ms a frame", &value, least_ms, most_ms, "%.1f", ImGuiSliderFlags_AlwaysClamp))
      state.frame_ms = value;
    ImGui::TextDisabled("render scale %.2f", state.render_scale);
  } else if (ImGui::SliderFloat("render scale", &value, float(least_scale), 1, "%.2f",
                                ImGuiSliderFlags_AlwaysClamp)) {
    state.render_scale = std::round(value / scale_step) * scale_step;
  }
}

std::string images_text(const PassReport& pass) {
  std::string text = pass.name;
  for (const PassImage& image : pass.images)
    text += std::string("\n") + (image.reads ? (image.writes ? "adds to " : "reads ") : "writes ") +
            image.name + ", " + mib(image.bytes) + " MiB";
  return text;
}

void draw_times(DemoState& state, const DemoFacts& facts) {
  draw_chart("device", facts.gpu_ms);
  if (facts.rests) ImGui::TextDisabled("nothing moves: the last picture stays");
  draw_scale(state);
  if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("pass");
  ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("MiB", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableHeadersRow();
  for (const PassReport& pass : facts.frame.passes) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn(), ImGui::TextUnformatted(pass.name.c_str());
    if (ImGui::IsItemHovered()) tooltip(images_text(pass));
    ImGui::TableNextColumn(), ImGui::TextUnformatted(fixed(pass.ms, 2).c_str());
    ImGui::TableNextColumn(), ImGui::TextUnformatted(mib(pass.image_bytes).c_str());
  }
  ImGui::EndTable();
  ImGui::TextDisabled("%ux%u, %s MiB of images", facts.picture_width, facts.picture_height,
                      mib(facts.frame.image_bytes).c_str());
  ImGui::TextDisabled("%s", facts.device.c_str());
  if (facts.software) ImGui::TextDisabled("a software device: no GPU's times");
}

void draw_left_out(const DemoFacts& facts) {
  for (const LeftOut& thing : facts.frame.left_out) {
    ImGui::Bullet();
    ImGui::TextWrapped("%s: %s", thing.what.c_str(), thing.why.c_str());
  }
}

} // namespace

uint32_t panel_width(uint32_t width, double text_scale) {
  return std::min(uint32_t(300 * text_scale), width / 2);
}

void draw_panel(DemoState& state, const DemoFacts& facts, uint32_t width) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({float(width), ImGui::GetIO().DisplaySize.y});
  constexpr auto fixed_place =
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove;
  if (ImGui::Begin("unghost", nullptr, fixed_place)) {
    ImGui::TextUnformatted(text(first_keys));
    draw_mode(state, facts);
    if (ImGui::CollapsingHeader("this pixel", ImGuiTreeNodeFlags_DefaultOpen)) draw_pixel(facts.pixel);
    if (ImGui::CollapsingHeader("how this mode resolves", ImGuiTreeNodeFlags_DefaultOpen)) draw_row(state);
    if (ImGui::CollapsingHeader("scene, light and view", ImGuiTreeNodeFlags_DefaultOpen))
      draw_world(state, facts);
    if (ImGui::CollapsingHeader("times", ImGuiTreeNodeFlags_DefaultOpen)) draw_times(state, facts);
    if (ImGui::CollapsingHeader("left out of this frame")) draw_left_out(facts);
    if (ImGui::SmallButton("copy as command line")) state.requests.copy_command = true;
    ImGui::SameLine();
    if (ImGui::SmallButton("reset all")) reset_all(state);
  }
  ImGui::End();
}

} // namespace unghost
