#include "renderer/renderer.h"

#include <algorithm>
#include <deque>

#include "renderer/deliver.h"
#include "renderer/frame.h"
#include "renderer/gpu/graph_runner.h"
#include "renderer/gpu/swapchain.h"
#include "renderer/probing.h"

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
  std::deque<std::optional<FrameInput>> in_flight; // those of which nothing has come yet; shown again: none

  struct Shown {
    FrameInput input;
    LastFrame before; // what it began with
  };
  std::optional<Shown> shown; // the last frame, where it was shown
  size_t kept_displays = 0;   // of the last frame that was shown
  ImageDesc displays_desc;

  void submit(const FrameInput& input, const Swapchain* window);
  void keep_displays(FrameGraph& graph, const FrameImages& images);
  /// Of the frame that it is still: no history goes on.
  FrameGraph graph_again() { return FrameGraph(runner.kept(), frame - 1); }
  ImageRef compose_again(FrameGraph& graph, const ScreenInput& screen) const;
};

namespace {

FrameResult result_of(const FrameInput& input, RunResult run) {
  FrameResult result{.delivered = {},
                     .passes = std::move(run.passes),
                     .images = std::move(run.images),
                     .left_out = std::move(run.left_out),
                     .image_bytes = run.image_bytes};
  for (size_t i = 0; i < input.wanted.size(); ++i)
    result.delivered.push_back(deliver(input, input.wanted[i].what, run.readbacks[i]));
  if (input.probe) result.probe = probed(input, std::span(run.readbacks).last(probe_readbacks(input)));
  return result;
}

/// The last pass of a frame: out of the graph, into the window.
void present(FrameGraph& graph, ImageRef screen, const Swapchain& window) {
  graph.pass({.name = "present",
              .kind = PassKind::transfer,
              .transfers = {{screen, Use::transfer_source}},
              .root = true,
              .record = [&window, screen, size = graph.desc(screen).extent](PassCommands& pass) {
                window.record(pass.commands(), pass.image(screen), size);
              }});
}

/// A copy of what a mode displays, so that a frame can be composed again when it is long over.
Cache kept_display(FrameGraph& graph, size_t mode, ImageDesc desc) {
  desc.name = "shown " + std::to_string(mode);
  return graph.cache(desc.name, desc, 0);
}

} // namespace

void Renderer::Parts::keep_displays(FrameGraph& graph, const FrameImages& images) {
  displays_desc = graph.desc(images.modes.front().display);
  kept_displays = images.modes.size();
  for (size_t mode = 0; mode < kept_displays; ++mode)
    graph.copy({.name = "keep what is shown",
                .from = images.modes[mode].display,
                .to = kept_display(graph, mode, displays_desc).image,
                .root = true});
}

void Renderer::Parts::submit(const FrameInput& input, const Swapchain* window) {
  const ScreenInput screen = input.screen.value_or(ScreenInput{.width = 1, .height = 1});
  if (const uint32_t most = largest_side;
      std::max({input.width, input.height, screen.width, screen.height}) > most)
    throw GpuError(GpuFault::out_of_memory, "this device draws pictures of at most " + std::to_string(most) +
                                                " pixels a side; try a smaller --size");
  shown.reset();
  if (window != nullptr) shown = {input, last};
  FrameGraph graph(runner.kept(), frame++, {input.settings.keep_all, input.left_out});
  const FrameSetup setup = describe_frame(graph, input, scene, gpu, runner.memory(), last);
  const FrameImages images = declare_frame(graph, setup.contexts, setup.geometry_of);
  for (const Wanted& wanted : input.wanted) ask(graph, images, wanted);
  if (input.probe) ask_probe(graph, images, input);
  const ImageRef seen = images.screen ? images.screen : images.modes.front().display;
  if (input.shown) graph.want(seen);
  if (window != nullptr) {
    keep_displays(graph, images);
    present(graph, seen, *window);
  }
  runner.submit(graph, window != nullptr ? window->sync() : SubmitSync{});
}

ImageRef Renderer::Parts::compose_again(FrameGraph& graph, const ScreenInput& screen) const {
  std::vector<ImageRef> displays;
  for (size_t mode = 0; mode < kept_displays; ++mode)
    displays.push_back(kept_display(graph, mode, displays_desc).image);
  return compose(graph, screen, displays);
}

Renderer::Renderer(Device& device, const std::filesystem::path& shaders, Scene scene)
    : parts_(std::make_unique<Parts>(device, shaders, std::move(scene))) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Scene& Renderer::scene() const { return parts_->scene; }

FrameResult Renderer::render(const FrameInput& input) {
  if (parts_->runner.make_room()) parts_->in_flight.pop_front(); // whoever shows frames asks no more
  parts_->submit(input, nullptr);
  return result_of(input, parts_->runner.finish());
}

std::optional<FrameResult> Renderer::show(const FrameInput& input, Swapchain& window) {
  std::optional<FrameResult> landed;
  if (std::optional<RunResult> run = parts_->runner.make_room()) {
    const std::optional<FrameInput> drawn = std::move(parts_->in_flight.front());
    parts_->in_flight.pop_front();
    if (drawn) landed = result_of(*drawn, std::move(*run)); // else it was shown again
  }
  if (!window.acquire()) return landed;
  parts_->submit(input, &window);
  parts_->in_flight.push_back(input);
  window.present();
  return landed;
}

void Renderer::show_again(const ScreenInput& screen, Swapchain& window) {
  if (parts_->runner.make_room()) parts_->in_flight.pop_front();
  if (parts_->kept_displays == 0 || !window.acquire()) return;
  FrameGraph graph = parts_->graph_again();
  present(graph, parts_->compose_again(graph, screen), window);
  parts_->runner.submit(graph, window.sync());
  parts_->in_flight.emplace_back();
  window.present();
}

uint64_t Renderer::frames() const { return parts_->frame; }

bool Renderer::has_shown() const { return parts_->kept_displays > 0; }

void Renderer::reload_shaders() {
  parts_->runner.reload_shaders();
  parts_->kept_displays = 0;
  parts_->shown.reset();
}

std::optional<ProbedPixel> Renderer::probe_again(const ProbeInput& probe) {
  if (!parts_->shown || probe.mode >= parts_->shown->input.modes.size()) return {};
  if (parts_->runner.make_room()) parts_->in_flight.pop_front();
  FrameInput input = parts_->shown->input;
  if (probe.x >= input.width || probe.y >= input.height) return {};
  input.wanted.clear(), input.screen.reset();
  input.shown = input.timed = false;
  input.probe = probe;
  // As it was drawn: from the histories that it read, which are kept until the next frame.
  LastFrame last = parts_->shown->before;
  FrameGraph graph(parts_->runner.kept(), parts_->frame - 1, {input.settings.keep_all, input.left_out});
  const FrameSetup setup =
      describe_frame(graph, input, parts_->scene, parts_->gpu, parts_->runner.memory(), last);
  ask_probe(graph, declare_frame(graph, setup.contexts, setup.geometry_of), input);
  return probed(input, parts_->runner.run(graph).readbacks);
}

Image Renderer::picture_again(const ScreenInput& screen) {
  if (parts_->runner.make_room()) parts_->in_flight.pop_front();
  FrameGraph graph = parts_->graph_again();
  graph.read_back(parts_->compose_again(graph, screen), VK_IMAGE_ASPECT_COLOR_BIT);
  FrameInput input;
  input.screen = screen;
  return deliver(input, Output::screen, parts_->runner.run(graph).readbacks[0]).picture;
}

} // namespace unghost
