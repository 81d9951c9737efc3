// Carries out a frame graph: images out of a pool, barriers as planned, passes labelled and timed by their
// names.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "renderer/gpu/frame_memory.h"
#include "renderer/gpu/frame_plan.h"
#include "renderer/gpu/pipelines.h"

namespace unghost {

struct RunResult {
  std::vector<PassReport> passes;
  std::vector<UsedImage> images; // all that this frame touches, each once
  std::vector<LeftOut> left_out;
  std::vector<std::vector<std::byte>> readbacks; // in the order they were asked for, rows without padding
  uint64_t image_bytes = 0;                      // of all its images
};

class GraphRunner {
public:
  GraphRunner(Device& device, std::filesystem::path shaders);
  ~GraphRunner();
  GraphRunner(const GraphRunner&) = delete;
  GraphRunner& operator=(const GraphRunner&) = delete;

  /// Waits for the frame that had the next frame's memory before. Returns what came of it, where it was
  /// submitted and not asked for since.
  std::optional<RunResult> make_room();
  /// The next frame's; after `make_room`.
  FrameMemory& memory() { return flights_[next_].memory; }
  KeptImages& kept() { return kept_; }
  /// As Pipelines has it. What was drawn with other shaders is then forgotten.
  void reload_shaders();
  /// Submits the graph, and goes on to the next frame's memory.
  void submit(const FrameGraph& graph, const SubmitSync& sync = {});
  /// Waits for what was submitted last.
  RunResult finish();
  /// Submits the graph and waits for it.
  RunResult run(const FrameGraph& graph) {
    submit(graph);
    return finish();
  }

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

  /// What belongs to one of the frames that are on their way.
  struct Flight {
    explicit Flight(const Device& device) : memory(device) {}

    FrameMemory memory;
    OwnedQueryPool queries;
    size_t query_count = 0;
    std::vector<std::unique_ptr<GpuBuffer>> readbacks;
    std::vector<size_t> readback_bytes;              // how much of each is filled
    std::vector<std::unique_ptr<GpuImage>> replaced; // that the frame before may still use
    std::optional<RunResult> result;                 // all but times and readbacks, until it is waited for
  };

  std::vector<uint32_t> assign(const FrameGraph& graph, const FramePlan& plan);
  uint32_t place_for(const FrameGraph::GraphImage& image, const PlannedImage& planned, uint64_t frame);
  void clear_neutral(uint32_t place);
  void forget_unused(uint64_t frame);
  void replace(Place& place, Place with);
  void prepare_queries(Flight& flight, size_t count) const;
  std::optional<RunResult> land(size_t flight);
  std::vector<PassImage> images_of(const FrameGraph& graph, const FramePlan& plan,
                                   const std::vector<uint32_t>& places, const Pass& pass) const;
  void count_images(const FrameGraph& graph, const FramePlan& plan, const std::vector<uint32_t>& places,
                    RunResult& result) const;

  Device& device_;
  Pipelines pipelines_;
  KeptImages kept_;
  OwnedSampler linear_;
  std::vector<Place> pool_;
  std::vector<ImageState> states_; // of the pool's images
  std::array<Flight, frames_in_flight> flights_;
  size_t next_ = 0; // of the flights
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
  /// The same of its stencil alone.
  bool stencil_live(ImageRef image) const;
  VkImage image(ImageRef image) const;
  void dispatch(const ComputePass& pass);
  void copy(ImageRef from, ImageRef to, const VkRect2D& part);
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
  /// After `bind` and `push`.
  void draw_indexed(uint32_t indices, uint32_t first_index, uint32_t first_vertex, uint32_t instance);
  const std::vector<UsedPipeline>& used() const { return used_; }

private:
  VkPipelineLayout layout(VkDescriptorSetLayout second_set) const;
  void push_bindings(VkPipelineBindPoint point, VkPipelineLayout layout);
  const GpuImage* placed(ImageRef image) const;
  void note(const std::string& shader, const std::vector<uint32_t>& constants, const Pipeline& pipeline);

  Context context_;
  const Pass& pass_;
  VkCommandBuffer commands_;
  VkPipelineLayout bound_ = VK_NULL_HANDLE;
  std::vector<UsedPipeline> used_;
  size_t bound_pipeline_ = 0; // index into `used_`
};

} // namespace unghost
