// The panel under a mouse that goes everywhere: no window, as its widgets are told what a mouse does.
#include "app/demo/panel.h"

#include <functional>
#include <set>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui_internal.h> // where lists open
#include <nlohmann/json.hpp>

#include "app/demo/demo_file.h"
#include "app/rigs.h"
#include "tests/app/pressed.h"

namespace unghost {
namespace {

constexpr int width = 300, tall = 3000;   // all of it at once
constexpr float deepest = 1700, step = 7; // pixels: where the last widget is, and less than the lowest one

class DemoPanel : public testing::Test {
protected:
  DemoPanel() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {width, tall};
    unsigned char* pixels = nullptr;
    int pixels_wide = 0, pixels_high = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &pixels_wide, &pixels_high);
    facts.scenes = {state.scene, "/somewhere/other.glb"};
    frame();
  }
  ~DemoPanel() override { ImGui::DestroyContext(); }

  void frame() {
    ImGui::GetIO().DeltaTime = 1;
    ImGui::NewFrame();
    draw_panel(state, facts, width);
    ImGui::Render();
  }
  void move_to(glm::vec2 at) {
    ImGui::GetIO().MousePos = {at.x, at.y};
    frame();
  }
  void hold(int button, bool down) {
    ImGui::GetIO().MouseDown[button] = down;
    frame();
  }
  void click(int button) { hold(button, true), hold(button, false); }

  static const ImGuiWindow* open_list() {
    const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
    return open.empty() ? nullptr : open.back().Window;
  }
  void click_at(glm::vec2 at) {
    move_to(at);
    click(ImGuiMouseButton_Left);
    if (open_list() != nullptr) frame(), frame(); // in which it finds its place
  }
  /// Down the panel, and down whatever list a click opens; each time from there on.
  void click_on_everything(const DemoState& start, const std::function<void()>& look) {
    const auto click_from_start = [&](glm::vec2 at) {
      state = start;
      click_at(at), look();
    };
    for (glm::vec2 at{width / 4, 0}; at.y < deepest; at.y += step) {
      click_from_start(at);
      if (open_list() == nullptr && state == start) click_at(at); // unfolds what it folded
      for (float below = step / 2; open_list() != nullptr && below < open_list()->Size.y; below += step) {
        click_at({open_list()->Pos.x + 20, open_list()->Pos.y + below}), look();
        if (open_list() == nullptr) click_from_start(at);
      }
      if (open_list() != nullptr) click_at({width - 2, tall - 2});
    }
  }

  void expect_sound() const {
    ASSERT_LT(state.mode, state.modes.size());
    for (size_t mode = 0; mode < state.modes.size(); ++mode)
      ASSERT_FALSE(refusal(settings_of(state, mode))) << state.modes[mode].name;
    const std::vector<size_t> seen = modes_seen(state);
    ASSERT_EQ(std::set<size_t>(seen.begin(), seen.end()).size(), seen.size());
    ASSERT_TRUE(state.render_scale >= 0.5 && state.render_scale <= 1) << state.render_scale;
    ASSERT_NE(find_rig(state.rig), nullptr);
  }

  DemoState state = default_demo_state();
  DemoFacts facts;
};

/// What has been something else than at first.
std::set<std::string> changes(const DemoState& state, const DemoState& first) {
  std::set<std::string> changed;
  const auto note = [&](bool differs, const std::string& what) {
    if (differs) changed.insert(what);
  };
  for (size_t mode = 0; mode < state.modes.size(); ++mode)
    for (const Setting& row : settings_table())
      note(row.get(settings_of(state, mode)) != row.get(settings_of(first, mode)), std::string(row.name));
  note(true, "rig " + state.rig);
  note(true, "mode " + state.modes[state.mode].name);
  note(true, "arrangement " + std::string(spelling(state.arrangement)));
  note(state.render_scale != first.render_scale, "render scale");
  note(state.frame_ms.has_value(), "frame time");
  note(state.requests.copy_command, "copy");
  note(state.requests.scene == "/somewhere/other.glb", "scene");
  note(state.compared.size() == 2, "two compared");
  note(state.compared.size() == 3, "three compared");
  return changed;
}

std::set<std::string> all_changes() {
  std::set<std::string> all = {"render scale", "frame time",   "copy",
                               "scene",        "two compared", "three compared"};
  for (const Setting& row : settings_table()) all.insert(std::string(row.name));
  for (const Rig& rig : rigs()) all.insert("rig " + std::string(rig.name));
  for (const TaaMode& row : taa_modes()) all.insert("mode " + std::string(row.name));
  for (const Answer& answer : answers<Arrangement>()) all.insert("arrangement " + answer.name);
  return all;
}

