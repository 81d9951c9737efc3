// One frame as a list of passes, each with the images it reads and writes. Declaring is all that happens
// here: no Vulkan call is made. frame_plan.h decides what of it is needed, graph_runner.h does it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gpu/frame_report.h"
#include "renderer/gpu/image.h"
#include "shaders/shared/workgroup.h"

namespace unghost {

/// An image of this frame, by its place in the graph's list.
struct ImageRef {
  uint32_t index = ~0u;
  explicit operator bool() const { return index != ~0u; }
  bool operator==(const ImageRef&) const = default;
};

struct ImageDesc {
  std::string name;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{1, 1};
};

/// How a pass touches an image. The stage follows from the kind of the pass.
enum class Use : uint8_t {
  colour_attachment,
  depth_attachment, // tested and written
  sampled,          // colour, or depth's depth
  sampled_stencil,
  storage_read,
  storage_write,
  transfer_source,
  transfer_destination,
};

/// One entry of a pass's list: a descriptor, and where it is an image the declaration of its use, too.
struct Binding {
  uint32_t slot = 0;
  Use use = Use::sampled;
  ImageRef image;
  BufferSlice buffer;
  VkDescriptorType type = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
};

Binding sampled(uint32_t slot, ImageRef image);
Binding sampled_stencil(uint32_t slot, ImageRef image);
/// Read through a linear sampler that clamps to the edge.
Binding filtered(uint32_t slot, ImageRef image);
Binding storage_read(uint32_t slot, ImageRef image);
Binding storage_write(uint32_t slot, ImageRef image);
Binding uniform(uint32_t slot, BufferSlice buffer);
Binding buffer(uint32_t slot, BufferSlice buffer);

/// Without a clear value what was there is kept.
struct Attachment {
  ImageRef image;
  std::optional<VkClearValue> clear;
  Use use = Use::colour_attachment;
  bool together = false; // kept where any other attachment of the pass that says so is read
};

/// A specialization constant: a number, with bits that stand for images which the pass could write, set where
/// anybody reads them.
struct Constant {
  uint32_t value = 0;
  std::vector<std::pair<ImageRef, uint32_t>> if_live;

  Constant(uint32_t number) : value(number) {}
  Constant(ImageRef image) : if_live{{image, 1}} {}
  Constant(uint32_t number, std::vector<std::pair<ImageRef, uint32_t>> bits)
      : value(number), if_live(std::move(bits)) {}
};

enum class PassKind : uint8_t { compute, raster, transfer };

class PassCommands;

struct Pass {
  std::string name;
  PassKind kind = PassKind::compute;
  std::vector<Binding> bindings;
  std::vector<Attachment> attachments;
  std::vector<std::pair<ImageRef, Use>> transfers;
  bool patches = false; // transfers leave what is around them as it was
  bool root = false;    // runs in any case: what it does leaves the graph
  std::function<void(PassCommands&)> record;
};

/// A full-screen dispatch: the commonest pass.
struct ComputePass {
  std::string name;
  std::string shader;              // file name without .spv
  std::vector<Constant> constants; // constant_id 0, 1, ...
  std::vector<Binding> bindings;
  std::vector<std::byte> push;
  VkExtent2D cover;                                    // this many pixels
  VkExtent2D group{WORKGROUP_WIDTH, WORKGROUP_HEIGHT}; // of which a workgroup does so many
};

/// An image, or a part of it, into another of its format and size.
struct CopyPass {
  std::string name;
  ImageRef from, to;
  std::optional<VkRect2D> part; // to the same place
  bool root = false;
};

/// What outlives frames, by name: histories and caches. Knows what they are and whether they hold something;
/// the images themselves are the runner's.
struct KeptImage {
  ImageDesc desc;
  uint64_t frame = 0;   // when it was last written
  uint64_t version = 0; // of what it holds
};
using KeptImages = std::map<std::string, KeptImage>;
inline constexpr std::string_view neutral_prefix = "neutral ";

/// Last frame's image and this frame's. `previous` is a neutral image where it is not valid.
struct History {
  ImageRef previous, next;
  bool valid = false;
};

/// An image whose content stays from frame to frame until its version changes.
struct Cache {
  ImageRef image;
  bool valid = false;  // holds the version that was asked for: nothing has to write it
  bool recent = false; // was written in the frame before
};

class FrameGraph {
public:
  /// `kept` outlives the graph; frame counts up by 1 from frame to frame.
  FrameGraph(KeptImages& kept, uint64_t frame, Keeping keeping = {})
      : kept_(kept), frame_(frame), keeping_(std::move(keeping)) {}

  /// Whether `thing` is made: where it `is` needed, or where everything is kept. What is left out is written
  /// down. `images` are made for nothing else: where it is left out, they live only if somebody reads
  /// them.
  bool needed(bool is, const LeftOut& thing, std::initializer_list<ImageRef> images = {});

  ImageRef image(ImageDesc desc);
  /// 1x1 and zero: keeps a descriptor valid where there is nothing to read.
  ImageRef neutral(VkFormat format);
  /// Not valid in the first frame, after another desc, after a frame that did not write it, or where `reset`.
  History history(const std::string& key, ImageDesc desc, bool reset);
  Cache cache(const std::string& key, ImageDesc desc, uint64_t version);

  void pass(Pass pass) { passes_.push_back(std::move(pass)); }
  void compute(ComputePass pass);
  void copy(const CopyPass& pass);
  /// This image is what the frame is for.
  void want(ImageRef image) { wanted_.push_back(image); }
  /// Brings an aspect of the image, or a part of it, to the host; the answer is the place in the runner's
  /// list of readbacks.
  size_t read_back(ImageRef image, VkImageAspectFlags aspect, std::optional<VkRect2D> part = {});

  struct GraphImage {
    ImageDesc desc;
    std::string key; // of a kept image; empty for one of this frame
    bool holds_content = false;
    uint64_t version = 0;
    bool left_out = false; // what it is made for is
  };
  struct ReadbackRequest {
    ImageRef image;
    VkImageAspectFlags aspect = 0;
    VkRect2D part{};
  };
  const std::vector<GraphImage>& images() const { return images_; }
  const std::vector<Pass>& passes() const { return passes_; }
  const std::vector<ImageRef>& wanted() const { return wanted_; }
  const std::vector<ReadbackRequest>& readbacks() const { return readbacks_; }
  KeptImages& kept() const { return kept_; }
  uint64_t frame() const { return frame_; }
  const Keeping& keeping() const { return keeping_; }
  /// Whether the one thing that is not kept has been asked for by name; else an image or a pass is called so.
  bool but_is_declared() const { return but_is_declared_; }
  const std::vector<LeftOut>& left_out() const { return left_out_; }
  const ImageDesc& desc(ImageRef image) const { return images_[image.index].desc; }

private:
  ImageRef keep(GraphImage image);

  KeptImages& kept_;
  uint64_t frame_;
  Keeping keeping_;
  bool but_is_declared_ = false;
  std::vector<LeftOut> left_out_;
  std::vector<GraphImage> images_;
  std::vector<Pass> passes_;
  std::vector<ImageRef> wanted_;
  std::vector<ReadbackRequest> readbacks_;
};

} // namespace unghost
