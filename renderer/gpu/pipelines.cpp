#include "renderer/gpu/pipelines.h"

#include <fstream>
#include <sstream>

namespace unghost {
namespace {

constexpr uint32_t spirv_magic = 0x07230203;

std::vector<uint32_t> read_spirv(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("the shader " + file.string() + " is missing; build again");
  std::stringstream bytes;
  bytes << in.rdbuf();
  const std::string text = bytes.str();
  std::vector<uint32_t> words(text.size() / 4);
  std::memcpy(words.data(), text.data(), words.size() * 4);
  if (words.size() < 5 || words[0] != spirv_magic || text.size() % 4 != 0)
    throw std::runtime_error("the shader " + file.string() + " is not SPIR-V; build again");
  return words;
}

/// Specialization constants 0, 1, ... of 32 bits each.
struct Specialization {
  explicit Specialization(const std::vector<uint32_t>& constants) {
    for (uint32_t i = 0; i < constants.size(); ++i) entries.push_back({i, i * 4, 4});
    info = {uint32_t(entries.size()), entries.data(), constants.size() * 4, constants.data()};
  }
  std::vector<VkSpecializationMapEntry> entries;
  VkSpecializationInfo info{};
};

template <class... Parts> std::string key_of(const Parts&... parts) {
  std::ostringstream key;
  ((key << parts << '\n'), ...);
  return key.str();
}

template <class Range> std::string list_of(const Range& range) {
  std::ostringstream list;
  for (const auto& element : range) list << uint64_t(element) << ' ';
  return list.str();
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits bit, VkShaderModule module,
                                      const VkSpecializationInfo& info) {
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
          .stage = bit,
          .module = module,
          .pName = "main",
          .pSpecializationInfo = &info};
}

} // namespace

Pipelines::Pipelines(const Device& device, std::filesystem::path shaders)
    : device_(device), shaders_(std::move(shaders)) {}

VkShaderModule Pipelines::module(const std::string& file) {
  if (const auto found = modules_.find(file); found != modules_.end()) return found->second;
  const std::vector<uint32_t> words = read_spirv(shaders_ / (file + ".spv"));
  const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                      .codeSize = words.size() * 4,
                                      .pCode = words.data()};
  VkShaderModule made = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device_.handle(), &info, nullptr, &made), "loading a shader");
  return modules_.emplace(file, OwnedModule(device_.handle(), made)).first->second;
}

VkPipelineLayout Pipelines::layout(const LayoutDesc& desc) {
  std::vector<uint64_t> key{reinterpret_cast<uint64_t>(desc.second_set)};
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const auto& [slot, type] : desc.bindings) {
    key.insert(key.end(), {slot, uint64_t(type)});
    bindings.push_back({slot, type, 1, VK_SHADER_STAGE_ALL, nullptr});
  }
  if (const auto found = layouts_.find(key); found != layouts_.end()) return found->second.layout;

  const VkDescriptorSetLayoutCreateInfo set{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                            .flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR,
                                            .bindingCount = uint32_t(bindings.size()),
                                            .pBindings = bindings.data()};
  VkDescriptorSetLayout first = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device_.handle(), &set, nullptr, &first), "making a descriptor layout");
  OwnedSetLayout owned(device_.handle(), first);
  const VkDescriptorSetLayout sets[] = {first, desc.second_set};
  const VkPushConstantRange push{VK_SHADER_STAGE_ALL, 0, push_constant_bytes};
  const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                        .setLayoutCount = desc.second_set == VK_NULL_HANDLE ? 1u : 2u,
                                        .pSetLayouts = sets,
                                        .pushConstantRangeCount = 1,
                                        .pPushConstantRanges = &push};
  VkPipelineLayout made = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device_.handle(), &info, nullptr, &made), "making a pipeline layout");
  return layouts_.emplace(key, Layout{std::move(owned), OwnedLayout(device_.handle(), made)})
      .first->second.layout;
}

VkPipeline Pipelines::compute(const std::string& shader, const std::vector<uint32_t>& constants,
                              VkPipelineLayout layout) {
  const std::string key = key_of(shader, list_of(constants), layout);
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second;
  const Specialization special(constants);
  const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                         .stage =
                                             stage(VK_SHADER_STAGE_COMPUTE_BIT, module(shader), special.info),
                                         .layout = layout};
  VkPipeline made = VK_NULL_HANDLE;
  check(vkCreateComputePipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &made),
        "making a pipeline");
  return pipelines_.emplace(key, OwnedPipeline(device_.handle(), made)).first->second;
}

