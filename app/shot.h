// Everything that decides what a picture shows: what the words ask for, and what the picture carries in
// itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/command_line.h"
#include "app/demo/recording.h"
#include "app/paths.h"
#include "renderer/frame_input.h"

namespace unghost {

struct Shot {
  std::string command;
  std::string scene = own_scene;
  std::string rig = "drive";
  uint64_t seed = 1;
  PictureSize size;
  uint32_t frames = 64; // from a cold start; the last is the picture
  bool crops = true;    // of a comparison: enlarged parts below each picture
  Settings settings;    // what all modes share; its taa is not read
  std::vector<ModeRun> modes;

  /// Where the frames are a path's; rig, size, settings and modes are then its last drawn frame's.
  struct Replay {
    std::string file;
    Words assignments;   // over what was recorded, in all frames
    Recording recording; // with them
  };
  std::optional<Replay> replay;
};

/// Defaults, then the settings file, then the words. Throws SettingError for what the words get wrong, and
/// Failure(input_refused) for what the file does.
Shot shot_from(const CommandLine& line);
/// The names that the words give, `all` being every row. Throws SettingError.
std::vector<std::string> named_modes(const CommandLine& line);
/// What a picture of `shot` carries; `frames` of it were drawn when it was taken.
nlohmann::json shot_json(const Shot& shot, uint32_t frames);
std::string text_of(PictureSize size);
/// What pictures and figures carry is JSON, which has no other words.
bool is_utf8(const std::string& text);

} // namespace unghost
