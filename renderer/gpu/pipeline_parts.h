// What compute and graphics pipelines are put together from.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "renderer/gpu/vk.h"

namespace unghost {

/// Specialization constants 0, 1, ... of 32 bits each.
struct Specialization {
  explicit Specialization(const std::vector<uint32_t>& constants) {
    for (uint32_t i = 0; i < constants.size(); ++i) entries.push_back({i, i * 4, 4});
    info = {uint32_t(entries.size()), entries.data(), constants.size() * 4, constants.data()};
  }
  std::vector<VkSpecializationMapEntry> entries;
  VkSpecializationInfo info{};
};

/// A key out of everything that tells one pipeline from another.
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

inline VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits bit, VkShaderModule module,
                                             const VkSpecializationInfo& info) {
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
          .stage = bit,
          .module = module,
          .pName = "main",
          .pSpecializationInfo = &info};
}

} // namespace unghost
