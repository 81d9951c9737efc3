// Shaders and pipelines, made when they are first asked for and kept. What a pipeline is made from is its
// key.
#pragma once

#include <filesystem>
#include <functional>
#include <map>

#include "renderer/gpu/frame_graph.h"
#include "renderer/gpu/shader_files.h"

namespace unghost {

/// What set 0 holds: the push descriptors of a pass. Set 1, where there is one, belongs to whoever draws.
struct LayoutDesc {
  std::vector<std::pair<uint32_t, VkDescriptorType>> bindings;
  VkDescriptorSetLayout second_set = VK_NULL_HANDLE;
};

struct GraphicsDesc {
  std::string vertex, fragment;    // shader files; an empty fragment draws depth alone
  std::vector<uint32_t> constants; // constant_id 0, 1, ... of both stages
  std::vector<VkFormat> colours;   // VK_FORMAT_UNDEFINED: this attachment is left out
  VkFormat depth = VK_FORMAT_UNDEFINED;
  uint32_t written = ~0u; // of the colours, a bit each: the others stay as they are
  bool writes_stencil = false;
  VkCompareOp compare = VK_COMPARE_OP_GREATER_OR_EQUAL;
  float depth_bias_slope = 0;
  VkVertexInputBindingDescription vertex_binding{};
  std::vector<VkVertexInputAttributeDescription> vertex_attributes;
};

inline constexpr uint32_t push_constant_bytes = 128;

struct Pipeline {
  OwnedPipeline handle;
  uint32_t instructions = 0, fetches = 0; // as UsedPipeline counts them
};

class Pipelines {
public:
  Pipelines(const Device& device, std::filesystem::path shaders);

  VkPipelineLayout layout(const LayoutDesc& desc);
  const Pipeline& compute(const std::string& shader, const std::vector<uint32_t>& constants,
                          VkPipelineLayout layout);
  /// Cull mode, front face, viewport, scissor and stencil reference are dynamic.
  const Pipeline& graphics(const GraphicsDesc& desc, VkPipelineLayout layout);
  /// Reads all shaders of the folder again, and remakes the pipelines whose shaders are others now; waits for
  /// the device. Throws std::runtime_error where any is not what was built, and what the device throws; then
  /// all stays as it was. That their bindings are the program's is not checked.
  void reload();

private:
  struct Layout {
    OwnedSetLayout set;
    OwnedLayout layout;
  };
  using MakePipeline = std::function<Pipeline(ShaderFiles&)>;
  struct Kept {
    Pipeline pipeline;
    std::vector<std::string> shaders; // files that it is made of
    MakePipeline make;
  };
  const Pipeline& keep(const std::string& key, std::vector<std::string> shaders, MakePipeline make);
  Pipeline make_graphics(ShaderFiles& shaders, const GraphicsDesc& desc, VkPipelineLayout layout) const;
  /// What the module does is added to the counts of `pipeline`.
  OwnedModule module(ShaderFiles& shaders, const std::string& file, const std::vector<uint32_t>& constants,
                     Pipeline& pipeline) const;

  const Device& device_;
  ShaderFiles shaders_;
  std::map<std::vector<uint64_t>, Layout> layouts_;
  std::map<std::string, Kept> pipelines_;
};

} // namespace unghost
