#include "app/demo/demo.h"

#include <algorithm>
#include <thread>

#include <nlohmann/json.hpp>

#include "app/demo/demo_command.h"
#include "app/demo/demo_file.h"
#include "app/failure.h"
#include "app/files.h"
#include "app/interruption.h"
#include "app/label.h"
#include "app/png_file.h"
#include "app/shot.h"
#include "renderer/mode_names.h"
#include "renderer/spelling.h"

namespace unghost {
namespace {

constexpr PictureSize usual_size{960, 540};
constexpr double usual_width_of_text = 1280; // pixels of a window at which text has its usual size, or less
constexpr double message_seconds = 1.5, seconds_a_letter = 0.06; // a sentence takes longer to read

/// What was kept from the last run, and above it what the words say.
DemoState state_from(const CommandLine& line, Console& console) {
  auto [state, complaint] = load_demo(config_file());
  if (!complaint.empty()) console.err << complaint << "\n";
  if (!line.replay.empty()) return state; // as it is to be kept
  const float speed = state.settings.stage.speed;
  if (!line.scene) state.settings.stage = {.speed = speed}; // what shaped a model is of no use without it
  const Shot shot = shot_from(line);
  const bool named = line.mode || !line.settings.empty() || !line.assignments.empty();
  if (line.scene || !line.settings.empty()) state.scene = shot.scene;
  if (line.rig || !line.settings.empty()) state.rig = shot.rig;
  if (line.seed || !line.settings.empty()) state.seed = shot.seed;
  if (!named) return state;
  state.settings = shot.settings;
  state.arrangement = Arrangement::single;
  const std::string name = base_of_mode(shot.modes.front().name);
  if (find_taa_mode(name) == nullptr) // words were looked up
    throw Failure(Exit::input_refused, line.settings.string() + ": there is no mode '" + name + "'");
  const size_t mode = place_of_mode(state, name);
  show_mode(state, mode);
  state.modes[mode].taa = shot.modes.front().taa;
  return state;
}

PictureSize size_from(const CommandLine& line) { return line.size.value_or(usual_size); }

double text_scale_of(const Window& window) {
  return std::max(1.0, std::max(window.scale(), window.pixels().width / usual_width_of_text));
}

} // namespace

Demo::Demo(const CommandLine& line, Console& console)
    : line_(line), console_(console), state_(state_from(line, console)),
      window_(size_from(line).width, size_from(line).height),
      device_({.which = line.device, .validate = line.validate, .window = window_.surface_maker()}),
      swapchain_(device_, window_.pixels()),
      gui_(device_, swapchain_, window_.handle(), text_scale_of(window_)) {
  facts_.device = device_.facts().name;
  facts_.software = device_.facts().software;
  facts_.measured = measured_figures(find_data_folders().assets / "report" / "full.json");
  facts_.scenes = {own_scene};
  if (line.watch) watch_shader_sources();
  std::optional<Recording> named;
  if (!line.replay.empty()) named = named_recording();
  show_scene(load_demo_scene(device_, state_));
  if (named) begin_replay(std::move(*named));
}

std::vector<size_t> Demo::shown() const {
  if (state_.flicker) return {state_.compared.front()};
  return modes_seen(state_);
}

PicturePlace Demo::place() const {
  const VkExtent2D window = swapchain_.extent();
  const bool panel = state_.panel && !state_.hidden;
  const uint32_t left = panel ? panel_width(window.width, text_scale_of(window_)) : 0;
  return {.at = {left, 0},
          .screen = {.width = window.width - left,
                     .height = window.height,
                     .arrangement = state_.arrangement,
                     .split = state_.split,
                     .magnifier = state_.magnifier}};
}

void Demo::say_event(const char* event, const std::string& action) const {
  if (!line_.json) return;
  console_.out << nlohmann::json{{"event", event},  {"action", action},      {"message", state_.message},
                                 {"drawn", drawn_}, {"rests", facts_.rests}, {"state", demo_json(state_)}}
                      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
               << std::endl;
}

double Demo::seconds_since(Clock::time_point then) const {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

void Demo::describe() {
  gui_.begin_frame();
  const PicturePlace where = place();
  if (!state_.message.empty()) message_ = std::exchange(state_.message, {}), message_since_ = Clock::now();
  if (seconds_since(message_since_) > std::max(message_seconds, double(message_.size()) * seconds_a_letter))
    message_.clear();
  if (state_.panel && !state_.hidden) draw_panel(state_, facts_, uint32_t(where.at.x));
  draw_labels(state_, where, shown());
  if (!state_.hidden && drawn_ > 0)
    draw_marker(state_, where, shown().size(), {facts_.picture_width, facts_.picture_height});
  if (!state_.hidden) draw_message(message_.empty() ? lasting_message() : message_, where);
  if (!state_.hidden) draw_path_notice(state_, where);
  if (state_.keys && !state_.hidden) draw_keys(state_, where);
  gui_.end_frame();
}

/// What is seen, with its settings inside, and with the modes' names where there are several.
void Demo::take_screenshot() {
  const PicturePlace where = place();
  Image picture = renderer_->picture_again(where.screen);
  const std::vector<size_t> modes = shown();
  if (modes.size() > 1)
    for (const Label& label : labels_of(state_, where.screen, modes)) {
      const uint32_t scale = label_scale(picture.height), width = label_width(label.words, scale);
      const auto x = uint32_t(std::max(label.at.x - (label.to_the_left ? width : 0), 0.0));
      draw_label(picture, label.words, {x, uint32_t(label.at.y), width, picture.height}, scale);
    }
  Shot shot{.command = modes.size() > 1 ? "compare" : "capture",
            .scene = state_.scene,
            .rig = state_.rig,
            .seed = state_.seed,
            .size = {facts_.picture_width, facts_.picture_height},
            .settings = state_.settings};
  for (const size_t mode : modes) shot.modes.push_back(state_.modes[mode]);
  const std::filesystem::path file = free_name("unghost", ".png");
  write_file(file,
             encode_png(picture,
                        shot_json(shot, uint32_t(std::min<uint64_t>(state_.rig_frame, most_frames))).dump()));
  state_.message = file.string();
}

void Demo::answer_requests() {
  DemoRequests& asked = state_.requests;
  if (asked.screenshot && renderer_->has_shown()) { // else of the next frame
    asked.screenshot = false;
    try {
      take_screenshot();
    } catch (const Failure& failure) { // a full disk, say, is no reason to close the window
      state_.message = failure.what();
    }
    say_event("screenshot", state_.message);
  }
  if (std::exchange(asked.record, false)) record_or_end();
  if (std::exchange(asked.replay, false)) replay_or_end();
  if (std::exchange(asked.full_screen, false)) window_.toggle_full_screen();
  if (const auto scene = std::exchange(asked.scene, {})) ask_for_scene(*scene, "panel");
  if (std::exchange(asked.copy_command, false)) {
    try {
      window_.copy(command_of(state_));
      state_.message = "copied as a command line";
    } catch (const std::invalid_argument& why) {
      state_.message = std::string("not copied: ") + why.what();
    }
  }
}

bool Demo::is_over() {
  if (line_.frames && drawn_ >= *line_.frames) return true;
  return std::exchange(state_.requests.leave, false) && !keeps_window_open();
}

void Demo::turn() {
  react();
  answer_requests();
  load_asked_scene();
  look_for_changes();
  describe();
  const auto began = Clock::now();
  const bool begins = drawn_ == 0;
  draw();
  if (begins && drawn_ > 0) say_event("ready", {}); // once, however long that frame stays the last one
  // no display throttles everywhere
  std::this_thread::sleep_until(
      began + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds_per_frame)));
  facts_.frame_ms.push_back(float(1000 * seconds_since(frame_began_)));
  if (facts_.frame_ms.size() > charted_frames) facts_.frame_ms.pop_front();
  frame_began_ = Clock::now();
}

void Demo::run() {
  try {
    while (!interrupted() && !is_over()) turn();
  } catch (...) { // a device that is lost, say: the path that led there is written
    if (const std::string loss = loss_of_recording(); !loss.empty())
      console_.err << "unghost: " << loss << "\n";
    throw;
  }
  std::vector<std::string> lost;
  if (const std::string loss = loss_of_recording(); !loss.empty()) lost.push_back(loss);
  device_.wait_idle();
  if (const auto fault = fault_of([&] { save_demo(kept_state(), config_file()); })) lost.push_back(*fault);
  if (interrupted() && !lost.empty()) console_.err << "unghost: " << joined(lost, "; ") << "\n";
  throw_if_interrupted();
  if (line_.timings) console_.err << times_.text();
  report_validation(console_.err, device_.validation_messages());
  if (!lost.empty()) throw Failure(Exit::failed, joined(lost, "; "));
}

void demo(const CommandLine& line, Console& console) { Demo(line, console).run(); }

} // namespace unghost
