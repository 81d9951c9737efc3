#include "renderer/passes/draws.h"

#include "shaders/shared/bindings.h"

namespace unghost {
namespace {

// What a 3x3 filter needs of slope; light.comp looks from a little above the surface beside.
constexpr float shadow_bias_slope = 1.5f;

std::vector<VkVertexInputAttributeDescription> vertex_attributes() {
  return {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
          {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
          {2, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, tangent)},
          {3, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv0)},
          {4, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv1)},
          {5, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, colour)}};
}

GraphicsDesc pipeline_of(const PassCommands& commands, const DrawStyle& style, uint32_t features,
                         bool moved) {
  GraphicsDesc desc{.vertex = style.vertex,
                    .fragment = style.fragment,
                    .constants = {features, uint32_t(moved)},
                    .colours = commands.colour_formats(),
                    .depth = commands.depth_format(),
                    .written = style.written,
                    .writes_stencil = style.tags,
                    .vertex_binding = {0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX},
                    .vertex_attributes = vertex_attributes()};
  if (style.shadow) {
    // what a shadow does not see must not make more pipelines of one
    const bool masked = (features & HAS_ALPHA_MASK) != 0;
    desc.constants = {
        masked ? features & (HAS_ALPHA_MASK | 1u << TEXTURE_BASE_COLOUR | HAS_TEXTURE_PLACES) : 0u, 0u};
    if (!masked) desc.fragment.clear();
    desc.compare = VK_COMPARE_OP_LESS_OR_EQUAL;
    desc.depth_bias_slope = shadow_bias_slope;
  }
  return desc;
}

} // namespace

std::vector<Binding> draw_bindings(const FrameContext& in) {
  return {uniform(FRAME_BINDING, in.constants), buffer(DRAW_PREVIOUS, in.previous_eye_from_object),
          buffer(DRAW_TEXTURE_PLACES, in.scene.texture_places.all())};
}

void record_draws(PassCommands& commands, const FrameContext& in, std::span<const Draw* const> draws,
                  const DrawStyle& style) {
  if (draws.empty()) return;
  const VkCommandBuffer cmd = commands.commands();
  const VkBuffer vertices = in.scene.vertices.buffer;
  const VkDeviceSize zero = 0;
  vkCmdBindVertexBuffers(cmd, 0, 1, &vertices, &zero);
  vkCmdBindIndexBuffer(cmd, in.scene.indices.buffer, 0, VK_INDEX_TYPE_UINT32);
  const Draw* before = nullptr;
  for (const Draw* draw : draws) {
    const bool moved = in.moved[draw->object] != 0, moved_before = before && in.moved[before->object] != 0;
    if (before == nullptr || before->features != draw->features || moved != moved_before)
      commands.bind(pipeline_of(commands, style, draw->features | in.more_features, moved),
                    in.scene.textures.layout());
    if (before == nullptr || before->material != draw->material)
      commands.bind_second_set(in.scene.textures.set(draw->material));
    vkCmdSetCullMode(cmd, draw->double_sided || style.shadow ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
    vkCmdSetFrontFace(cmd, in.mirrored[draw->object] != 0 ? VK_FRONT_FACE_CLOCKWISE
                                                          : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    vkCmdSetStencilReference(cmd, VK_STENCIL_FACE_FRONT_AND_BACK, draw->tag);
    const DrawPush push{.eye_from_object = in.eye_from_object[draw->object],
                        .material = in.scene.materials[draw->material],
                        .material_index = draw->material,
                        .object_word = in.scene.object_words[draw->object]};
    commands.push(std::as_bytes(std::span(&push, 1)));
    commands.draw_indexed(draw->index_count, draw->first_index, draw->first_vertex, draw->object);
    before = draw;
  }
}

} // namespace unghost
