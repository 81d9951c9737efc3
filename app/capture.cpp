// `unghost capture`: frames of one mode as a picture, a sequence, or the buffers that a resolve reads.
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/exr_file.h"
#include "app/files.h"
#include "app/headless.h"
#include "app/picture_output.h"
#include "app/png_file.h"
#include "app/writing/writing_thread.h"

namespace unghost {
namespace {

constexpr Output buffers_of_a_frame[] = {Output::lit, Output::depth, Output::motion, Output::tag,
                                         Output::resolved};

void check_words(const CommandLine& line, const Shot& shot) {
  const bool folders = !line.sequence.empty() || !line.buffers.empty();
  if (line.output.empty() && !folders)
    throw WrongWords("capture wants -o FILE, --sequence DIR or --buffers DIR");
  if (line.from && !folders)
    throw WrongWords("--from says where --sequence or --buffers begin, and neither is given");
  if (line.from && *line.from >= shot.frames)
    throw WrongWords("--from " + std::to_string(*line.from) + " is beyond the last of " +
                     std::to_string(shot.frames) + " frames");
  if (line.output.ends_with(".exr") && shot.settings.view != View::colour)
    throw WrongWords("an EXR holds the resolved colours, so --view does not go with it");
}

void prepare_folder(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  make_folder(folder);
  const NewFile probe(folder / "00000.png"); // is gone again at once
}

std::filesystem::path frame_file(const std::filesystem::path& folder, uint32_t frame, const char* ending) {
  std::string number = std::to_string(frame);
  if (number.size() < 5) number.insert(0, 5 - number.size(), '0');
  return folder / (number + ending);
}

std::vector<uint8_t> encode_buffers(const std::vector<FloatImage>& images, const std::string& text) {
  const FloatImage &lit = images[0], &depth = images[1], &motion = images[2], &tag = images[3],
                   &resolved = images[4];
  return encode_exr({{"R", &lit, 0},
                     {"G", &lit, 1},
                     {"B", &lit, 2},
                     {"Z", &depth, 0},
                     {"motion.X", &motion, 0},
                     {"motion.Y", &motion, 1},
                     {"tag", &tag, 0},
                     {"resolved.R", &resolved, 0},
                     {"resolved.G", &resolved, 1},
                     {"resolved.B", &resolved, 2}},
                    text);
}

std::vector<uint8_t> encode_resolved(const FloatImage& resolved, const std::string& text) {
  return encode_exr({{"R", &resolved, 0}, {"G", &resolved, 1}, {"B", &resolved, 2}}, text);
}

/// What is wanted of each frame, and where it goes.
class Capture {
public:
  Capture(const CommandLine& line, const Shot& shot, Console& console) : line_(line), shot_(shot) {
    if (!line.output.empty()) output_.emplace(line, console);
    prepare_folder(line.sequence);
    prepare_folder(line.buffers);
  }

  std::vector<Wanted> wants(uint32_t frame) const {
    std::vector<Wanted> wanted;
    if (buffers(frame))
      for (const Output what : buffers_of_a_frame) wanted.push_back({what});
    if (sequence(frame) || (last(frame) && output_ && !output_->is_exr()))
      wanted.push_back({Output::display});
    if (last(frame) && output_ && output_->is_exr() && !buffers(frame)) wanted.push_back({Output::resolved});
    return wanted;
  }

  void take(uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result) {
    const std::string text = shot_json(shot_, frame + 1).dump();
    if (last(frame) && output_) {
      if (output_->is_exr())
        output_->write(encode_resolved(delivered(wanted, result, Output::resolved).image, text));
      else
        output_->write(encode_png(delivered(wanted, result, Output::display).picture, text));
    }
    if (sequence(frame))
      write_picture(frame, std::move(delivered(wanted, result, Output::display).picture), text);
    if (buffers(frame)) write_buffers(frame, wanted, result, text);
  }

  void finish() { writing_.finish(); }

private:
  bool last(uint32_t frame) const { return frame + 1 == shot_.frames; }
  bool in_range(uint32_t frame) const { return frame >= line_.from.value_or(0); }
  bool sequence(uint32_t frame) const { return !line_.sequence.empty() && in_range(frame); }
  bool buffers(uint32_t frame) const { return !line_.buffers.empty() && in_range(frame); }

  void write_picture(uint32_t frame, Image picture, std::string text) {
    const auto file = frame_file(line_.sequence, frame, ".png");
    const auto shared = std::make_shared<Image>(std::move(picture));
    writing_.add([file, shared, text = std::move(text)] { write_file(file, encode_png(*shared, text)); });
  }

  void write_buffers(uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result,
                     std::string text) {
    const auto file = frame_file(line_.buffers, frame, ".exr");
    const auto images = std::make_shared<std::vector<FloatImage>>();
    for (const Output what : buffers_of_a_frame)
      images->push_back(std::move(delivered(wanted, result, what).image));
    writing_.add([file, images, text = std::move(text)] { write_file(file, encode_buffers(*images, text)); });
  }

  const CommandLine& line_;
  const Shot& shot_;
  std::optional<PictureOutput> output_;
  WritingThread writing_;
};

} // namespace

void capture(const CommandLine& line, Console& console) {
  const auto start = std::chrono::steady_clock::now();
  const Shot shot = shot_from(line);
  check_words(line, shot);
  Capture capture(line, shot, console);
  Headless headless(line, shot, console);
  headless.render(
      shot.modes, [&](uint32_t frame) { return capture.wants(frame); },
      [&](uint32_t frame, const auto& wanted, FrameResult& result) { capture.take(frame, wanted, result); });
  capture.finish();
  if (line.json) {
    nlohmann::json object = headless.facts();
    object.update(shot_json(shot, shot.frames));
    object["file"] = line.output.empty() ? nlohmann::json() : nlohmann::json(line.output);
    object["passes"] = nlohmann::json::array();
    for (const PassSummary& pass : headless.passes())
      object["passes"].push_back(
          {{"name", pass.name}, {"ms", pass.ms}, {"frames", pass.frames}, {"image_bytes", pass.image_bytes}});
    object["wall_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    console.out << object.dump(2) << "\n";
  }
  headless.finish();
}

} // namespace unghost
