// Where car and camera are: rigs, bookmarks, and paths that are recorded.
#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/action_rows.h"
#include "app/rigs.h"

namespace unghost {
namespace {

void show_next_rig(DemoState& state) {
  const std::span<const Rig> all = rigs();
  const auto now = std::ranges::find(all, state.rig, &Rig::name);
  state.rig = all[size_t(now - all.begin() + 1) % all.size()].name;
}

std::string as_the_rig(const DemoState& state) {
  return state.camera == CameraOffset{} ? "it is where the rig has it" : "";
}

std::string camera_present(const DemoState& state) {
  return state.camera == CameraOffset{} ? "the rig's" : "moved";
}

std::string as_many_as_can_be(const DemoState& state) {
  return state.bookmarks.size() < most_bookmarks ? "" : std::to_string(most_bookmarks) + " are the most";
}

std::string none_kept(const DemoState& state) { return state.bookmarks.empty() ? "none is kept" : ""; }

std::string none_gone_to(const DemoState& state) {
  return state.bookmark ? "" : state.bookmarks.empty() ? "none is kept" : "none is shown: go to one";
}

size_t next_bookmark(const DemoState& state) {
  return state.bookmark ? (*state.bookmark + 1) % state.bookmarks.size() : 0;
}

std::string bookmark_present(const DemoState& state) {
  const std::string of = " of " + std::to_string(state.bookmarks.size());
  return state.bookmark ? std::to_string(*state.bookmark + 1) + of : "none" + of;
}

std::string replaying(const DemoState& state) { return state.replayed ? "a replay goes on" : ""; }

std::string nothing_to_replay(const DemoState& state) {
  if (state.recorded) return "a recording goes on";
  return state.path_file.empty() ? "nothing was recorded" : "";
}

/// Begins or ends with the next frame.
template <auto count, auto asked> std::string path_present(const DemoState& state) {
  const std::optional<uint64_t>& frames = state.*count;
  if (state.requests.*asked) return frames ? "ends" : "begins";
  return frames ? std::to_string(*frames) + " frames" : "off";
}

} // namespace

// clang-format off
std::vector<Action> path_rows() {
  return {
    {"rig", GLFW_KEY_L, false, no_button, "Next rig: how car and camera move", show_next_rig, says_nothing, [](const DemoState& s) { return s.rig; }},
    {"camera", GLFW_KEY_HOME, false, no_button, "The rig's camera again", [](DemoState& s) { s.camera = {}; }, as_the_rig, camera_present},
    {"bookmark", GLFW_KEY_M, false, no_button, "Keep this view as a bookmark", keep_bookmark, as_many_as_can_be, bookmark_present},
    {"bookmark", GLFW_KEY_M, true, no_button, "Forget the bookmark that is shown", [](DemoState& s) { forget_bookmark(s, *s.bookmark); }, none_gone_to, bookmark_present},
    {"bookmark", GLFW_KEY_J, false, no_button, "Next bookmark: the same view again", [](DemoState& s) { go_to_bookmark(s, next_bookmark(s)); }, none_kept, bookmark_present},
    {"bookmark's camera", GLFW_KEY_J, true, no_button, "Next bookmark's camera, while the rig goes on", [](DemoState& s) { look_as_bookmark(s, next_bookmark(s)); }, none_kept, bookmark_present},
    {"recording", GLFW_KEY_O, false, no_button, "Record the path, or end the recording", request<&DemoRequests::record>, replaying, path_present<&DemoState::recorded, &DemoRequests::record>},
    {"replay", GLFW_KEY_O, true, no_button, "Replay the last recorded path, or stop it", request<&DemoRequests::replay>, nothing_to_replay, path_present<&DemoState::replayed, &DemoRequests::replay>},
  };
}
// clang-format on

} // namespace unghost
