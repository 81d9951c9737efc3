#include <algorithm>
#include <cassert>

#include "renderer/gpu/graph_runner.h"

namespace unghost {

PassCommands::PassCommands(const Context& context, const Pass& pass, VkCommandBuffer commands)
    : context_(context), pass_(pass), commands_(commands) {}

const GpuImage* PassCommands::placed(ImageRef image) const {
  const uint32_t place = context_.places[image.index];
  return place == ~0u ? nullptr : context_.runner.pool_[place].image.get();
}

VkImage PassCommands::image(ImageRef ref) const { return placed(ref)->image; }

VkPipelineLayout PassCommands::layout(VkDescriptorSetLayout second_set) const {
  LayoutDesc desc{.second_set = second_set};
  for (const Binding& binding : pass_.bindings) desc.bindings.emplace_back(binding.slot, binding.type);
  return context_.runner.pipelines_.layout(desc);
}

void PassCommands::push_bindings(VkPipelineBindPoint point, VkPipelineLayout layout) {
  std::vector<VkDescriptorImageInfo> images(pass_.bindings.size());
  std::vector<VkDescriptorBufferInfo> buffers(pass_.bindings.size());
  std::vector<VkWriteDescriptorSet> writes;
  for (size_t i = 0; i < pass_.bindings.size(); ++i) {
    const Binding& binding = pass_.bindings[i];
    if (binding.image) {
      const VkFormat format = context_.graph.desc(binding.image).format;
      const GpuImage& image = *placed(binding.image);
      const VkImageView view = binding.use == Use::sampled_stencil ? image.stencil
                               : is_depth(format)                  ? image.depth
                                                                   : image.view;
      const bool filters = binding.type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
      images[i] = {filters ? VkSampler(context_.runner.linear_) : VK_NULL_HANDLE, view,
                   facts_of(binding.use, pass_.kind, format).layout};
    } else {
      buffers[i] = {binding.buffer.buffer, binding.buffer.offset, binding.buffer.size};
    }
    writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                      .dstBinding = binding.slot,
                      .descriptorCount = 1,
                      .descriptorType = binding.type,
                      .pImageInfo = &images[i],
                      .pBufferInfo = &buffers[i]});
  }
  context_.runner.device_.push_descriptors(commands_, point, layout, 0, uint32_t(writes.size()),
                                           writes.data());
}

bool PassCommands::stencil_live(ImageRef image) const {
  const FrameGraph& graph = context_.graph;
  const auto samples = [&](const Binding& binding) {
    return binding.use == Use::sampled_stencil && binding.image == image;
  };
  const auto reads = [&](const PlannedPass& planned) {
    return std::ranges::any_of(graph.passes()[planned.pass].bindings, samples);
  };
  const auto brings = [&](const FrameGraph::ReadbackRequest& request) {
    return request.aspect == VK_IMAGE_ASPECT_STENCIL_BIT && request.image == image;
  };
  return graph.keeping().all || std::ranges::any_of(context_.plan.passes, reads) ||
         std::ranges::any_of(graph.readbacks(), brings);
}

void PassCommands::dispatch(const ComputePass& pass) {
  std::vector<uint32_t> constants;
  for (const Constant& constant : pass.constants) {
    constants.push_back(constant.value);
    for (const auto& [image, bit] : constant.if_live) constants.back() |= live(image) ? bit : 0;
  }
  bound_ = layout(VK_NULL_HANDLE);
  const Pipeline& pipeline = context_.runner.pipelines_.compute(pass.shader, constants, bound_);
  note(pass.shader, constants, pipeline);
  vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle);
  push_bindings(VK_PIPELINE_BIND_POINT_COMPUTE, bound_);
  push(pass.push);
  vkCmdDispatch(commands_, (pass.cover.width + pass.group.width - 1) / pass.group.width,
                (pass.cover.height + pass.group.height - 1) / pass.group.height, 1);
}

