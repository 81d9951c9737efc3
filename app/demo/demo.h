// The demo: a window in which the car drives, and a person switches every resolve.
#pragma once

#include <chrono>
#include <memory>

#include "app/commands.h"
#include "app/demo/demo_scene.h"
#include "app/demo/gui.h"
#include "app/demo/overlay.h"
#include "app/demo/panel.h"
#include "app/demo/recording_file.h"
#include "app/demo/shader_build.h"
#include "app/demo/window.h"
#include "app/pass_times.h"
#include "renderer/stillness.h"

namespace unghost {

class Demo {
public:
  Demo(const CommandLine& line, Console& console);
  /// Until the person leaves, or as many frames are drawn as the words say.
  void run();

private:
  using Clock = std::chrono::steady_clock;

  /// A scene that is to be loaded after the next frame; `event`: because of what.
  struct AskedScene {
    std::string scene;
    const char* event;
    bool announced = false;
  };

  /// A recording that is made, or was and could not be written.
  struct Unwritten {
    Recorder recorder;
    std::string end{};   // why no frame can follow; empty while they do
    std::string fault{}; // why it was not written
    bool warned = false; // that it would be lost
  };

  /// A recording that is drawn again.
  struct Replay {
    Recording recording;
    size_t next = 0;
  };

  void show_scene(DemoScene loaded);
  void ask_for_scene(const std::string& scene, const char* event);
  void load_asked_scene();
  void look_for_stage();
  void look_for_changes(); // of files
  void watch_shader_sources();
  void compile_shaders();
  bool compiling() const;
  std::string lasting_message() const; // of what is not over yet
  void react();                        // to keys, buttons and mouse
  void steer(const WindowEvents& events, const WindowHeld& held);
  void drag(const WindowEvents& events, const WindowHeld& held, CameraInput& input);
  void move_magnifier(const WindowHeld& held, double seconds);
  void pick(const WindowEvents::Click& click);
  void probe_what_rests();
  std::optional<ProbeInput> probe(size_t modes) const; // of a picture as it was drawn last
  void describe();                                     // the panel and what is above the picture
  void answer_requests();
  void take_screenshot();
  bool fit_window(); // false where nothing can be shown
  void draw();
  void look_for_rest(); // from the next frame on
  void show_what_rests();
  Moment next_moment();
  FrameInput next_frame(const Moment& moment);
  void go_on_after(const Moment& moment, const Instant& now);
  void note(const FrameResult& result);
  void hold_frame_time();
  void say_event(const char* event, const std::string& action) const;
  void record_or_end();
  void record(const Moment& moment);          // a frame that was drawn
  void end_recording(const std::string& why); // of itself; empty where a person ends it
  void write_recording();
  std::string loss_of_recording(); // with the window
  bool keeps_window_open();        // for a recording that would be lost
  void replay_or_end();
  Recording named_recording(); // by the words; the state becomes what it begins with
  void begin_replay(Recording recording);
  void end_replay(const std::string& why);
  Moment replayed_moment(); // the next one, which the state follows
  void follow_replay();     // by the frame that was drawn
  void leave_path(const std::string& why);
  DemoState kept_state() const; // what is there on the next start
  bool is_over();
  void turn(); // of the loop
  PicturePlace place() const;
  std::vector<size_t> shown() const; // of the state's modes, as the frame has them
  double seconds_since(Clock::time_point then) const;

  const CommandLine& line_;
  Console& console_;
  DemoState state_;
  Window window_;
  Device device_;
  Swapchain swapchain_;
  Gui gui_;
  RigContext context_;
  StageSettings built_stage_; // that the scene was loaded with
  std::unique_ptr<Renderer> renderer_;
  std::optional<Stillness> stillness_; // of the renderer's scene
  std::optional<AskedScene> asked_scene_;
  FileWatch scene_files_, shader_files_;
  std::optional<ShaderBuild> shader_build_; // with --watch, and where they were built
  DemoFacts facts_;
  std::optional<ProbeInput> probed_; // of the frame that rests
  PassTimes times_;
  std::optional<Instant> last_; // what was drawn before
  std::string last_rig_;
  uint64_t drawn_ = 0;
  std::optional<Unwritten> unwritten_;
  std::optional<Replay> replay_;
  std::optional<DemoState> own_; // the person's, where the words name a recording
  Clock::time_point frame_began_ = Clock::now(), message_since_;
  std::string message_; // that is shown
  glm::dvec2 mouse_{0};
  bool was_held_ = false;  // the left button, at the last look: what moved before it was pressed is no drag
  bool drags_bar_ = false; // of a split, while the mouse is held
};

} // namespace unghost
