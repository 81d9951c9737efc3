// `unghost compare`: the same frames through several modes, beside one another.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/headless.h"
#include "app/picture_grid.h"
#include "app/picture_output.h"
#include "app/png_file.h"

namespace unghost {
namespace {

// Between the first and the last that keep a history: as a rule the ghost, and the best that is done against
// it.
std::vector<Window> crops_of(const Shot& shot, const std::vector<LabelledPicture>& pictures) {
  const auto keeps_history = [](const ModeRun& run) { return run.taa.policy.needs_history(); };
  const auto first = std::ranges::find_if(shot.modes, keeps_history);
  const auto last = std::find_if(shot.modes.rbegin(), shot.modes.rend(), keeps_history);
  if (!shot.crops || first == shot.modes.end() || &*first == &*last) return {};
  return windows_of_difference(pictures[size_t(first - shot.modes.begin())].picture,
                               pictures[size_t(shot.modes.rend() - last) - 1].picture,
                               shot.size.width / crop_share, shot.size.height / crop_share, crops_a_row);
}

nlohmann::json comparison_json(const Shot& shot, const Headless& headless, const PictureOutput& output,
                               const std::vector<Window>& crops) {
  nlohmann::json object = headless.facts();
  object.update(shot_json(shot, shot.frames));
  object["file"] = output.name();
  object["windows"] = nlohmann::json::array();
  for (const Window& window : crops)
    object["windows"].push_back(
        {{"x", window.x}, {"y", window.y}, {"width", window.width}, {"height", window.height}});
  return object;
}

} // namespace

void compare(const CommandLine& line, Console& console) {
  const Shot shot = shot_from(line);
  if (line.output.empty()) throw WrongWords("compare wants -o FILE");
  if (line.output.ends_with(".exr")) throw WrongWords("a comparison is a PNG");
  PictureOutput output(line, console);
  Headless headless(line, shot, console);
  std::vector<LabelledPicture> pictures;
  const auto wants = [&](uint32_t frame) {
    std::vector<Wanted> wanted;
    for (size_t mode = 0; mode < shot.modes.size() && frame + 1 == shot.frames; ++mode)
      wanted.push_back({Output::display, mode});
    return wanted;
  };
  headless.render(shot.modes, wants, [&](uint32_t, const auto&, FrameResult& result) {
    for (size_t mode = 0; mode < shot.modes.size(); ++mode)
      pictures.push_back({shot.modes[mode].name, std::move(result.delivered[mode].picture)});
  });
  const std::vector<Window> crops = crops_of(shot, pictures);
  output.write(encode_png(picture_grid(pictures, crops), shot_json(shot, shot.frames).dump()));
  if (line.json) console.out << comparison_json(shot, headless, output, crops).dump(2) << "\n";
  headless.finish();
}

} // namespace unghost
