#include "app/pass_times.h"

#include <algorithm>

#include "app/measure/quantile.h"
#include "app/table.h"

namespace unghost {

void PassTimes::note(const FrameResult& frame) {
  ++frames_;
  image_bytes_ = std::max(image_bytes_, frame.image_bytes);
  std::map<std::string, PassReport> of_frame;
  for (const PassReport& pass : frame.passes) {
    if (!records_.contains(pass.name) && !of_frame.contains(pass.name)) order_.push_back(pass.name);
    PassReport& sum = of_frame[pass.name];
    sum.ms += pass.ms, sum.image_bytes += pass.image_bytes;
  }
  for (const auto& [name, sum] : of_frame) {
    Record& record = records_[name];
    record.ms.push_back(sum.ms);
    record.image_bytes = std::max(record.image_bytes, sum.image_bytes);
  }
}

std::vector<PassSummary> PassTimes::summaries() const {
  std::vector<PassSummary> summaries;
  for (const std::string& name : order_) {
    const Record& record = records_.at(name);
    summaries.push_back({.name = name,
                         .frames = record.ms.size(),
                         .ms = quantile(record.ms, 0.5),
                         .image_bytes = record.image_bytes});
  }
  return summaries;
}

std::string PassTimes::text() const {
  Table table{{"pass", "frames", "ms", "images MiB"}};
  double total_ms = 0;
  for (const PassSummary& pass : summaries()) {
    const double mib = double(pass.image_bytes) / (1 << 20);
    total_ms += pass.ms * double(pass.frames) / double(frames_);
    table.add({pass.name, std::to_string(pass.frames), fixed(pass.ms, 2), fixed(mib, 1)});
  }
  table.add({"a frame", "", fixed(total_ms, 2), fixed(double(image_bytes_) / (1 << 20), 1)});
  return table.text();
}

} // namespace unghost
