// `unghost axes`: axes of polytopes that fit tightly, around a sphere or around a scene's neighbourhoods.
#include <algorithm>
#include <random>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/failure.h"
#include "app/headless.h"
#include "app/interruption.h"
#include "app/measure/axes.h"
#include "app/table.h"

namespace unghost {
namespace {

constexpr uint32_t frames_between = 8;
constexpr size_t neighbourhoods_a_frame = 100;

/// Of pixels of one aliased frame, chosen by chance.
void add_neighbourhoods(const FloatImage& lit, std::mt19937_64& random, std::vector<Neighbourhood>& to) {
  if (lit.width < 3 || lit.height < 3) return;
  for (size_t n = 0; n < neighbourhoods_a_frame; ++n) {
    const size_t x = random() % (lit.width - 2), y = random() % (lit.height - 2);
    Neighbourhood colours;
    for (size_t i = 0; i < 9; ++i) {
      const float* texel = &lit.values[3 * ((y + i / 3) * lit.width + x + i % 3)];
      colours[i] = {texel[0], texel[1], texel[2]};
    }
    to.push_back(colours);
  }
}

std::vector<Neighbourhood> neighbourhoods_of(const Shot& shot, Headless& headless) {
  std::vector<Neighbourhood> all;
  std::mt19937_64 random(shot.seed);
  const auto wants = [](uint32_t frame) {
    return frame % frames_between == 0 ? std::vector<Wanted>{{Output::lit}} : std::vector<Wanted>{};
  };
  headless.render(shot.modes, wants, [&](uint32_t, const auto&, FrameResult& result) {
    add_neighbourhoods(result.delivered[0].image, random, all);
  });
  return all;
}

AxisSearch search_of(const CommandLine& line, const Shot& shot) {
  const uint32_t faces = line.faces.value_or(16);
  if (faces % 2 != 0) throw WrongWords("--faces must be even: each axis has one on either side");
  const AxisSearch search{.count = faces / 2,
                          .fixed = line.of_scene ? 0u : 3u,
                          .seed = shot.seed,
                          .steps = line.of_scene ? 6'000u : 24'000u};
  if (search.count <= search.fixed)
    throw WrongWords("without --of-scene, --faces must be more than 6, which X, Y and Z have");
  return search;
}

FoundAxes search_with_progress(const AxisSearch& search, const AxisCost& cost, Console& console) {
  return find_axes(search, cost, [&](double share) {
    throw_if_interrupted();
    if (console.terminal && !console.quiet)
      console.err << "\rsearching: " << int(100 * share) << "%" << (share >= 1 ? "\n" : "") << std::flush;
  });
}

/// What was found beside where the search began and beside the lists that shaders are made with.
void say(const FoundAxes& found, const AxisCost& cost, const char* unit, nlohmann::json object, bool as_json,
         Console& console) {
  std::vector<std::pair<std::string, std::vector<glm::dvec3>>> compared = {{"found", found.axes},
                                                                           {"at first", found.first}};
  for (const Answer& answer : answers<Axes>()) compared.emplace_back(answer.name, shipped_axes(answer.name));
  Table table{{"axes", "faces", unit}};
  for (const auto& [name, axes] : compared) {
    const double tightness = cost(axes);
    object["tightness"][name] = tightness;
    table.add({name, std::to_string(2 * axes.size()), fixed(tightness, 5)});
  }
  std::string list;
  for (const glm::dvec3& axis : found.axes) {
    object["axes"].push_back({axis.x, axis.y, axis.z});
    list += "X(" + fixed(axis.x, 6) + ", " + fixed(axis.y, 6) + ", " + fixed(axis.z, 6) + ")\n";
  }
  console.out << (as_json ? object.dump(2) + "\n"
                          : table.text() + "\nfor shaders/shared/taa_axes.h:\n" + list);
}

} // namespace

void axes(const CommandLine& line, Console& console) {
  Shot shot = shot_from(line);
  shot.modes = {{.name = "off", .taa = {}}};
  const AxisSearch search = search_of(line, shot);
  if (!line.of_scene && (line.scene || line.size || line.rig || line.frames || !line.assignments.empty()))
    throw WrongWords(
        "around the sphere no scene is drawn: say --of-scene, or neither scene, rig, size nor settings");
  std::vector<Neighbourhood> neighbourhoods;
  if (line.of_scene) {
    Headless headless(line, shot, console);
    neighbourhoods = neighbourhoods_of(shot, headless);
    if (size_around(shipped_axes(spelling(Axes::xyz)), neighbourhoods) == 0)
      throw Failure(Exit::failed,
                    "no neighbourhood of these frames has more than a plane of colours: there is nothing "
                    "to fit axes around");
    headless.finish();
  }
  const AxisCost cost = [&](std::span<const glm::dvec3> axes) {
    return line.of_scene ? size_around(axes, neighbourhoods) : volume_around_sphere(axes);
  };
  const char* unit = line.of_scene ? "side of the mean polytope" : "volume over the sphere's";
  const nlohmann::json object = {{"faces", 2 * search.count}, {"seed", shot.seed}, {"measure", unit}};
  say(search_with_progress(search, cost, console), cost, unit, object, line.json, console);
}

} // namespace unghost
