// Frames that a measurement keeps for the eye.
#pragma once

#include "app/measure/protocols.h"

namespace unghost {

/// One mode's frame and what it was compared with.
struct OfferedFrame {
  size_t mode = 0;
  uint32_t frame = 0;
  double flip = 0;
  const Image& picture;
  const Image& reference;
};

/// ghosting-blend-00016.png
std::string picture_file(const std::string& kind, const std::string& of, uint32_t frame);

/// Keeps each mode's worst frame in memory until the end, or saves every frame at once. The frame that comes
/// last is taken as a mode's worst one where `latest` is asked for: the same instant for all modes.
class FrameKeeper {
public:
  FrameKeeper(const Measurement& m, std::string kind, bool latest = false)
      : m_(m), kind_(std::move(kind)), latest_(latest), best_(m.modes.size()) {}

  void offer(const OfferedFrame& frame);
  /// Saves what was kept, and lists it.
  void finish(Measured& into);

private:
  struct Kept {
    bool any = false;
    uint32_t frame = 0;
    double flip = 0;
    Image picture;
  };

  const Measurement& m_;
  std::string kind_;
  bool latest_;
  std::vector<Kept> best_;
  std::map<uint32_t, Image> references_; // of the frames in `best_`
};

} // namespace unghost
