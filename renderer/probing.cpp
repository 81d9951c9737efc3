#include "renderer/probing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/gtc/packing.hpp>

#include "renderer/deliver.h"
#include "shaders/shared/taa_key.h"

namespace unghost {
namespace {

/// In the order in which they are asked for; the last one where the mode keeps a history.
enum Readback : size_t { colours, resolved, depth, tag, motion, object, of_resolve };

bool resolves(const FrameInput& input) { return input.modes[input.probe->mode].taa.policy.needs_history(); }

/// The pixel and its neighbours, as far as there are any.
VkRect2D neighbourhood(const FrameInput& input) {
  const auto [mode, x, y] = *input.probe;
  const uint32_t left = std::max(x, 1u) - 1, top = std::max(y, 1u) - 1;
  return {{int32_t(left), int32_t(top)},
          {std::min(x + 2, input.width) - left, std::min(y + 2, input.height) - top}};
}

/// Texels of the 3x3 pixels, row by row, the edge going on.
template <class T> std::array<T, 9> nine(const FrameInput& input, const std::vector<std::byte>& bytes) {
  const VkRect2D part = neighbourhood(input);
  std::array<T, 9> texels;
  for (int i = 0; i < 9; ++i) {
    const int x = std::clamp(int(input.probe->x) + i % 3 - 1, 0, int(input.width) - 1) - part.offset.x;
    const int y = std::clamp(int(input.probe->y) + i / 3 - 1, 0, int(input.height) - 1) - part.offset.y;
    texels[size_t(i)] = element<T>(bytes, size_t(y) * part.extent.width + size_t(x));
  }
  return texels;
}

glm::vec3 unpacked(uint64_t half) { return glm::vec3(glm::unpackHalf4x16(half)); }

/// What the resolve wrote of its pixel. Motions are of the 3x3 pixels.
void take_resolve(ProbedPixel& pixel, const std::vector<std::byte>& texels,
                  const std::array<glm::vec2, 9>& motions) {
  const auto found = element<glm::vec4>(texels, TAA_PROBE_FOUND),
             bounded = element<glm::vec4>(texels, TAA_PROBE_BOUNDED),
             why = element<glm::vec4>(texels, TAA_PROBE_WHY),
             mixed_in = element<glm::vec4>(texels, TAA_PROBE_INPUT);
  pixel.weight = bounded.w, pixel.count = why.z;
  pixel.causes = Reject(uint32_t(why.y) & ((1u << TAA_CLASS_SHIFT) - 1));
  pixel.mixed_in = glm::vec3(mixed_in);
  if (why.w == 0) return;
  const auto speaker = size_t(found.w);
  pixel.history = {.found = glm::vec3(found),
                   .bounded = glm::vec3(bounded),
                   .moved = why.x,
                   .rectified = mixed_in.w != 0,
                   .speaker = speaker,
                   .at_px = glm::dvec2(pixel.input.x, pixel.input.y) + 0.5 + glm::dvec2(motions[speaker])};
}

} // namespace

void ask_probe(FrameGraph& graph, const FrameImages& images, const FrameInput& input) {
  const ProbeInput& probe = *input.probe;
  assert(probe.mode < images.modes.size() && probe.x < input.width && probe.y < input.height);
  const FrameImages::OfMode& mode = images.modes[probe.mode];
  const FrameImages::OfGeometry& geometry = images.geometries[mode.geometry];
  constexpr VkImageAspectFlags colour = VK_IMAGE_ASPECT_COLOR_BIT;
  const VkRect2D around = neighbourhood(input), here{{int32_t(probe.x), int32_t(probe.y)}, {1, 1}};
  graph.read_back(geometry.lit.colour, colour, around);
  graph.read_back(mode.resolved, colour, here);
  graph.read_back(geometry.gbuffer.depth, VK_IMAGE_ASPECT_DEPTH_BIT, here);
  graph.read_back(geometry.gbuffer.depth, VK_IMAGE_ASPECT_STENCIL_BIT, here);
  graph.read_back(geometry.motion.motion_px, colour, around);
  graph.read_back(geometry.gbuffer.object, colour, here);
  if (resolves(input)) graph.read_back(mode.probe, colour);
}

size_t probe_readbacks(const FrameInput& input) {
  return input.probe ? of_resolve + size_t(resolves(input)) : 0;
}

ProbedPixel probed(const FrameInput& input, std::span<const std::vector<std::byte>> readbacks) {
  const std::array<glm::vec2, 9> motions = nine<glm::vec2>(input, readbacks[motion]);
  ProbedPixel pixel{.input = *input.probe,
                    .mode = input.modes[input.probe->mode],
                    .exposure = std::exp2(input.settings.light.exposure_ev),
                    .resolved = unpacked(element<uint64_t>(readbacks[resolved])),
                    .depth_m = float(input.now.near_plane) / element<float>(readbacks[depth]),
                    .motion_px = motions[4],
                    .tag = element<uint8_t>(readbacks[tag]),
                    .object = element<uint32_t>(readbacks[object]) & OBJECT_NODE};
  std::ranges::transform(nine<uint64_t>(input, readbacks[colours]), pixel.colours.begin(), unpacked);
  pixel.mixed_in = pixel.colours[4];
  if (resolves(input)) take_resolve(pixel, readbacks[of_resolve], motions);
  return pixel;
}

} // namespace unghost
