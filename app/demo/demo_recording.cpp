// The demo's paths: recorded as they are drawn, and drawn again.
#include "app/demo/demo.h"

#include "app/failure.h"
#include "app/files.h"
#include "app/replayed_shot.h"

namespace unghost {
namespace {

std::string frames_text(uint64_t frames) {
  return std::to_string(frames) + (frames == 1 ? " frame" : " frames");
}

void add_to(std::string& message, const std::string& sentence) {
  message += (message.empty() ? "" : "; ") + sentence;
}

std::string in_brackets(const std::string& why) { return why.empty() ? "" : " (" + why + ")"; }

/// What decides the first frame, but for its moment.
void take_start(DemoState& state, const Recording& recording) {
  state.scene = recording.scene;
  state.seed = recording.seed;
  take_look(state, recording.looks[recording.frames.front().look]);
}

} // namespace

void Demo::record_or_end() {
  state_.message.clear();
  if (unwritten_) return end_recording("");
  state_.message = "recording";
  unwritten_ = Unwritten{.recorder = Recorder(state_.scene, state_.seed)};
  state_.recorded = 0;
  state_.requests.drop_history = true; // what was before is not part of it
}

void Demo::record(const Moment& moment) {
  if (!unwritten_ || !unwritten_->end.empty()) return;
  Recorder& recorder = unwritten_->recorder;
  const Look look = look_of(state_, shown());
  if (const std::string why = recorder.why_not(look); !why.empty()) return end_recording(why);
  recorder.add(moment, look);
  state_.recorded = recorder.frames();
}

void Demo::write_recording() {
  const size_t frames = unwritten_->recorder.frames();
  std::string said = "nothing was recorded";
  if (frames > 0) {
    const std::filesystem::path file = free_name("unghost-path", ".json");
    write_file(file, bytes_of(unwritten_->recorder.text()));
    state_.path_file = file.string();
    said = file.string() + ": " + frames_text(frames);
  }
  add_to(state_.message, said + in_brackets(unwritten_->end));
  unwritten_.reset();
}

/// What cannot be written now can be asked for again. One that a person ends goes on meanwhile.
void Demo::end_recording(const std::string& why) {
  if (!unwritten_) return;
  if (unwritten_->end.empty()) unwritten_->end = why;
  try {
    write_recording();
  } catch (const Failure& failure) {
    unwritten_->fault = failure.what() + in_brackets(unwritten_->end);
    add_to(state_.message, unwritten_->fault);
  }
  if (!unwritten_ || !unwritten_->end.empty()) state_.recorded.reset();
  say_event("path", "recorded");
}

/// Why it is lost; empty where nothing is. Nobody reads a message any more.
std::string Demo::loss_of_recording() {
  end_recording("");
  return unwritten_ ? unwritten_->fault : "";
}

/// Once, so that there can be made room for it.
bool Demo::keeps_window_open() {
  if (!unwritten_ || unwritten_->warned) return false;
  state_.message.clear();
  end_recording("");
  if (!unwritten_) return false;
  add_to(state_.message, "to leave once more is to lose it");
  return unwritten_->warned = true;
}

Recording Demo::named_recording() {
  Shot shot = replayed_shot(line_);
  state_.path_file = line_.replay.string();
  own_ = state_;
  take_start(state_, shot.replay->recording);
  return std::move(shot.replay->recording);
}

void Demo::replay_or_end() {
  state_.message.clear();
  if (replay_) return end_replay("");
  const auto fault = fault_of([&] {
    Recording recording = load_recording(state_.path_file);
    DemoState wanted = state_;
    take_start(wanted, recording);
    const bool same_scene = wanted.scene == state_.scene && same_stage(wanted.settings.stage, built_stage_);
    std::optional<DemoScene> loaded;
    if (!same_scene) loaded = load_demo_scene(device_, wanted);
    state_ = std::move(wanted);
    if (loaded) show_scene(std::move(*loaded));
    begin_replay(std::move(recording));
  });
  if (!fault) return;
  state_.message = *fault;
  say_event("path", "refused");
}

void Demo::begin_replay(Recording recording) {
  replay_ = Replay{.recording = std::move(recording)};
  state_.replayed = 0;
  state_.paused = false;
}

Moment Demo::replayed_moment() {
  const Recording& recording = replay_->recording;
  const size_t next = replay_->next;
  const Recording::Frame& frame = recording.frames[next];
  if (next == 0 || recording.frames[next - 1].look != frame.look)
    take_look(state_, recording.looks[frame.look]); // else as a person may have changed it meanwhile
  state_.rig = frame.moment.rig;
  state_.rig_frame = frame.moment.rig_frame;
  state_.camera = frame.moment.camera;
  Moment moment = frame.moment;
  moment.cut |= !last_ || state_.requests.drop_history;
  return moment;
}

void Demo::follow_replay() {
  if (!replay_) return;
  state_.replayed = ++replay_->next;
  if (replay_->next < replay_->recording.frames.size()) return;
  end_replay("P goes on");
  state_.paused = true; // so that the last frame can be looked at
}

void Demo::end_replay(const std::string& why) {
  if (!replay_) return;
  add_to(state_.message, "replayed " + frames_text(replay_->next) + " of " + state_.path_file +
                             (why.empty() ? "" : "; " + why));
  replay_.reset();
  state_.replayed.reset();
  say_event("path", "replayed");
}

void Demo::leave_path(const std::string& why) {
  end_recording(why);
  end_replay(why);
}

/// What a named recording has set is not the person's.
DemoState Demo::kept_state() const {
  DemoState kept = own_.value_or(state_);
  kept.bookmarks = state_.bookmarks;
  return kept;
}

} // namespace unghost
