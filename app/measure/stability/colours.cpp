// Neighbourhoods without extent, and those with all the extent that there is.
#include <array>
#include <cmath>
#include <functional>

#include <glm/gtc/packing.hpp>

#include "app/interruption.h"
#include "app/measure/stability/matrix.h"
#include "shaders/shared/tonemap.h"

namespace unghost {
namespace {

using Paint = std::function<glm::vec3(uint32_t x, uint32_t y)>;

ResolveInputs painted(uint32_t width, uint32_t height, const Paint& paint) {
  ResolveInputs inputs(width, height);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) inputs.colours[inputs.at(x, y)] = paint(x, y);
  return inputs;
}

/// One unit in the last place of a half float above.
float next_half(float value) { return glm::unpackHalf1x16(uint16_t(glm::packHalf1x16(value) + 1)); }

int half_units(float a, float b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return 1 << 16;
  return std::abs(int(glm::packHalf1x16(a)) - int(glm::packHalf1x16(b)));
}

struct Flat {
  const char* name;
  Paint paint;
};

/// Whose volumes are points, lines and planes in the space of colours.
std::vector<Flat> flat_pictures() {
  const glm::vec3 one(0.18f, 0.5f, 0.9f);
  const float above = next_half(0.5f);
  return {
      {"black", [](uint32_t, uint32_t) { return glm::vec3(0); }},
      {"one colour", [=](uint32_t, uint32_t) { return one; }},
      {"two colours a unit apart",
       [=](uint32_t x, uint32_t y) { return (x + y) % 2 ? glm::vec3(0.5f) : glm::vec3(above, 0.5f, 0.5f); }},
      {"a line", [=](uint32_t x, uint32_t y) { return one * (0.25f + float((x * 7 + y * 3) % 8) / 8); }},
      {"a plane", [=](uint32_t x, uint32_t y) {
         return one * (0.5f + float(x * 5 % 4) / 8) + glm::vec3(0.25f, 0, 0) * float(y * 3 % 4);
       }}};
}

/// A box of variance that the pixel itself does not widen may leave it out.
bool lies_in_volume(const ResolveInputs& inputs, size_t pixel, const TaaSettings& taa) {
  if (taa.policy.rectify != Rectify::variance_clamp) return true;
  const int x = int(pixel % inputs.width), y = int(pixel / inputs.width);
  glm::dvec3 sum(0), squares(0);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const glm::dvec3 c = inputs.colours[inputs.at(uint32_t(glm::clamp(x + dx, 0, int(inputs.width) - 1)),
                                                    uint32_t(glm::clamp(y + dy, 0, int(inputs.height) - 1)))];
      sum += c, squares += c * c;
    }
  const glm::dvec3 mean = sum / 9.0,
                   reach = double(taa.gamma) * glm::sqrt(glm::max(squares / 9.0 - mean * mean, 0.0));
  const glm::dvec3 off = glm::abs(glm::dvec3(inputs.colours[pixel]) - mean);
  return glm::all(glm::lessThanEqual(off, reach + 1e-6));
}

constexpr uint32_t frames_kept = 16; // each of which stores it in another turn

} // namespace

/// A history that is the frame itself, with no weight of the new frame: where it lies in the volume it stays.
std::vector<Survival> survive_flat_colours(StabilityBench& bench, std::span<const ModeRun> modes) {
  std::vector<ModeRun> runs(modes.begin(), modes.end());
  for (ModeRun& run : runs) run.taa.alpha = 0;
  std::vector<Survival> survived(modes.size());
  for (const Flat& flat : flat_pictures()) {
    const ResolveInputs inputs = painted(64, 32, flat.paint);
    const auto before = bench.resolve.resolve(inputs, runs, true);
    for (uint32_t frame = 1; frame + 1 < frames_kept; ++frame) bench.resolve.advance(inputs, runs, false);
    const auto after = bench.resolve.resolve(inputs, runs, false);
    for (size_t mode = 0; mode < runs.size(); ++mode) {
      int most = 0;
      for (size_t i = 0; i < after[mode].size(); ++i)
        for (int c = 0; c < 3 && lies_in_volume(inputs, i, runs[mode].taa); ++c)
          most = std::max(most, half_units(before[mode][i][c], after[mode][i][c]));
      worsen(survived[mode], most, flat.name);
    }
  }
  return survived;
}

namespace {

constexpr uint32_t sky_width = 64, sky_height = 48;
constexpr float dim = 1e-3f, blinding = 65504; // what 1e5 is in a frame of half floats

/// A disc that wanders over the dark.
ResolveInputs sun_at(uint32_t frame) {
  const glm::vec2 centre(20 + 0.37f * float(frame), 22 + 0.21f * float(frame));
  ResolveInputs inputs = painted(sky_width, sky_height, [&](uint32_t x, uint32_t y) {
    return glm::vec3(glm::distance(glm::vec2(x, y) + 0.5f, centre) < 4 ? blinding : dim);
  });
  inputs.motion.assign(inputs.motion.size(), {-0.37f, -0.21f});
  return inputs;
}

/// The range of the 3x3 around a pixel; of all of it where nothing bounds the history.
std::array<float, 2> range_at(const ResolveInputs& inputs, uint32_t x, uint32_t y, bool bounded) {
  if (!bounded) return {dim, blinding};
  std::array<float, 2> range{INFINITY, 0};
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const uint32_t at_x = uint32_t(glm::clamp(int(x) + dx, 0, int(sky_width) - 1)),
                     at_y = uint32_t(glm::clamp(int(y) + dy, 0, int(sky_height) - 1));
      const float value = inputs.colours[inputs.at(at_x, at_y)].x;
      range = {std::min(range[0], value), std::max(range[1], value)};
    }
  return range;
}

/// As the screen shows a grey, in its steps: what nobody sees is no halo.
double shown(float value) { return 255 * display_from_linear(glm::vec3(value)).x; }

} // namespace

std::vector<Survival> survive_a_sun(StabilityBench& bench, std::span<const ModeRun> modes) {
  std::vector<Survival> survived(modes.size());
  for (uint32_t frame = 0; frame < 24; ++frame) {
    throw_if_interrupted();
    const ResolveInputs inputs = sun_at(frame);
    const auto results = bench.resolve.resolve(inputs, modes, frame == 0);
    for (size_t mode = 0; mode < modes.size(); ++mode)
      for (uint32_t y = 0; y < sky_height; ++y)
        for (uint32_t x = 0; x < sky_width; ++x) {
          const TaaPolicy& policy = modes[mode].taa.policy;
          const bool bounded = policy.rectify != Rectify::none && policy.where == Where::everywhere;
          const auto [low, high] = range_at(inputs, x, y, bounded);
          const glm::vec3 c = results[mode][inputs.at(x, y)];
          for (const float value : {c.x, c.y, c.z})
            worsen(survived[mode],
                   std::isfinite(value) ? std::max(shown(value) - shown(high), shown(low) - shown(value))
                                        : INFINITY,
                   "frame " + std::to_string(frame) + " at " + std::to_string(x) + ", " + std::to_string(y));
        }
  }
  return survived;
}

} // namespace unghost
