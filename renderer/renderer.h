// The renderer: a scene on a device, and frames out of it.
#pragma once

#include <filesystem>
#include <memory>

#include "renderer/frame_input.h"

namespace unghost {

class Device;
class Swapchain;

class Renderer {
public:
  /// `shaders`: the folder with the compiled shaders. The scene is uploaded here; it throws what the device
  /// throws.
  Renderer(Device& device, const std::filesystem::path& shaders, Scene scene);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  const Scene& scene() const;
  /// Draws one frame, waits for it, and brings what was wanted. Histories go on from the frame before unless
  /// `input.cut`, another size or another policy at that place in the list of modes makes them invalid.
  FrameResult render(const FrameInput& input);
  /// Draws one frame into the window and does not wait for it. Returns what came of an earlier frame, where
  /// that is known by now: nothing of this one, and of a frame that was not drawn since the window has
  /// changed.
  std::optional<FrameResult> show(const FrameInput& input, Swapchain& window);
  /// That were drawn so far: render() adds one, and show() but where the window has changed.
  uint64_t frames() const;
  /// The displays of the frame that was shown last once more, composed in another way or the same; nothing is
  /// drawn, and no history goes on.
  void show_again(const ScreenInput& screen, Swapchain& window);
  /// A pixel of the frame that was drawn last, which is drawn once more for it, and leaves behind what it
  /// did. Nothing where that was not shown, or has no such pixel.
  std::optional<ProbedPixel> probe_again(const ProbeInput& probe);
  /// What that shows, brought to the host. A frame must have been shown.
  Image picture_again(const ScreenInput& screen);
  /// Whether there is such a frame.
  bool has_shown() const;
  /// Reads the folder with the compiled shaders again; the next frame is a cut. Throws std::runtime_error
  /// where one of them is not what was built, and what the device throws; then all goes on as it was.
  void reload_shaders();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace unghost
