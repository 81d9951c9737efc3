// What passes took and what their images came to, over the frames of a run.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "renderer/frame_input.h"

namespace unghost {

/// A pass over all frames: how many had it, the median of its times there in ms, and the most bytes that its
/// images had. A frame that has it once a geometry or a mode counts once, with the sum.
struct PassSummary {
  std::string name;
  size_t frames = 0;
  double ms = 0;
  uint64_t image_bytes = 0;
};

class PassTimes {
public:
  void note(const FrameResult& frame);
  /// In the order in which they were first met.
  std::vector<PassSummary> summaries() const;
  /// For people, with a whole frame last.
  std::string text() const;

private:
  /// What is kept of a pass: a number a frame.
  struct Record {
    std::vector<double> ms;
    uint64_t image_bytes = 0;
  };

  std::vector<std::string> order_;
  std::map<std::string, Record> records_;
  size_t frames_ = 0;
  uint64_t image_bytes_ = 0; // the most that a frame has
};

} // namespace unghost
