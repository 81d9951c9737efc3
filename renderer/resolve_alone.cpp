#include "renderer/resolve_alone.h"

#include <bit>
#include <cstring>
#include <deque>

#include <glm/gtc/packing.hpp>

#include "renderer/gpu/device.h"
#include "renderer/passes/passes.h"
#include "shaders/shared/taa_key.h"

namespace unghost {
namespace {

constexpr float near_plane = 0.1f;

Scene one_material() {
  Scene scene;
  scene.materials.emplace_back();
  return scene;
}

/// As the motion pass packs them.
std::vector<uint32_t> tagged_depth(const ResolveInputs& inputs) {
  std::vector<uint32_t> packed;
  for (size_t i = 0; i < inputs.depth.size(); ++i)
    packed.push_back((std::bit_cast<uint32_t>(inputs.depth[i]) & ~0xffu) | inputs.tags[i]);
  return packed;
}

std::vector<uint32_t> keys(const ResolveInputs& inputs) {
  std::vector<uint32_t> packed;
  for (size_t i = 0; i < inputs.depth.size(); ++i) {
    const float zoom = inputs.expected_depth[i] * inputs.depth[i] / near_plane - 1;
    packed.push_back(key_of(inputs.depth[i], inputs.objects[i], light_word(inputs.light[i], true), zoom));
  }
  return packed;
}

std::vector<uint64_t> halves(const std::vector<glm::vec3>& colours) {
  std::vector<uint64_t> packed;
  for (const glm::vec3& c : colours) packed.push_back(glm::packHalf4x16(glm::vec4(c, 1)));
  return packed;
}

using Aspects = std::vector<std::pair<VkImageAspectFlags, const GpuBuffer*>>;

/// What one frame uploads; outlives its graph.
class Uploads {
public:
  Uploads(Device& device, FrameGraph& graph, VkExtent2D size) : device_(device), graph_(graph), size_(size) {}

  template <class T> ImageRef image(const std::vector<T>& texels, VkFormat format) {
    return filled(format, {{VK_IMAGE_ASPECT_COLOR_BIT, staged(texels)}});
  }

  ImageRef depth(const ResolveInputs& inputs) {
    const ImageRef image =
        filled(VK_FORMAT_D32_SFLOAT_S8_UINT, {{VK_IMAGE_ASPECT_DEPTH_BIT, staged(inputs.depth)},
                                              {VK_IMAGE_ASPECT_STENCIL_BIT, staged(inputs.tags)}});
    // what is read as depth has to be one that could be drawn to
    graph_.pass({.name = "draw nothing",
                 .kind = PassKind::raster,
                 .attachments = {{.image = image, .clear = {}, .use = Use::depth_attachment}},
                 .record = [](PassCommands& commands) {
                   commands.begin_rendering();
                   commands.end_rendering();
                 }});
    return image;
  }

  /// One pixel of an image that was written in this frame.
  void overwrite(ImageRef image, const HistoryFault& fault) {
    const std::vector<uint64_t> texel = halves({glm::vec3(fault.value)});
    const VkOffset3D offset{int32_t(fault.pixel % size_.width), int32_t(fault.pixel / size_.width), 0};
    copy(image, {{VK_IMAGE_ASPECT_COLOR_BIT, staged(texel)}}, offset, {1, 1});
  }

private:
  template <class T> const GpuBuffer* staged(const std::vector<T>& texels) {
    GpuBuffer& buffer =
        buffers_.emplace_back(device_, texels.size() * sizeof(T), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    std::memcpy(buffer.bytes().data(), texels.data(), texels.size() * sizeof(T));
    return &buffer;
  }
  ImageRef filled(VkFormat format, const Aspects& aspects) {
    const ImageRef image = graph_.image({.name = "uploaded", .format = format, .extent = size_});
    copy(image, aspects, {}, size_);
    return image;
  }
  void copy(ImageRef image, const Aspects& aspects, VkOffset3D offset, VkExtent2D extent) {
    graph_.pass({.name = "upload",
                 .kind = PassKind::transfer,
                 .transfers = {{image, Use::transfer_destination}},
                 .root = extent.width != size_.width || extent.height != size_.height, // into what is kept
                 .record = [=](PassCommands& commands) {
                   for (const auto& [aspect, buffer] : aspects) {
                     const VkBufferImageCopy region{.imageSubresource = {aspect, 0, 0, 1},
                                                    .imageOffset = offset,
                                                    .imageExtent = {extent.width, extent.height, 1}};
                     vkCmdCopyBufferToImage(commands.commands(), buffer->buffer, commands.image(image),
                                            VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
                   }
                 }});
  }

  Device& device_;
  FrameGraph& graph_;
  VkExtent2D size_;
  std::deque<GpuBuffer> buffers_;
};

TaaInputs uploaded(Uploads& uploads, const ResolveInputs& inputs) {
  TaaInputs images{};
  images.colour = uploads.image(halves(inputs.colours), VK_FORMAT_R16G16B16A16_SFLOAT);
  images.gbuffer.surfaces = images.gbuffer.tagged = images.gbuffer.lit = images.motion.moves = true;
  images.motion.motion_px = uploads.image(inputs.motion, VK_FORMAT_R32G32_SFLOAT);
  images.motion.depth = uploads.image(tagged_depth(inputs), VK_FORMAT_R32_SFLOAT);
  images.motion.previous_depth = uploads.image(inputs.expected_depth, VK_FORMAT_R32_SFLOAT);
  images.motion.key = uploads.image(keys(inputs), VK_FORMAT_R32_UINT);
  images.gbuffer.object = uploads.image(inputs.objects, VK_FORMAT_R32_UINT);
  images.gbuffer.depth = uploads.depth(inputs);
  return images;
}

std::vector<glm::vec3> unpacked(const std::vector<std::byte>& bytes) {
  std::vector<glm::vec3> colours;
  for (size_t at = 0; at < bytes.size(); at += 8) {
    uint64_t packed = 0;
    std::memcpy(&packed, bytes.data() + at, 8);
    colours.emplace_back(glm::unpackHalf4x16(packed));
  }
  return colours;
}

} // namespace

struct ResolveAlone::Parts {
  Parts(Device& on, const std::filesystem::path& shaders)
      : device(on), scene(on, one_material()), runner(on, shaders) {
    scene.traits.tagged = true;
  }