TEST_F(DemoPanel, AMouseReachesEverythingAndBreaksNothing) {
  const DemoState first = state;
  const std::set<std::string> all = all_changes();
  std::set<std::string> changed;
  const auto look = [&] {
    expect_sound();
    const std::set<std::string> now = changes(state, first);
    changed.insert(now.begin(), now.end());
  };
  const std::vector<std::string> compared[] = {
      {"grand-tour"}, {"ac4"}, {"dop32-var"}, {"rgb-var"}, {"off", "rgb"}, {"holy-trail", "blend", "dop32"}};
  for (const std::vector<std::string>& modes : compared) {
    DemoState start = showing(modes.front());
    if (modes.front() == "dop32-var") shown(start).taa.policy.reject = Reject::depth; // as no row has it
    if (modes.front() == "rgb-var")
      shown(start).taa.policy.blend = Blend::speed, shown(start).taa.policy.input = Input::centred;
    if (modes.size() > 1) {
      start.compared.clear();
      for (size_t i = 1; i < modes.size(); ++i) start.compared.push_back(place_of_mode(start, modes[i]));
      start.arrangement = Arrangement::grid;
    }
    click_on_everything(start, look);
  }
  std::string missing;
  for (const std::string& what : all)
    if (!changed.contains(what)) missing += what + ", ";
  EXPECT_EQ(missing, "");
}

TEST_F(DemoPanel, ARightClickResetsWhateverWasChanged) {
  const DemoState first = state;
  for (const Setting& row : settings_table()) {
    Settings settings = settings_of(state, state.mode);
    const double other =
        row.kind == SettingKind::number
            ? (row.read(settings) == double(row.high) ? double(row.low) : double(row.high))
            : double(row.answers[row.answers.front().value == uint32_t(row.read(settings))].value);
    row.write(settings, other);
    if (refusal(settings)) continue;
    state.modes[state.mode].taa = settings.taa;
    settings.taa = state.settings.taa;
    state.settings = settings;
  }
  EXPECT_GT(changes(state, first).size(), settings_table().size() / 2);
  for (const int round : {1, 2}) // as near must be less than far, the first may have to go second
    for (float y = 0; y < deepest; y += step) {
      move_to({width / 4, y + float(round)});
      click(ImGuiMouseButton_Right);
    }
  EXPECT_EQ(changes(state, first), changes(first, first)) << state.message;
  EXPECT_EQ(demo_json(state), demo_json(first));
}

TEST_F(DemoPanel, AGridOfFourLosesOne) {
  state.compared = {place_of_mode(state, "off"), place_of_mode(state, "blend"), place_of_mode(state, "rgb")};
  state.arrangement = Arrangement::grid;
  bool lost = false;
  click_on_everything(DemoState(state), [&] { lost |= state.compared.size() == 2; });
  EXPECT_TRUE(lost);
}

TEST_F(DemoPanel, TheChartIsAsWideAsThePanel) {
  facts.gpu_ms.assign(charted_frames, 5);
  frame(), frame();
  float left = width, right = 0;
  for (const ImDrawVert& corner : ImGui::FindWindowByName("unghost")->DrawList->VtxBuffer)
    if (corner.col == ImGui::GetColorU32(ImGuiCol_PlotLines))
      left = std::min(left, corner.pos.x), right = std::max(right, corner.pos.x);
  EXPECT_GT(right - left, width * 0.8f);
}

TEST_F(DemoPanel, ItsFirstKeysFitAndDoWhatTheySay) {
  const ImGuiStyle& style = ImGui::GetStyle();
  EXPECT_LE(ImGui::CalcTextSize(first_keys.data()).x,
            width - 2 * style.WindowPadding.x - style.ScrollbarSize);
  const DemoState first = state;
  press(state, GLFW_KEY_B);
  EXPECT_EQ(modes_seen(state), (std::vector<size_t>{first.mode, place_of_mode(state, "blend")}));
  press(state, GLFW_KEY_1);
  EXPECT_EQ(shown(state).name, "blend");
  press(state, GLFW_KEY_0);
  EXPECT_EQ(state.mode, first.mode);
  press(state, GLFW_KEY_V), press(state, GLFW_KEY_H), press(state, GLFW_KEY_U);
  EXPECT_TRUE(state.magnifier.shown && state.keys && state.hidden);
}

TEST_F(DemoPanel, NothingChangesWhereTheMouseOnlyPasses) {
  const DemoState first = state;
  for (float y = 0; y < tall; y += 3) move_to({y * 7 - width * int(y * 7 / width), y});
  EXPECT_TRUE(state == first) << state.message;
}

} // namespace
} // namespace unghost