namespace {

VkPipelineDepthStencilStateCreateInfo depth_state(const GraphicsDesc& desc) {
  const VkStencilOpState write{.failOp = VK_STENCIL_OP_KEEP,
                               .passOp = VK_STENCIL_OP_REPLACE,
                               .depthFailOp = VK_STENCIL_OP_KEEP,
                               .compareOp = VK_COMPARE_OP_ALWAYS,
                               .writeMask = 0xff};
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
          .depthTestEnable = VK_TRUE,
          .depthWriteEnable = desc.writes_depth,
          .depthCompareOp = desc.compare,
          .stencilTestEnable = desc.writes_stencil,
          .front = write,
          .back = write};
}

/// An attachment that is left out is not written.
VkPipelineColorBlendAttachmentState blend_state(bool blends, VkFormat format) {
  constexpr VkColorComponentFlags all = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                        VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  return {.blendEnable = blends, // premultiplied
          .srcColorBlendFactor = VK_BLEND_FACTOR_ONE,
          .dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
          .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
          .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
          .colorWriteMask = format == VK_FORMAT_UNDEFINED ? 0 : all};
}

std::string graphics_key(const GraphicsDesc& d, VkPipelineLayout layout) {
  return key_of(d.vertex, d.fragment, list_of(d.constants), list_of(d.colours), d.depth, d.writes_depth,
                d.writes_stencil, d.blends, d.compare, d.depth_bias, d.depth_bias_slope, layout);
}

} // namespace

VkPipeline Pipelines::graphics(const GraphicsDesc& desc, VkPipelineLayout layout) {
  const std::string key = graphics_key(desc, layout);
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second;
  const Specialization special(desc.constants);
  std::vector<VkPipelineShaderStageCreateInfo> stages{
      stage(VK_SHADER_STAGE_VERTEX_BIT, module(desc.vertex), special.info)};
  if (!desc.fragment.empty())
    stages.push_back(stage(VK_SHADER_STAGE_FRAGMENT_BIT, module(desc.fragment), special.info));
  const VkPipelineVertexInputStateCreateInfo vertices{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
      .vertexBindingDescriptionCount = desc.vertex_attributes.empty() ? 0u : 1u,
      .pVertexBindingDescriptions = &desc.vertex_binding,
      .vertexAttributeDescriptionCount = uint32_t(desc.vertex_attributes.size()),
      .pVertexAttributeDescriptions = desc.vertex_attributes.data()};
  const VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
      .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
  const VkPipelineViewportStateCreateInfo viewport{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
  const VkPipelineRasterizationStateCreateInfo raster{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .polygonMode = VK_POLYGON_MODE_FILL,
      .depthBiasEnable = desc.depth_bias != 0 || desc.depth_bias_slope != 0,
      .depthBiasConstantFactor = desc.depth_bias,
      .depthBiasSlopeFactor = desc.depth_bias_slope,
      .lineWidth = 1};
  const VkPipelineMultisampleStateCreateInfo samples{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
      .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
  const VkPipelineDepthStencilStateCreateInfo depth = depth_state(desc);
  std::vector<VkPipelineColorBlendAttachmentState> blends;
  for (const VkFormat format : desc.colours) blends.push_back(blend_state(desc.blends, format));
  const VkPipelineColorBlendStateCreateInfo blending{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
      .attachmentCount = uint32_t(blends.size()),
      .pAttachments = blends.data()};
  constexpr VkDynamicState dynamic[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                        VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE,
                                        VK_DYNAMIC_STATE_STENCIL_REFERENCE};
  const VkPipelineDynamicStateCreateInfo dynamics{.sType =
                                                      VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
                                                  .dynamicStateCount = 5,
                                                  .pDynamicStates = dynamic};
  const VkPipelineRenderingCreateInfo rendering{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
      .colorAttachmentCount = uint32_t(desc.colours.size()),
      .pColorAttachmentFormats = desc.colours.data(),
      .depthAttachmentFormat = desc.depth,
      .stencilAttachmentFormat = has_stencil(desc.depth) ? desc.depth : VK_FORMAT_UNDEFINED};
  const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                          .pNext = &rendering,
                                          .stageCount = uint32_t(stages.size()),
                                          .pStages = stages.data(),
                                          .pVertexInputState = &vertices,
                                          .pInputAssemblyState = &assembly,
                                          .pViewportState = &viewport,
                                          .pRasterizationState = &raster,
                                          .pMultisampleState = &samples,
                                          .pDepthStencilState = &depth,
                                          .pColorBlendState = &blending,
                                          .pDynamicState = &dynamics,
                                          .layout = layout};
  VkPipeline made = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &made),
        "making a pipeline");
  return pipelines_.emplace(key, OwnedPipeline(device_.handle(), made)).first->second;
}

} // namespace unghost
