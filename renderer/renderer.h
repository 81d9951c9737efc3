// The renderer: a scene on a device, and frames out of it.
#pragma once

#include <filesystem>
#include <memory>

#include "renderer/frame_input.h"

namespace unghost {

class Device;

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

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace unghost
