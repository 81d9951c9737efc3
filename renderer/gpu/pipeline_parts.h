// What compute and graphics pipelines are put together from.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "renderer/gpu/vk.h"

namespace unghost {

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

inline VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits bit, VkShaderModule module) {
  return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
          .stage = bit,
          .module = module,
          .pName = "main"};
}

} // namespace unghost
