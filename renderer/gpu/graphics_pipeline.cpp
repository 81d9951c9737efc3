#include "renderer/gpu/pipeline_parts.h"
#include "renderer/gpu/pipelines.h"

namespace unghost {
namespace {

VkPipelineDepthStencilStateCreateInfo depth_state(const GraphicsDesc& desc) {
  const VkStencilOpState write{.failOp = VK_STENCIL_OP_KEEP,
                               .passOp = VK_STENCIL_OP_REPLACE,
                               .depthFailOp = VK_STENCIL_OP_KEEP,
                               .compareOp = VK_COMPARE_OP_ALWAYS,
                               .writeMask = 0xff};
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
          .depthTestEnable = VK_TRUE,
          .depthWriteEnable = VK_TRUE,
          .depthCompareOp = desc.compare,
          .stencilTestEnable = desc.writes_stencil,
          .front = write,
          .back = write};
}

/// An attachment that is left out is not written.
VkPipelineColorBlendAttachmentState attachment_of(const GraphicsDesc& desc, size_t i) {
  constexpr VkColorComponentFlags all = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                        VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  const bool written = desc.colours[i] != VK_FORMAT_UNDEFINED && (desc.written >> i & 1) != 0;
  return {.colorWriteMask = written ? all : 0};
}

std::string key_of_graphics(const GraphicsDesc& d, VkPipelineLayout layout) {
  std::vector<uint32_t> vertex{d.vertex_binding.stride};
  for (const VkVertexInputAttributeDescription& a : d.vertex_attributes)
    vertex.insert(vertex.end(), {a.location, uint32_t(a.format), a.offset});
  return key_of(d.vertex, d.fragment, list_of(d.constants), list_of(d.colours), list_of(vertex), d.depth,
                d.written, d.writes_stencil, d.compare, d.depth_bias_slope, layout);
}

/// All of a graphics pipeline but its stages: structs that point at each other, so it stays where it is.
struct FixedState {
  explicit FixedState(const GraphicsDesc& desc);
  FixedState(const FixedState&) = delete;

  VkPipelineVertexInputStateCreateInfo vertices;
  VkPipelineInputAssemblyStateCreateInfo assembly;
  VkPipelineViewportStateCreateInfo viewport;
  VkPipelineRasterizationStateCreateInfo raster;
  VkPipelineMultisampleStateCreateInfo samples;
  VkPipelineDepthStencilStateCreateInfo depth;
  std::vector<VkPipelineColorBlendAttachmentState> attachments;
  VkPipelineColorBlendStateCreateInfo blending;
  VkPipelineRenderingCreateInfo rendering;
};

FixedState::FixedState(const GraphicsDesc& desc) : depth(depth_state(desc)) {
  vertices = {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
              .vertexBindingDescriptionCount = desc.vertex_attributes.empty() ? 0u : 1u,
              .pVertexBindingDescriptions = &desc.vertex_binding,
              .vertexAttributeDescriptionCount = uint32_t(desc.vertex_attributes.size()),
              .pVertexAttributeDescriptions = desc.vertex_attributes.data()};
  assembly = {.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
              .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
  viewport = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
  raster = {.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
            .polygonMode = VK_POLYGON_MODE_FILL,
            .depthBiasEnable = desc.depth_bias_slope != 0,
            .depthBiasSlopeFactor = desc.depth_bias_slope,
            .lineWidth = 1};
  samples = {.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
             .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
  for (size_t i = 0; i < desc.colours.size(); ++i) attachments.push_back(attachment_of(desc, i));
  blending = {.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
              .attachmentCount = uint32_t(attachments.size()),
              .pAttachments = attachments.data()};
  rendering = {.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
               .colorAttachmentCount = uint32_t(desc.colours.size()),
               .pColorAttachmentFormats = desc.colours.data(),
               .depthAttachmentFormat = desc.depth,
               .stencilAttachmentFormat = has_stencil(desc.depth) ? desc.depth : VK_FORMAT_UNDEFINED};
}

} // namespace

const Pipeline& Pipelines::graphics(const GraphicsDesc& desc, VkPipelineLayout layout) {
  const std::string key = key_of_graphics(desc, layout);
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second.pipeline;
  std::vector<std::string> files = {desc.vertex};
  if (!desc.fragment.empty()) files.push_back(desc.fragment);
  return keep(key, std::move(files),
              [=, this](ShaderFiles& shaders) { return make_graphics(shaders, desc, layout); });
}

Pipeline Pipelines::make_graphics(ShaderFiles& shaders, const GraphicsDesc& desc,
                                  VkPipelineLayout layout) const {
  Pipeline pipeline;
  const OwnedModule vertex = module(shaders, desc.vertex, desc.constants, pipeline);
  OwnedModule fragment;
  std::vector<VkPipelineShaderStageCreateInfo> stages{stage(VK_SHADER_STAGE_VERTEX_BIT, vertex)};
  if (!desc.fragment.empty()) {
    fragment = module(shaders, desc.fragment, desc.constants, pipeline);
    stages.push_back(stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment));
  }
  const FixedState fixed(desc);
  constexpr VkDynamicState dynamic[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                        VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE,
                                        VK_DYNAMIC_STATE_STENCIL_REFERENCE};
  const VkPipelineDynamicStateCreateInfo dynamics{.sType =
                                                      VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                  .dynamicStateCount = std::size(dynamic),
                                                  .pDynamicStates = dynamic};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &fixed.rendering,
                                          .stageCount = uint32_t(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &fixed.vertices,
                                          .pInputAssemblyState = &fixed.assembly,
                                          .pViewportState = &fixed.viewport,
                                          .pRasterizationState = &fixed.raster,
                                          .pMultisampleState = &fixed.samples,
                                          .pDepthStencilState = &fixed.depth,
                                          .pColorBlendState = &fixed.blending,
                                          .pDynamicState = &dynamics,
                                          .layout = layout};
  VkPipeline made = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &made),
        "making a pipeline");
  pipeline.handle = {device_.handle(), made};
  return pipeline;
}

} // namespace unghost
