// A resolve alone, on pictures made by hand: no scene, no camera, a rig of nothing but inputs.
#pragma once

#include <bit>
#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <random>

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include "app/paths.h"
#include "renderer/gpu/device.h"
#include "renderer/passes/passes.h"

namespace unghost {

/// What a resolve reads of one frame, row by row.
struct Inputs {
  uint32_t width = 16, height = 16;
  std::vector<glm::vec3> colours;
  std::vector<glm::vec2> motion;     // pixels
  std::vector<float> depth;          // reversed, near plane 0.1 m
  std::vector<float> expected_depth; // metres
  std::vector<uint32_t> objects;
  std::vector<uint8_t> tags;

  explicit Inputs(uint32_t w = 16, uint32_t h = 16)
      : width(w), height(h), colours(size_t(w) * h, glm::vec3(0.5f)), motion(colours.size()),
        depth(colours.size(), 0.01f), expected_depth(colours.size(), 10), objects(colours.size(), 1),
        tags(colours.size()) {}
};

class ResolveBench {
public:
  ResolveBench() { scene_.traits.tagged = true; }

  /// Resolves one more frame with each of the runs; what each makes of it, as the half floats hold it.
  std::vector<std::vector<glm::vec3>> resolve(const Inputs& inputs, const std::vector<ModeRun>& runs,
                                              bool cut) {
    FrameConstants constants{};
    constants.size_px = {inputs.width, inputs.height};
    constants.inverse_size_px = 1.0f / constants.size_px;
    constants.near_plane = 0.1f;
    FrameContext in{.scene = scene_,
                    .modes = runs,
                    .size = {inputs.width, inputs.height},
                    .index = frame_,
                    .cut = cut,
                    .constants = runner_.memory().push_value(constants),
                    .policy_changed = std::vector<uint8_t>(runs.size(), cut),
                    .tagged = {.deepest_m = 8, .length_m = 5}};
    FrameGraph graph(runner_.kept(), frame_++);
    uploads_.clear();
    const TaaInputs images = upload_all(graph, inputs);
    for (size_t place = 0; place < runs.size(); ++place)
      graph.read_back(resolve_taa(graph, in, images, place).colour, VK_IMAGE_ASPECT_COLOR_BIT);
    std::vector<std::vector<glm::vec3>> results;
    const RunResult run = runner_.run(graph);
    dispatched_.clear();
    for (const PassTime& pass : run.passes)
      if (!pass.dispatched.shader.empty()) dispatched_.push_back(pass.dispatched);
    for (const std::vector<std::byte>& bytes : run.readbacks) {
      std::vector<glm::vec3>& result = results.emplace_back();
      for (size_t i = 0; i < inputs.colours.size(); ++i) {
        uint64_t packed = 0;
        std::memcpy(&packed, bytes.data() + 8 * i, 8);
        result.emplace_back(glm::unpackHalf4x16(packed));
      }
    }
    return results;
  }
  /// What the last frame's resolves ran, in the order of the runs.
  const std::vector<Dispatched>& dispatched() const { return dispatched_; }
  std::filesystem::path shader_file(const std::string& shader) const {
    return data_.shaders / (shader + ".spv");
  }
  const std::vector<std::string>& messages() const { return device_.validation_messages(); }

private:
  using Aspects = std::vector<std::pair<VkImageAspectFlags, const GpuBuffer*>>;