  RunResult run(const ResolveInputs& inputs, std::span<const ModeRun> runs, bool cut, bool brings,
                std::span<const HistoryFault> faults) {
    runner.make_room();
    since_cut = cut ? 0 : since_cut + 1; // so that the same pictures give the same bits
    FrameConstants constants{};
    constants.size_px = {inputs.width, inputs.height};
    constants.inverse_size_px = 1.0f / constants.size_px;
    constants.near_plane = near_plane;
    constants.jitter_px = inputs.jitter_px;
    const FrameContext in{.scene = scene,
                          .modes = runs,
                          .size = {inputs.width, inputs.height},
                          .index = since_cut,
                          .cut = cut,
                          .constants = runner.memory().push_value(constants),
                          .light_changes = true,
                          .mirrors_change = true,
                          .moved_ids = inputs.moved_ids,
                          .policy_changed = std::vector<uint8_t>(runs.size(), cut),
                          .tagged = {.deepest_m = 8, .length_m = 5}};
    FrameGraph graph(runner.kept(), frame++);
    Uploads uploads(device, graph, in.size);
    const TaaInputs images = uploaded(uploads, inputs);
    for (size_t place = 0; place < runs.size(); ++place) {
      const ImageRef colour = resolve_taa(graph, in, images, place).colour;
      if (brings) graph.read_back(colour, VK_IMAGE_ASPECT_COLOR_BIT);
      if (!brings) graph.want(colour);
      const TaaPolicy& policy = runs[place].taa.policy;
      if (!policy.needs_history() || policy.keeps != Keeps::result) continue;
      for (const HistoryFault& fault : faults) uploads.overwrite(colour, fault);
    }
    return runner.run(graph);
  }

  Device& device;
  GpuScene scene;
  GraphRunner runner;
  std::vector<UsedPipeline> ran;
  uint64_t frame = 0, since_cut = 0;
};

ResolveAlone::ResolveAlone(Device& device, const std::filesystem::path& shaders)
    : parts_(std::make_unique<Parts>(device, shaders)) {}

ResolveAlone::~ResolveAlone() = default;

std::vector<std::vector<glm::vec3>> ResolveAlone::resolve(const ResolveInputs& inputs,
                                                          std::span<const ModeRun> runs, bool cut,
                                                          std::span<const HistoryFault> faults) {
  const RunResult run = parts_->run(inputs, runs, cut, true, faults);
  parts_->ran.clear();
  for (const PassReport& pass : run.passes)
    parts_->ran.insert(parts_->ran.end(), pass.pipelines.begin(), pass.pipelines.end());
  std::vector<std::vector<glm::vec3>> results;
  for (const std::vector<std::byte>& bytes : run.readbacks) results.push_back(unpacked(bytes));
  return results;
}

void ResolveAlone::advance(const ResolveInputs& inputs, std::span<const ModeRun> runs, bool cut) {
  parts_->run(inputs, runs, cut, false, {});
}

const std::vector<UsedPipeline>& ResolveAlone::ran() const { return parts_->ran; }

} // namespace unghost
