#include "renderer/renderer.h"

#include "renderer/deliver.h"
#include "renderer/frame.h"

namespace unghost {

struct Renderer::Parts {
  Parts(Device& device, const std::filesystem::path& shaders, Scene what)
      : scene(std::move(what)), gpu(device, scene), runner(device, shaders) {}

  Scene scene;
  GpuScene gpu;
  GraphRunner runner;
  uint64_t frame = 0;
  std::vector<TaaPolicy> policies; // of the last frame, by place
};

Renderer::Renderer(Device& device, const std::filesystem::path& shaders, Scene scene)
    : parts_(std::make_unique<Parts>(device, shaders, std::move(scene))) {}

Renderer::~Renderer() = default;

const Scene& Renderer::scene() const { return parts_->scene; }

FrameResult Renderer::render(const FrameInput& input) {
  std::vector<uint8_t> changed;
  for (size_t i = 0; i < input.modes.size(); ++i)
    changed.push_back(i >= parts_->policies.size() || parts_->policies[i] != input.modes[i].taa.policy);
  parts_->policies.clear();
  for (const ModeRun& run : input.modes) parts_->policies.push_back(run.taa.policy);

  GraphRunner& runner = parts_->runner;
  const FrameSetup setup = describe_frame(input, parts_->scene, parts_->gpu, runner.memory(), changed);
  FrameGraph graph(runner.kept(), parts_->frame++);
  const FrameImages images = declare_frame(graph, setup.contexts, setup.geometry_of);
  for (const Wanted& wanted : input.wanted) ask(graph, images, wanted);
  RunResult run = runner.run(graph);

  FrameResult result;
  for (size_t i = 0; i < input.wanted.size(); ++i)
    result.delivered.push_back(deliver(input, input.wanted[i].what, run.readbacks[i]));
  for (PassTime& pass : run.passes)
    result.passes.push_back({.name = std::move(pass.name), .ms = pass.ms, .image_bytes = pass.image_bytes});
  return result;
}

} // namespace unghost