  template <class T> const GpuBuffer* staged(const std::vector<T>& texels) {
    GpuBuffer& buffer =
        uploads_.emplace_back(device_, texels.size() * sizeof(T), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    std::memcpy(buffer.bytes().data(), texels.data(), texels.size() * sizeof(T));
    return &buffer;
  }
  ImageRef filled(FrameGraph& graph, VkFormat format, VkExtent2D size, const Aspects& aspects) {
    const ImageRef image = graph.image({.name = "uploaded", .format = format, .extent = size});
    graph.pass({.name = "upload",
                .kind = PassKind::transfer,
                .transfers = {{image, Use::transfer_destination}},
                .record = [aspects, image, size](PassCommands& commands) {
                  for (const auto& [aspect, buffer] : aspects) {
                    const VkBufferImageCopy region{.imageSubresource = {aspect, 0, 0, 1},
                                                   .imageExtent = {size.width, size.height, 1}};
                    vkCmdCopyBufferToImage(commands.commands(), buffer->buffer, commands.image(image),
                                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
                  }
                }});
    return image;
  }
  template <class T>
  ImageRef upload(FrameGraph& graph, const std::vector<T>& texels, VkFormat format, VkExtent2D size) {
    return filled(graph, format, size, {{VK_IMAGE_ASPECT_COLOR_BIT, staged(texels)}});
  }
  /// As the motion pass packs them.
  static std::vector<uint32_t> tagged(const Inputs& inputs) {
    std::vector<uint32_t> packed;
    for (size_t i = 0; i < inputs.depth.size(); ++i)
      packed.push_back((std::bit_cast<uint32_t>(inputs.depth[i]) & ~0xffu) | inputs.tags[i]);
    return packed;
  }
  TaaInputs upload_all(FrameGraph& graph, const Inputs& inputs) {
    const VkExtent2D size{inputs.width, inputs.height};
    std::vector<uint64_t> halves;
    for (const glm::vec3& c : inputs.colours) halves.push_back(glm::packHalf4x16(glm::vec4(c, 1)));
    TaaInputs images{};
    images.colour = upload(graph, halves, VK_FORMAT_R16G16B16A16_SFLOAT, size);
    images.motion.motion_px = upload(graph, inputs.motion, VK_FORMAT_R32G32_SFLOAT, size);
    images.motion.depth = upload(graph, inputs.depth, VK_FORMAT_R32_SFLOAT, size);
    images.motion.tagged_depth = upload(graph, tagged(inputs), VK_FORMAT_R32_SFLOAT, size);
    images.motion.previous_depth = upload(graph, inputs.expected_depth, VK_FORMAT_R32_SFLOAT, size);
    images.gbuffer.object = upload(graph, inputs.objects, VK_FORMAT_R32_UINT, size);
    images.gbuffer.depth = filled(graph, VK_FORMAT_D32_SFLOAT_S8_UINT, size,
                                  {{VK_IMAGE_ASPECT_DEPTH_BIT, staged(inputs.depth)},
                                   {VK_IMAGE_ASPECT_STENCIL_BIT, staged(inputs.tags)}});
    // what is read as depth has to be one that could be drawn to
    graph.pass({.name = "draw nothing",
                .kind = PassKind::raster,
                .attachments = {{.image = images.gbuffer.depth, .clear = {}, .use = Use::depth_attachment}},
                .record = [](PassCommands& commands) {
                  commands.begin_rendering();
                  commands.end_rendering();
                }});
    return images;
  }

  static Scene one_material() {
    Scene scene;
    scene.materials.emplace_back();
    return scene;
  }

  Device device_{{.validate = true}};
  DataFolders data_ = find_data_folders();
  GpuScene scene_{device_, one_material()};
  GraphRunner runner_{device_, data_.shaders};
  std::deque<GpuBuffer> uploads_;
  std::vector<Dispatched> dispatched_;
  uint64_t frame_ = 0;
};

/// A bench for each test, on which nothing may complain.
class ResolveBenchTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : bench.messages()) ADD_FAILURE() << message;
  }
  ResolveBench bench;
};

/// Numbers that a frame may hold, the extreme ones among them.
inline float any_number(std::mt19937& random, bool extreme) {
  static constexpr float limit = 65504, infinite = std::numeric_limits<float>::infinity();
  static constexpr float odd[] = {0, 1e-7f, 6e-5f, 1, limit, infinite, -infinite, -1, NAN};
  if (extreme && random() % 8 == 0) return odd[random() % std::size(odd)];
  return std::exp2(float(random() % 2000) / 200 - 7);
}

/// What a half float holds of it.
inline glm::dvec3 half(glm::vec3 c) {
  return glm::dvec3(glm::vec3(glm::unpackHalf4x16(glm::packHalf4x16(glm::vec4(c, 1)))));
}

} // namespace unghost
