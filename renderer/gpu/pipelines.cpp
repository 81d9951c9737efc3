#include "renderer/gpu/pipelines.h"

#include <fstream>

#include "renderer/gpu/pipeline_parts.h"
#include "renderer/gpu/sha256.h"
#include "renderer/gpu/shader_contents.h"
#include "renderer/gpu/specialize.h"

namespace unghost {
namespace {

constexpr const char* list_of_sums = "sums.txt"; // as sha256sum writes it

std::string read(const std::filesystem::path& file, const char* what) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream bytes;
  if (!in || !(bytes << in.rdbuf()))
    throw std::runtime_error(what + (" " + file.string()) + " is missing or empty; build again");
  return bytes.str();
}

std::map<std::string, std::string> read_sums(const std::filesystem::path& folder) {
  std::istringstream lines(read(folder / list_of_sums, "the list of shaders"));
  std::map<std::string, std::string> sums;
  for (std::string sum, file; lines >> sum >> file;) sums[file] = sum;
  return sums;
}

/// Drivers don't survive shaders that are damaged, nor does what makes them faster: they see those that were
/// built.
std::vector<uint32_t> read_spirv(const std::filesystem::path& file, const std::string& sum) {
  const std::string bytes = read(file, "the shader");
  if (Sha256::hex(bytes) != sum)
    throw std::runtime_error("the shader " + file.string() + " is not what was built; build again");
  std::vector<uint32_t> words(bytes.size() / sizeof(uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint32_t));
  return words;
}

} // namespace

Pipelines::Pipelines(const Device& device, std::filesystem::path shaders)
    : device_(device), shaders_(std::move(shaders)) {}

OwnedModule Pipelines::module(const std::string& file, const std::vector<uint32_t>& constants,
                              Pipeline& pipeline) {
  auto found = spirv_.find(file);
  if (found == spirv_.end()) {
    if (sums_.empty()) sums_ = read_sums(shaders_);
    const std::string name = file + ".spv";
    found = spirv_.emplace(file, read_spirv(shaders_ / name, sums_[name])).first;
  }
  const std::vector<uint32_t> words = specialized(found->second, constants);
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
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second;
  Pipeline pipeline;
  const OwnedModule code = module(shader, constants, pipeline);
  const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                         .stage = stage(VK_SHADER_STAGE_COMPUTE_BIT, code),
                                         .layout = layout};
  VkPipeline made = VK_NULL_HANDLE;
  check(vkCreateComputePipelines(device_.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &made),
        "making a pipeline");
  pipeline.handle = {device_.handle(), made};
  return pipelines_.emplace(key, std::move(pipeline)).first->second;
}

} // namespace unghost