void PassCommands::copy(ImageRef from, ImageRef to, const VkRect2D& part) {
  const VkImageSubresourceLayers all{aspects_of(context_.graph.desc(from).format), 0, 0, 1};
  const VkOffset3D corner{part.offset.x, part.offset.y, 0};
  const VkImageCopy region{all, corner, all, corner, {part.extent.width, part.extent.height, 1}};
  vkCmdCopyImage(commands_, image(from), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image(to),
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void PassCommands::note(const std::string& shader, const std::vector<uint32_t>& constants,
                        const Pipeline& pipeline) {
  const auto found = std::ranges::find_if(
      used_, [&](const UsedPipeline& used) { return used.shader == shader && used.constants == constants; });
  bound_pipeline_ = size_t(found - used_.begin());
  if (found == used_.end())
    used_.push_back({.shader = shader,
                     .constants = constants,
                     .instructions = pipeline.instructions,
                     .fetches = pipeline.fetches});
}

void PassCommands::draw_indexed(uint32_t indices, uint32_t first_index, uint32_t first_vertex,
                                uint32_t instance) {
  vkCmdDrawIndexed(commands_, indices, 1, first_index, int32_t(first_vertex), instance);
  ++used_[bound_pipeline_].draws;
}

void PassCommands::push(std::span<const std::byte> bytes) {
  assert(bytes.size() <= push_constant_bytes);
  if (!bytes.empty())
    vkCmdPushConstants(commands_, bound_, VK_SHADER_STAGE_ALL, 0, uint32_t(bytes.size()), bytes.data());
}

void PassCommands::read_back(size_t place) {
  const auto& [image, aspect, part] = context_.graph.readbacks()[place];
  const VkDeviceSize size = VkDeviceSize(part.extent.width) * part.extent.height *
                            texel_bytes(context_.graph.desc(image).format, aspect);
  auto& buffer = context_.runner.flights_[context_.runner.next_].readbacks[place];
  if (buffer == nullptr || buffer->size < size)
    buffer = std::make_unique<GpuBuffer>(context_.runner.device_, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                         VK_MEMORY_PROPERTY_HOST_CACHED_BIT);
  const VkBufferImageCopy copy{.imageSubresource = {aspect, 0, 0, 1},
                               .imageOffset = {part.offset.x, part.offset.y, 0},
                               .imageExtent = {part.extent.width, part.extent.height, 1}};
  vkCmdCopyImageToBuffer(commands_, placed(image)->image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                         buffer->buffer, 1, &copy);
  const VkMemoryBarrier2 to_host{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                                 .srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT,
                                 .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                 .dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT,
                                 .dstAccessMask = VK_ACCESS_2_HOST_READ_BIT};
  const VkDependencyInfo info{
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO, .memoryBarrierCount = 1, .pMemoryBarriers = &to_host};
  vkCmdPipelineBarrier2(commands_, &info);
}

void PassCommands::begin_rendering() {
  std::vector<VkRenderingAttachmentInfo> colours;
  VkRenderingAttachmentInfo depth{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  bool stencil = false;
  VkExtent2D extent{};
  for (const Attachment& attachment : pass_.attachments) {
    VkRenderingAttachmentInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    const GpuImage* image = placed(attachment.image);
    const ImageDesc& desc = context_.graph.desc(attachment.image);
    if (image != nullptr) {
      extent = desc.extent;
      info.imageView = image->view;
      info.imageLayout = facts_of(attachment.use, pass_.kind, desc.format).layout;
      info.loadOp = attachment.clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
      info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
      if (attachment.clear) info.clearValue = *attachment.clear;
    }
    if (is_depth(desc.format)) {
      depth = info;
      stencil = has_stencil(desc.format);
    } else {
      colours.push_back(info);
    }
  }
  const VkRenderingInfo rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                  .renderArea = {{0, 0}, extent},
                                  .layerCount = 1,
                                  .colorAttachmentCount = uint32_t(colours.size()),
                                  .pColorAttachments = colours.data(),
                                  .pDepthAttachment = &depth,
                                  .pStencilAttachment = stencil ? &depth : nullptr};
  vkCmdBeginRendering(commands_, &rendering);
  const VkViewport viewport{0, 0, float(extent.width), float(extent.height), 0, 1};
  const VkRect2D scissor{{0, 0}, extent};
  vkCmdSetViewport(commands_, 0, 1, &viewport);
  vkCmdSetScissor(commands_, 0, 1, &scissor);
}

void PassCommands::end_rendering() { vkCmdEndRendering(commands_); }

std::vector<VkFormat> PassCommands::colour_formats() const {
  std::vector<VkFormat> formats;
  for (const Attachment& attachment : pass_.attachments) {
    const VkFormat format = context_.graph.desc(attachment.image).format;
    if (!is_depth(format))
      formats.push_back(placed(attachment.image) != nullptr ? format : VK_FORMAT_UNDEFINED);
  }
  return formats;
}

VkFormat PassCommands::depth_format() const {
  for (const Attachment& attachment : pass_.attachments)
    if (const VkFormat format = context_.graph.desc(attachment.image).format; is_depth(format)) return format;
  return VK_FORMAT_UNDEFINED;
}

void PassCommands::bind(const GraphicsDesc& desc, VkDescriptorSetLayout second_set) {
  const VkPipelineLayout wanted = layout(second_set);
  const Pipeline& pipeline = context_.runner.pipelines_.graphics(desc, wanted);
  note(desc.fragment.empty() ? desc.vertex : desc.vertex + " " + desc.fragment, desc.constants, pipeline);
  vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
  if (bound_ == wanted) return;
  bound_ = wanted;
  push_bindings(VK_PIPELINE_BIND_POINT_GRAPHICS, bound_);
}

void PassCommands::bind_second_set(VkDescriptorSet set) {
  vkCmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, bound_, 1, 1, &set, 0, nullptr);
}

} // namespace unghost
