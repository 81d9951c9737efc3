#include "renderer/renderer.h"

#include "renderer/deliver.h"
#include "renderer/frame.h"

namespace unghost {

struct Renderer::Parts {
  Parts(Device& device, const std::filesystem::path& shaders, Scene what)
      : scene(std::move(what)), gpu(device, scene), runner(device, shaders),
        largest_side(device.largest_image_side()) {}

  Scene scene;
  GpuScene gpu;
  GraphRunner runner;
  uint64_t frame = 0;
  LastFrame last;
  uint32_t largest_side;
};

Renderer::Renderer(Device& device, const std::filesystem::path& shaders, Scene scene)
    : parts_(std::make_unique<Parts>(device, shaders, std::move(scene))) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Scene& Renderer::scene() const { return parts_->scene; }

FrameResult Renderer::render(const FrameInput& input) {
  if (const uint32_t most = parts_->largest_side; input.width > most || input.height > most)
    throw GpuError(GpuFault::out_of_memory, "this device draws pictures of at most " + std::to_string(most) +
                                                " pixels a side; try a smaller --size");
  GraphRunner& runner = parts_->runner;
  FrameGraph graph(runner.kept(), parts_->frame++, {input.settings.keep_all, input.left_out});
  const FrameSetup setup =
      describe_frame(graph, input, parts_->scene, parts_->gpu, runner.memory(), parts_->last);
  const FrameImages images = declare_frame(graph, setup.contexts, setup.geometry_of);
  for (const Wanted& wanted : input.wanted) ask(graph, images, wanted);
  if (input.shown) graph.want(images.modes.front().display);
  RunResult run = runner.run(graph);

  FrameResult result{.delivered = {},
                     .passes = std::move(run.passes),
                     .images = std::move(run.images),
                     .left_out = std::move(run.left_out),
                     .image_bytes = run.image_bytes};
  for (size_t i = 0; i < input.wanted.size(); ++i)
    result.delivered.push_back(deliver(input, input.wanted[i].what, run.readbacks[i]));
  return result;
}

} // namespace unghost
