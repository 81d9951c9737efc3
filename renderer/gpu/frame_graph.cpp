#include "renderer/gpu/frame_graph.h"

#include <algorithm>

#include "renderer/gpu/graph_runner.h"

namespace unghost {
namespace {

bool same_place(const ImageDesc& a, const ImageDesc& b) {
  return a.format == b.format && a.extent.width == b.extent.width && a.extent.height == b.extent.height;
}

} // namespace

Binding sampled(uint32_t slot, ImageRef image) { return {.slot = slot, .use = Use::sampled, .image = image}; }
Binding sampled_stencil(uint32_t slot, ImageRef image) {
  return {.slot = slot, .use = Use::sampled_stencil, .image = image};
}
Binding filtered(uint32_t slot, ImageRef image) {
  return {
      .slot = slot, .use = Use::sampled, .image = image, .type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
}
Binding storage_read(uint32_t slot, ImageRef image) {
  return {.slot = slot, .use = Use::storage_read, .image = image, .type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
}
Binding storage_write(uint32_t slot, ImageRef image) {
  return {.slot = slot, .use = Use::storage_write, .image = image, .type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
}
Binding uniform(uint32_t slot, BufferSlice buffer) {
  return {.slot = slot, .buffer = buffer, .type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER};
}
Binding buffer(uint32_t slot, BufferSlice buffer) {
  return {.slot = slot, .buffer = buffer, .type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
}

bool FrameGraph::needed(bool is, const LeftOut& thing, std::initializer_list<ImageRef> images) {
  but_is_declared_ |= thing.what == keeping_.but;
  if (is || (keeping_.all && keeping_.but != thing.what)) return true;
  for (const ImageRef image : images) images_[image.index].left_out = true;
  if (std::ranges::find(left_out_, thing.what, &LeftOut::what) == left_out_.end()) left_out_.push_back(thing);
  return false;
}

ImageRef FrameGraph::image(ImageDesc desc) {
  images_.push_back({.desc = std::move(desc)});
  return {uint32_t(images_.size() - 1)};
}

ImageRef FrameGraph::keep(GraphImage image) {
  for (uint32_t i = 0; i < images_.size(); ++i)
    if (images_[i].key == image.key) return {i};
  images_.push_back(std::move(image));
  return {uint32_t(images_.size() - 1)};
}

ImageRef FrameGraph::neutral(VkFormat format) {
  const std::string key = std::string(neutral_prefix) + std::to_string(format);
  return keep({.desc = {.name = key, .format = format}, .key = key, .holds_content = true});
}

History FrameGraph::history(const std::string& key, ImageDesc desc, bool reset) {
  const bool even = frame_ % 2 == 0;
  const std::string before = key + (even ? " b" : " a"), now = key + (even ? " a" : " b");
  const auto found = kept_.find(before);
  const bool valid = !reset && found != kept_.end() && found->second.frame + 1 == frame_ &&
                     same_place(found->second.desc, desc);
  ImageDesc last = desc;
  desc.name = key, last.name = "last frame's " + key;
  History history{.previous = valid ? keep({.desc = last, .key = before, .holds_content = true})
                                    : neutral(desc.format),
                  .next = keep({.desc = desc, .key = now}),
                  .valid = valid};
  want(history.next);
  return history;
}

Cache FrameGraph::cache(const std::string& key, ImageDesc desc, uint64_t version) {
  const auto found = kept_.find(key);
  const bool valid =
      found != kept_.end() && found->second.version == version && same_place(found->second.desc, desc);
  desc.name = key;
  return {.image = keep({.desc = desc, .key = key, .holds_content = valid, .version = version}),
          .valid = valid,
          .recent = valid && found->second.frame + 1 == frame_};
}

void FrameGraph::compute(ComputePass pass) {
  passes_.push_back({.name = pass.name, .bindings = pass.bindings, .record = [pass](PassCommands& commands) {
                       commands.dispatch(pass);
                     }});
}

void FrameGraph::copy(const CopyPass& pass) {
  passes_.push_back({.name = pass.name,
                     .kind = PassKind::transfer,
                     .transfers = {{pass.from, Use::transfer_source}, {pass.to, Use::transfer_destination}},
                     .patches = pass.part.has_value(),
                     .root = pass.root,
                     .record = [pass, all = desc(pass.from).extent](PassCommands& commands) {
                       commands.copy(pass.from, pass.to, pass.part.value_or(VkRect2D{{}, all}));
                     }});
}

size_t FrameGraph::read_back(ImageRef image, VkImageAspectFlags aspect, std::optional<VkRect2D> part) {
  want(image);
  readbacks_.push_back({image, aspect, part.value_or(VkRect2D{{}, desc(image).extent})});
  const size_t place = readbacks_.size() - 1;
  passes_.push_back({.name = "read back " + desc(image).name,
                     .kind = PassKind::transfer,
                     .transfers = {{image, Use::transfer_source}},
                     .root = true,
                     .record = [place](PassCommands& commands) { commands.read_back(place); }});
  return place;
}

} // namespace unghost
