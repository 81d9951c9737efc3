// The images of a window: a frame's picture is copied to one of them, an overlay is drawn above it, and it is
// shown.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "renderer/gpu/device.h"

namespace unghost {

class Swapchain {
public:
  /// Of the device's surface, which must have a size. Shown images are 8 bits a channel and hold what a
  /// display expects (sRGB): nothing is converted.
  explicit Swapchain(Device& device, VkExtent2D size);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  VkExtent2D extent() const { return extent_; }
  uint32_t images() const { return uint32_t(views_.size()); }
  /// What `overlay` draws in: one colour attachment that keeps what it holds.
  VkRenderPass overlay_pass() const { return pass_; }
  std::function<void(VkCommandBuffer)> overlay;
  uint32_t picture_x = 0; // where the picture begins, pixels; the overlay covers what lies to the left

  /// Makes the images anew; waits until nothing is at work. `size` is not read where the surface knows its
  /// own.
  void resize(VkExtent2D size);
  /// Whether there is an image to draw to; not so where the window has changed, which asks for `resize`.
  bool acquire();
  SubmitSync sync() const { return {.wait = acquired_[flight_], .signal = drawn_[image_]}; }
  /// Of the acquired image, in work that is submitted with `sync`.
  void record(VkCommandBuffer commands, VkImage picture, VkExtent2D picture_size) const;
  void present();

private:
  void create_images();
  VkImageMemoryBarrier2 barrier() const;

  Device& device_;
  VkSurfaceFormatKHR format_{};
  VkExtent2D extent_{};
  OwnedRenderPass pass_;
  OwnedSwapchain swapchain_;
  std::vector<VkImage> images_;
  std::vector<OwnedView> views_;
  std::vector<OwnedFramebuffer> framebuffers_;
  std::vector<OwnedSemaphore> drawn_; // an image each
  std::array<OwnedSemaphore, frames_in_flight> acquired_;
  size_t flight_ = 0;
  uint32_t image_ = 0;
};

} // namespace unghost
