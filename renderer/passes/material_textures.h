// The pictures of a scene's materials on the device: images with mips, samplers, a descriptor set a material.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "renderer/gpu/image.h"
#include "renderer/scene/scene.h"
#include "shaders/shared/frame.h"

namespace unghost {

static_assert(std::size(material_textures) == MATERIAL_TEXTURES);

class MaterialTextures {
public:
  MaterialTextures(Device& device, const Scene& scene);

  VkDescriptorSetLayout layout() const { return layout_; }
  VkDescriptorSet set(uint32_t material) const { return sets_[material]; }

private:
  /// An image is on the device once for each way that it is read.
  struct ImageKey {
    int image;
    bool srgb;
    auto operator<=>(const ImageKey&) const = default;
  };
  const GpuImage& image(Device& device, const Scene& scene, ImageKey key);
  VkSampler sampler(const Device& device, const TextureUse& use);

  std::map<ImageKey, std::unique_ptr<GpuImage>> images_;
  std::map<std::array<int, 5>, OwnedSampler> samplers_;
  OwnedSetLayout layout_;
  OwnedDescriptorPool pool_;
  std::vector<VkDescriptorSet> sets_;
};

} // namespace unghost
