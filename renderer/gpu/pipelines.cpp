#include "renderer/gpu/pipelines.h"

#include <algorithm>

#include "renderer/gpu/pipeline_parts.h"
#include "renderer/gpu/shader_contents.h"
#include "renderer/gpu/specialize.h"

namespace unghost {

Pipelines::Pipelines(const Device& device, std::filesystem::path shaders)
    : device_(device), shaders_(std::move(shaders)) {}

void Pipelines::reload() {
  ShaderFiles now(shaders_.folder());
  now.read_all();
  std::map<std::string, Pipeline> others;
  for (const auto& [key, kept] : pipelines_)
    if (std::ranges::any_of(kept.shaders,
                            [&](const std::string& file) { return now.spirv(file) != shaders_.spirv(file); }))
      others.emplace(key, kept.make(now));
  device_.wait_idle();
  for (auto& [key, other] : others) pipelines_.at(key).pipeline = std::move(other);
  shaders_ = std::move(now);
}

const Pipeline& Pipelines::keep(const std::string& key, std::vector<std::string> shaders, MakePipeline make) {
  Pipeline made = make(shaders_);
  return pipelines_.emplace(key, Kept{std::move(made), std::move(shaders), std::move(make)})
      .first->second.pipeline;
}

OwnedModule Pipelines::module(ShaderFiles& shaders, const std::string& file,
                              const std::vector<uint32_t>& constants, Pipeline& pipeline) const {
  const std::vector<uint32_t> words = specialized(shaders.spirv(file), constants);
  const ShaderContents contents = contents_of(words);
  pipeline.instructions += contents.instructions;
  pipeline.fetches += uint32_t(contents.fetches());
  const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                      .codeSize = words.size() * 4,
                                      .pCode = words.data()};
  VkShaderModule made = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device_.handle(), &info, nullptr, &made), "loading a shader");
  return OwnedModule(device_.handle(), made);
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

const Pipeline& Pipelines::compute(const std::string& shader, const std::vector<uint32_t>& constants,
                                   VkPipelineLayout layout) {
  const std::string key = key_of(shader, list_of(constants), layout);
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second.pipeline;
  return keep(key, {shader}, [=, this](ShaderFiles& shaders) {
    Pipeline pipeline;
    const OwnedModule code = module(shaders, shader, constants, pipeline);
    const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                           .stage = stage(VK_SHADER_STAGE_COMPUTE_BIT, code),
                                           .layout = layout};
    VkPipeline made = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &made),
          "making a pipeline");
    pipeline.handle = {device_.handle(), made};
    return pipeline;
  });
}

} // namespace unghost
