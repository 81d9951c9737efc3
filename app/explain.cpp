// `unghost explain`: what a frame is made of, what it was made without and because of what, and what that
// saved.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/headless.h"
#include "app/measure/frame_parts.h"
#include "app/measure/quantile.h"
#include "app/table.h"
#include "renderer/stillness.h"

namespace unghost {
namespace {

using nlohmann::json;

constexpr size_t longest_list = 16; // of pipelines that a person reads

std::string mib(double bytes) { return fixed(bytes / (1 << 20), 1); }
/// What would be read as 0.0 is not.
bool is_listed(double bytes) { return std::abs(bytes) >= 0.05 * (1 << 20); }
double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// From the tenth to the ninetieth percentile; below the noise where it has both signs, or where there are
/// too few rounds to know.
struct Spread {
  double low = 0, middle = 0, high = 0;
  bool few = false;
  explicit Spread(const std::vector<double>& ms)
      : low(quantile(ms, 0.1)), middle(median(ms)), high(quantile(ms, 0.9)), few(ms.size() < explain_rounds) {
  }
  bool below_noise() const { return few || (low <= 0 && high >= 0); }
};

uint32_t draws_of(const FrameResult& frame, std::string_view name) {
  uint32_t draws = 0;
  for (const PassReport& pass : frame.passes)
    if (pass.name == name)
      for (const UsedPipeline& used : pass.pipelines) draws += used.draws;
  return draws;
}

/// The most that any pipeline of the pass has.
uint32_t most(const PassReport& pass, uint32_t UsedPipeline::*member) {
  uint32_t found = 0;
  for (const UsedPipeline& used : pass.pipelines) found = std::max(found, used.*member);
  return found;
}

json passes_json(const FrameParts& parts) {
  json list = json::array();
  for (size_t i = 0; i < parts.frame.passes.size(); ++i) {
    const PassReport& pass = parts.frame.passes[i];
    json pipelines = json::array();
    for (const UsedPipeline& used : pass.pipelines)
      pipelines.push_back({{"shader", used.shader},
                           {"constants", used.constants},
                           {"instructions", used.instructions},
                           {"fetches", used.fetches},
                           {"draws", used.draws}});
    list.push_back({{"name", pass.name},
                    {"ms", median(parts.pass_ms[i])},
                    {"image_bytes", pass.image_bytes},
                    {"pipelines", pipelines}});
  }
  return list;
}

json left_out_json(const FrameParts& parts) {
  json list = json::array();
  for (const Saving& saving : parts.savings) {
    const Spread ms(saving.ms);
    list.push_back({{"what", saving.thing.what},
                    {"why", saving.thing.why},
                    {"bytes", saving.bytes},
                    {"ms", ms.middle},
                    {"p10", ms.low},
                    {"p90", ms.high},
                    {"below_noise", ms.below_noise()}});
  }
  return list;
}

json frame_json(const FrameParts& parts) {
  json images = json::array();
  for (const UsedImage& image : parts.frame.images)
    images.push_back({{"name", image.name}, {"bytes", image.bytes}});
  return {{"passes", passes_json(parts)},
          {"images", images},
          {"left_out", left_out_json(parts)},
          {"draws", draws_of(parts.frame, "g-buffer")},
          {"everything_draws", draws_of(parts.everything, "g-buffer")},
          {"total_bytes", parts.frame.image_bytes},
          {"everything_bytes", parts.everything.image_bytes},
          {"total_ms", median(parts.frame_ms)},
          {"everything_ms", median(parts.everything_ms)}};
}

std::string pass_table(const FrameParts& parts) {
  Table table{{"pass", "ms", "images MiB", "instructions", "fetches", "pipelines", "draws"}};
  for (size_t i = 0; i < parts.frame.passes.size(); ++i) {
    const PassReport& pass = parts.frame.passes[i];
    const auto number = [](uint32_t value) { return value == 0 ? "-" : std::to_string(value); };
    table.add({pass.name, fixed(median(parts.pass_ms[i]), 2), mib(double(pass.image_bytes)),
               number(most(pass, &UsedPipeline::instructions)), number(most(pass, &UsedPipeline::fetches)),
               number(uint32_t(pass.pipelines.size())), number(draws_of(parts.frame, pass.name))});
  }
  return table.text() +
         "instructions and fetches are those of the longest pipeline of each pass, as SPIR-V\n";
}

std::string pipeline_table(const FrameParts& parts) {
  Table table{{"pipeline", "constants", "instructions", "fetches"}};
  size_t rows = 0;
  for (const PassReport& pass : parts.frame.passes)
    for (const UsedPipeline& used : pass.pipelines) {
      std::string constants;
      for (const uint32_t constant : used.constants)
        constants += (constants.empty() ? "" : ",") + std::to_string(constant);
      // the last of its shaders says most
      table.add({used.shader.substr(used.shader.find(' ') + 1), constants, std::to_string(used.instructions),
                 std::to_string(used.fetches)});
      ++rows;
    }
  return rows <= longest_list ? "\n" + table.text() : std::string{};
}

std::string image_table(const FrameParts& parts) {
  Table table{{"image", "MiB"}};
  uint64_t small = 0;
  for (const UsedImage& image : parts.frame.images)
    if (is_listed(double(image.bytes)))
      table.add({image.name, mib(double(image.bytes))});
    else
      small += image.bytes;
  return "\n" + table.text() +
         "smaller ones, and those in place of what is not made: " + std::to_string(small) + " bytes\n";
}

std::string left_out_table(const FrameParts& parts) {
  Table table{{"made without", "because", "MiB", "ms"}};
  for (const Saving& saving : parts.savings) {
    const Spread ms(saving.ms);
    const std::string bytes = is_listed(double(saving.bytes)) ? mib(double(saving.bytes)) : "-";
    table.add(
        {saving.thing.what, saving.thing.why, bytes, ms.below_noise() ? "below noise" : fixed(ms.middle, 2)});
  }
  return "\n" + table.text() +
         "each by itself; an image costs none where it lies in memory that another pass has left, and some\n"
         "go only where several things go\n";
}

std::string totals(const FrameParts& parts) {
  const double ms = median(parts.frame_ms), everything_ms = median(parts.everything_ms);
  const double bytes = double(parts.frame.image_bytes), everything = double(parts.everything.image_bytes);
  return "\nthe frame: " + fixed(ms, 1) + " ms, " + mib(bytes) + " MiB of images, " +
         std::to_string(draws_of(parts.frame, "g-buffer")) +
         " draws; with everything: " + fixed(everything_ms, 1) + " ms, " + mib(everything) + " MiB, " +
         std::to_string(draws_of(parts.everything, "g-buffer")) + " draws\nit takes " +
         fixed(ms / everything_ms, 2) + " of the time and " + fixed(bytes / everything, 2) +
         " of the memory of everything\n";
}

/// Whether the window may leave the frame as it is.
json stillness_json(const Film& film, const Shot& shot) {
  Stillness stillness(film.animated);
  std::string change;
  for (uint32_t index = 0; index < std::max(shot.frames, 2u); ++index) { // nothing moves before the first
    FrameInput input = film.at(index);
    input.modes = shot.modes;
    stillness.frames_left(input);
    if (!stillness.change().empty()) change = stillness.change();
  }
  if (!change.empty()) return {{"skippable", false}, {"because", change}};
  const std::optional<uint32_t> settled = frames_until_settled(shot.modes.front().taa);
  if (!settled)
    return {{"skippable", false}, {"because", "a history that is clipped everywhere flickers for ever"}};
  return {{"skippable", true}, {"after_frames", *settled}};
}

std::string stillness_text(const json& stillness) {
  if (!stillness.at("skippable"))
    return "no frame can be skipped: " + stillness.at("because").get<std::string>() + "\n";
  return "nothing moves: after " + std::to_string(stillness.at("after_frames").get<uint32_t>()) +
         " frames the picture has settled, and frames can be skipped\n";
}

} // namespace

void explain(const CommandLine& line, Console& console) {
  const Shot shot = shot_from(line);
  if (shot.settings.keep_all)
    throw SettingError("explain compares with a frame that keeps all by itself; keep-all is not for it");
  Headless headless(line, shot, console);
  const Film film = headless.film();
  const FrameParts parts =
      take_apart(film, shot.modes.front(), shot.frames - 1, line.rounds.value_or(explain_rounds));
  const json stillness = stillness_json(film, shot);
  if (line.json) {
    json object = headless.facts();
    object.update(frame_json(parts));
    object["scene"] = shot.scene, object["rig"] = shot.rig, object["mode"] = shot.modes.front().name;
    object["size"] = text_of(shot.size), object["frames"] = shot.frames;
    object["rounds"] = parts.frame_ms.size(), object["stillness"] = stillness;
    console.out << object.dump(2) << "\n";
  } else {
    console.out << pass_table(parts) << pipeline_table(parts) << image_table(parts) << left_out_table(parts)
                << totals(parts) << stillness_text(stillness);
  }
  headless.finish();
}

} // namespace unghost
