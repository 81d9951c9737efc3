// Carries out a frame graph: images out of a pool, barriers as planned, passes labelled and timed by their
// names.
#pragma once

#include <memory>

#include "renderer/gpu/frame_memory.h"
#include "renderer/gpu/frame_plan.h"
#include "renderer/gpu/pipelines.h"

namespace unghost {

/// What a full-screen pass ran: a shader, and its specialization constants 0, 1, ...
struct Dispatched {
  std::string shader;
  std::vector<uint32_t> constants;
};

struct PassTime {
  std::string name;
  double ms = 0;
  uint64_t image_bytes = 0; // of the images that it is the first to touch
  Dispatched dispatched;    // nothing for a pass that draws or copies
};

struct RunResult {
  std::vector<PassTime> passes;
  std::vector<std::vector<std::byte>> readbacks; // in the order they were asked for, rows without padding
  uint64_t image_bytes = 0;                      // all images that this frame touches
};

class GraphRunner {
public:
  GraphRunner(Device& device, std::filesystem::path shaders);

  FrameMemory& memory() { return memory_; }
  KeptImages& kept() { return kept_; }
  /// Runs the graph and waits for it. Frame memory is given back.
  RunResult run(const FrameGraph& graph);

private:
  friend class PassCommands;
  /// An image in the pool; `key` is that of a kept image, else empty.
  struct Place {
    GpuImageDesc desc;
    std::string key;
    std::unique_ptr<GpuImage> image;
    bool taken = false;
    uint64_t last_frame = 0;
  };

  std::vector<uint32_t> assign(const FrameGraph& graph, const FramePlan& plan);
  uint32_t place_for(const FrameGraph::GraphImage& image, const PlannedImage& planned, uint64_t frame);
  void clear_neutral(uint32_t place);
  void forget_unused(uint64_t frame);
  void prepare_queries(size_t count);
  void collect(const FrameGraph& graph, const FramePlan& plan, const std::vector<uint32_t>& places,
               RunResult& result);

  Device& device_;
  Pipelines pipelines_;
  FrameMemory memory_;
  KeptImages kept_;
  OwnedSampler linear_;
  std::vector<Place> pool_;
  std::vector<ImageState> states_; // of the pool's images
  OwnedQueryPool queries_;
  size_t query_count_ = 0;
  std::vector<std::unique_ptr<GpuBuffer>> readbacks_;
};

/// What a pass may do while it is recorded.
class PassCommands {
public:
  struct Context {
    GraphRunner& runner;
    const FrameGraph& graph;
    const FramePlan& plan;
    const std::vector<uint32_t>& places;
  };
  PassCommands(const Context& context, const Pass& pass, VkCommandBuffer commands);

  VkCommandBuffer commands() const { return commands_; }
  /// Whether anybody reads what the pass could write there.
  bool live(ImageRef image) const { return bool(image) && context_.plan.images[image.index].live; }
  VkImage image(ImageRef image) const;
  void dispatch(const ComputePass& pass);
  void read_back(size_t place);

  /// Between `begin_rendering` and `end_rendering`: the pass's attachments, live ones only.
  void begin_rendering();
  void end_rendering();
  std::vector<VkFormat> colour_formats() const;
  VkFormat depth_format() const;
  /// Binds a pipeline whose set 0 are the pass's bindings, and set 1 of the layout given.
  void bind(const GraphicsDesc& desc, VkDescriptorSetLayout second_set);
  void bind_second_set(VkDescriptorSet set);
  void push(std::span<const std::byte> bytes);
  const Dispatched& dispatched() const { return dispatched_; }

private:
  VkPipelineLayout layout(VkDescriptorSetLayout second_set) const;
  void push_bindings(VkPipelineBindPoint point, VkPipelineLayout layout);
  const GpuImage* placed(ImageRef image) const;

  Context context_;
  const Pass& pass_;
  VkCommandBuffer commands_;
  VkPipelineLayout bound_ = VK_NULL_HANDLE;
  Dispatched dispatched_;
};

} // namespace unghost
