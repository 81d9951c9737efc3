// What a declared frame comes down to: which passes run, which images exist, and which barriers stand between
// them. A pure function, so that it is tested without a device.
#pragma once

#include "renderer/gpu/frame_graph.h"

namespace unghost {

/// What a use means to Vulkan.
struct UseFacts {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkImageUsageFlags usage = 0;
  bool reads = false, writes = false;
};
UseFacts facts_of(Use use, PassKind kind, VkFormat format);

/// Who touched an image last; carried from frame to frame for images that stay.
struct ImageState {
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  VkPipelineStageFlags2 written_in = 0;
  VkAccessFlags2 write_access = 0;
  VkPipelineStageFlags2 read_in = 0; // since the last write
  VkAccessFlags2 read_access = 0;    // that have been made able to see it
};

struct ImageBarrier {
  ImageRef image;
  VkPipelineStageFlags2 from_stages = 0, to_stages = 0;
  VkAccessFlags2 from_access = 0, to_access = 0;
  VkImageLayout from = VK_IMAGE_LAYOUT_UNDEFINED, to = VK_IMAGE_LAYOUT_UNDEFINED;
};

struct PlannedPass {
  size_t pass = 0;                    // index into FrameGraph::passes()
  std::vector<ImageBarrier> barriers; // before it
};

struct PlannedImage {
  bool needed = false; // it exists: a pass that runs touches it, and not as an attachment for nobody
  bool live = false;   // somebody reads it, or wants it: as large as declared, else 1x1
  VkImageUsageFlags usage = 0;
  size_t first_pass = 0, last_pass = 0; // places in FramePlan::passes
};

struct FramePlan {
  std::vector<PlannedPass> passes;
  std::vector<PlannedImage> images; // as many as the graph's
};

/// Culls backwards from what is wanted; where everything is kept, from every image there is. A raster pass
/// keeps running without those attachments that nobody reads; a compute pass writes them to 1x1 images.
FramePlan cull(const FrameGraph& graph);
/// What was declared and is not made because nobody reads it: passes, and images of the passes that run.
std::vector<LeftOut> unread(const FrameGraph& graph, const FramePlan& plan);
/// What a pass does with an image, all its uses joined; `reads` also where it adds to what was there.
struct TouchedImage {
  ImageRef image;
  bool reads = false, writes = false;
};
std::vector<TouchedImage> touched_by(const FrameGraph& graph, const Pass& pass);
/// Fills in the barriers. `place[i]` is where graph image i lives, `states[place]` who touched that place
/// last: before the frame, and after it on return.
void derive_barriers(const FrameGraph& graph, FramePlan& plan, std::span<const uint32_t> place,
                     std::vector<ImageState>& states);
/// Writes down which kept images the plan's passes write.
void note_kept(const FrameGraph& graph, const FramePlan& plan);

} // namespace unghost
