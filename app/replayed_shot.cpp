#include "app/replayed_shot.h"

#include <algorithm>
#include <utility>

#include "app/assignments.h"
#include "app/commands.h"
#include "app/demo/recording_file.h"
#include "renderer/mode_names.h"

namespace unghost {
namespace {

/// A window may have any size; the pictures in it have theirs.
bool is_window(const CommandLine& line) { return (line.command->options & picture) == 0; }

void check_words(const CommandLine& line) {
  const std::pair<bool, const char*> recorded[] = {{line.scene.has_value(), "a scene"},
                                                   {line.rig.has_value(), "--rig"},
                                                   {line.seed.has_value(), "--seed"},
                                                   {line.size.has_value() && !is_window(line), "--size"},
                                                   {!line.settings.empty(), "--settings"}};
  for (const auto& [given, word] : recorded)
    if (given)
      throw WrongWords(std::string(word) + " does not go with --replay: " + line.replay.string() +
                       " says it");
  for (const std::string& name : named_modes(line))
    if (base_of_mode(name) != name)
      throw WrongWords(name + " does not go with --replay: " + line.replay.string() +
                       " says what each mode is set to, and --set what all of them are");
}

/// Returns those that have no effect on what is shown.
std::vector<Assignment> apply_to(Look& look, std::span<const Assignment> assignments) {
  std::vector<ModeRun> modes = shown_modes(look);
  std::vector<Assignment> unused = apply_assignments(assignments, look.settings, modes);
  if (const auto why = refusal(look.settings, modes)) throw SettingError(*why);
  for (size_t i = 0; i < modes.size(); ++i) look.modes[look.shown[i]] = std::move(modes[i]);
  return unused;
}

// A recording shows now this, now that: one that has an effect in some of its frames is none too many.
void set_in_all_frames(const CommandLine& line, Recording& recording) {
  std::vector<Assignment> assignments;
  for (const std::string& text : line.assignments) assignments.push_back({.text = text});
  std::vector<Assignment> unused = assignments;
  for (Look& look : recording.looks) {
    const std::vector<Assignment> here = apply_to(look, assignments);
    std::erase_if(unused, [&](const Assignment& each) {
      return std::ranges::count(here, each.text, &Assignment::text) == 0;
    });
  }
  if (!unused.empty()) throw SettingError(without_effect(unused.front(), {}));
}

uint32_t frames_of(const CommandLine& line, const Recording& recording) {
  const auto recorded = uint32_t(recording.frames.size());
  const uint32_t frames = is_window(line) ? recorded : line.frames.value_or(recorded);
  if (frames > recorded)
    throw WrongWords("--frames " + std::to_string(frames) + " is beyond the last of " +
                     std::to_string(recorded) + " recorded frames");
  return frames;
}

// A picture of one mode is no comparison, and which of several a capture means is not guessed.
void check_choice(const CommandLine& line, const Shot& shot) {
  if (is_window(line)) return;
  std::string shown;
  for (const ModeRun& run : shot.modes) shown += (shown.empty() ? "" : ", ") + run.name;
  const std::string what = line.replay.string() + " shows " + shown + " in frame " +
                           std::to_string(shot.frames - 1) + " of its frames: ";
  if ((line.command->options & one_mode) && shot.modes.size() > 1)
    throw SettingError(what + "--mode says which to draw");
  if ((line.command->options & many_modes) && shot.modes.size() == 1 && line.modes.empty())
    throw SettingError(what + "--modes says which to set beside one another");
}

} // namespace

Shot replayed_shot(const CommandLine& line) {
  check_words(line);
  Recording recording = load_recording(line.replay);
  if (const std::vector<std::string> names = named_modes(line); !names.empty()) show_only(recording, names);
  set_in_all_frames(line, recording);
  Shot shot{.command = std::string(line.command->name),
            .scene = recording.scene,
            .seed = recording.seed,
            .frames = frames_of(line, recording),
            .crops = line.crops.value_or(Shot{}.crops)};
  const Recording::Frame& last = recording.frames[shot.frames - 1];
  const Look& look = recording.looks[last.look];
  shot.rig = last.moment.rig;
  shot.size = last.moment.size;
  shot.settings = look.settings;
  shot.modes = shown_modes(look);
  shot.replay = {
      .file = line.replay.string(), .assignments = line.assignments, .recording = std::move(recording)};
  check_choice(line, shot);
  return shot;
}

} // namespace unghost
