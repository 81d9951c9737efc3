// What changes under the demo while it runs: dropped scenes, and with --watch the files of scene and shaders.
#include <algorithm>

#include "app/demo/demo.h"

namespace unghost {

void Demo::show_scene(DemoScene loaded) {
  context_ = loaded.context;
  built_stage_ = loaded.context.stage;
  renderer_ = std::move(loaded.renderer); // the one before waits for the device
  scene_files_ = std::move(loaded.files), shader_files_ = std::move(loaded.shaders);
  look_for_rest();
  last_.reset();
  if (std::ranges::find(facts_.scenes, state_.scene) == facts_.scenes.end())
    facts_.scenes.push_back(state_.scene);
  window_.title("unghost: " + short_name(state_.scene));
  for (const std::string& warning : renderer_->scene().warnings)
    if (!console_.quiet) console_.err << state_.scene << ": " << warning << "\n";
}

/// Loading takes a while in which nothing moves: a frame is shown before it that says so.
void Demo::ask_for_scene(const std::string& scene, const char* event) {
  asked_scene_ = AskedScene{.scene = scene, .event = event};
  state_.message = "loading " + short_name(scene);
  window_.title("unghost: " + state_.message);
}

void Demo::load_asked_scene() {
  if (!asked_scene_ || !std::exchange(asked_scene_->announced, true)) return;
  if (compiling()) return; // half of what that writes is no set of shaders
  const AskedScene asked = *std::exchange(asked_scene_, std::nullopt);
  DemoState wanted = state_;
  wanted.scene = asked.scene;
  DemoScene loaded;
  const auto fault = fault_of([&] { loaded = load_demo_scene(device_, wanted); });
  if (fault) {
    window_.title("unghost: " + short_name(state_.scene));
    state_.message = *fault;
  } else {
    state_.scene = asked.scene;
    show_scene(std::move(loaded));
    const std::vector<std::string>& warnings = renderer_->scene().warnings;
    state_.message = short_name(state_.scene) + (warnings.empty() ? "" : ": " + warnings.front());
    leave_path("another scene");
  }
  say_event(asked.event, "scene");
}

/// What stands around the model, and how large it is, is part of the scene; its speed is not.
void Demo::look_for_stage() {
  const StageSettings& wanted = state_.settings.stage;
  if (same_stage(wanted, built_stage_) || asked_scene_ || window_.held().left)
    return; // a slider is let go first
  built_stage_ = wanted;
  ask_for_scene(state_.scene, "stage");
}

void Demo::watch_shader_sources() {
  if (const auto tree = ShaderBuild::tree_of(find_data_folders().shaders))
    shader_build_.emplace(*tree);
  else if (!console_.quiet)
    console_.err << "--watch: the program is not where it was built, and watches compiled shaders only\n";
}

bool Demo::compiling() const { return shader_build_ && shader_build_->running(); }

void Demo::compile_shaders() {
  const auto result = shader_build_ ? shader_build_->look(Clock::now()) : std::nullopt;
  if (!result) return;
  state_.message = result->fault.empty() ? "the shaders compile again" : result->fault;
  if (!result->fault.empty() && !console_.quiet) console_.err << result->talk << std::flush;
  say_event("watch", "shader sources");
}

std::string Demo::lasting_message() const {
  if (compiling()) return "compiling shaders";
  if (shader_build_ && !shader_build_->fault().empty()) return shader_build_->fault();
  const bool waits = unwritten_ && !unwritten_->end.empty();
  return waits ? unwritten_->fault + "; O tries again" : "";
}

void Demo::look_for_changes() {
  look_for_stage();
  compile_shaders();
  if (!line_.watch || asked_scene_) return;
  if (scene_files_.changed(Clock::now())) ask_for_scene(state_.scene, "watch");
  if (compiling() || !shader_files_.changed(Clock::now())) return;
  const auto fault = fault_of([&] {
    renderer_->reload_shaders();
    last_.reset();
  });
  state_.message = fault.value_or("other shaders");
  if (!fault) leave_path("other shaders");
  say_event("watch", "shaders");
}

} // namespace unghost
