// Recordings as files: JSON, of each frame what is otherwise than in the frame before.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/demo/recording.h"

namespace unghost {

/// Ten minutes of a window that keeps up. A recording that reaches either bound ends by itself.
constexpr size_t most_recorded_frames = 36'000, recording_limit = 16 << 20; // bytes

/// Writes a recording while it is made.
class Recorder {
public:
  Recorder(const std::string& scene, uint64_t seed);
  /// Why that can be no part of it, in words; empty where it can.
  std::string why_not(const Look& look) const;
  /// The first of all frames is a cut.
  void add(const Moment& moment, const Look& look);
  size_t frames() const { return frames_; }
  /// The content of its file; there is a frame.
  std::string text() const;

private:
  std::string head_, lines_;
  size_t frames_ = 0;
  std::optional<Moment> before_;
  Look look_;
};

/// Throws SettingError, or json::exception for what is no JSON.
Recording recording_from_text(const std::string& text);
/// Throws Failure(input_refused) with the file and what is wrong with it.
Recording load_recording(const std::filesystem::path& file);

} // namespace unghost
