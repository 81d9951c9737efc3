#include "renderer/gpu/frame_plan.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace unghost {
namespace {

struct Touch {
  ImageRef image;
  UseFacts facts;
  bool keeps; // what was there before matters
};

/// Every image that a pass touches, once, with all its uses joined.
std::vector<Touch> touches_of(const FrameGraph& graph, const Pass& pass) {
  std::vector<Touch> touches;
  const auto touch = [&](ImageRef image, Use use, bool keeps) {
    const UseFacts facts = facts_of(use, pass.kind, graph.desc(image).format);
    for (Touch& other : touches)
      if (other.image == image) {
        assert(other.facts.layout == facts.layout && "one layout an image and pass");
        other.facts.stages |= facts.stages;
        other.facts.access |= facts.access;
        other.facts.usage |= facts.usage;
        other.facts.reads |= facts.reads;
        other.facts.writes |= facts.writes;
        other.keeps |= keeps;
        return;
      }
    touches.push_back({image, facts, keeps});
  };
  for (const Binding& binding : pass.bindings)
    if (binding.image) touch(binding.image, binding.use, binding.use != Use::storage_write);
  for (const Attachment& attachment : pass.attachments)
    if (attachment.image) touch(attachment.image, attachment.use, !attachment.clear);
  for (const auto& [image, use] : pass.transfers)
    touch(image, use, use == Use::transfer_source || pass.patches);
  return touches;
}

/// The barrier that `touch` needs, if it needs one, and what the image's state is after it.
std::optional<ImageBarrier> step(ImageState& state, const Touch& touch, bool discards) {
  const UseFacts& facts = touch.facts;
  const bool moves = discards || state.layout != facts.layout;
  const bool sees =
      (state.read_in & facts.stages) == facts.stages && (state.read_access & facts.access) == facts.access;
  std::optional<ImageBarrier> barrier;
  if (facts.writes || moves || !sees)
    barrier = ImageBarrier{.image = touch.image,
                           .from_stages = state.written_in | (facts.writes || moves ? state.read_in : 0),
                           .to_stages = facts.stages,
                           .from_access = state.write_access,
                           .to_access = facts.access,
                           .from = discards ? VK_IMAGE_LAYOUT_UNDEFINED : state.layout,
                           .to = facts.layout};
  if (facts.writes) {
    state = {.layout = facts.layout, .written_in = facts.stages, .write_access = facts.access};
  } else if (moves) { // the transition is a write that only this use has waited for
    state = {.layout = facts.layout,
             .written_in = facts.stages,
             .read_in = facts.stages,
             .read_access = facts.access};
  } else {
    state.read_in |= facts.stages;
    state.read_access |= facts.access;
  }
  return barrier;
}

} // namespace

namespace {

constexpr VkPipelineStageFlags2 of_the_shader = 0; // the stage follows from the kind of the pass
constexpr VkPipelineStageFlags2 depth_stages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkImageLayout for_reading = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;

/// The one table of uses, in the order of Use.
constexpr UseFacts uses[] = {
    {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
     VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, false, true},
    {depth_stages,
     VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
     VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, true,
     true},
    {of_the_shader, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, for_reading, VK_IMAGE_USAGE_SAMPLED_BIT, true,
     false},
    {of_the_shader, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, for_reading, VK_IMAGE_USAGE_SAMPLED_BIT, true,
     false},
    {of_the_shader, VK_ACCESS_2_SHADER_STORAGE_READ_BIT, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_USAGE_STORAGE_BIT,
     true, false},
    {of_the_shader, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_USAGE_STORAGE_BIT,
     false, true},
    {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
     VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_USAGE_TRANSFER_SRC_BIT, true, false},
    {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_USAGE_TRANSFER_DST_BIT, false, true},
};

} // namespace

UseFacts facts_of(Use use, PassKind kind, VkFormat format) {
  UseFacts facts = uses[size_t(use)];
  if (facts.stages == of_the_shader)
    facts.stages = kind == PassKind::compute ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT
                                             : VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  if (facts.layout == for_reading && is_depth(format))
    facts.layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
  return facts;
}

namespace {

/// What one variant of a shader writes together is read, or not, as one.
void keep_together(const FrameGraph& graph, const std::vector<size_t>& running, FramePlan& plan) {
  for (const size_t pass : running) {
    const std::vector<Attachment>& attachments = graph.passes()[pass].attachments;
    const auto read = [&](const Attachment& one) {
      return one.together && plan.images[one.image.index].live;
    };
    if (std::ranges::none_of(attachments, read)) continue;
    for (const Attachment& one : attachments) plan.images[one.image.index].live |= one.together;
  }
}

/// Where everything is kept, every image but those of the one thing that is not. Where no part of the frame
/// asked for that by name, it is called as its image, or as the pass that writes them.
std::vector<ImageRef> kept_for_nobody(const FrameGraph& graph) {
  const auto& [all, but] = graph.keeping();
  if (!all) return {};
  const bool by_name = !graph.but_is_declared();
  std::vector<uint8_t> spared;
  for (const FrameGraph::GraphImage& image : graph.images())
    spared.push_back(image.left_out || (by_name && image.desc.name == but));
  for (const Pass& pass : graph.passes())
    for (const Touch& touch : touches_of(graph, pass))
      if (by_name && pass.name == but && touch.facts.writes) spared[touch.image.index] = 1;
  std::vector<ImageRef> images;
  for (uint32_t i = 0; i < spared.size(); ++i)
    if (spared[i] == 0) images.push_back({i});
  return images;
}

} // namespace

FramePlan cull(const FrameGraph& graph) {
  FramePlan plan;
  plan.images.resize(graph.images().size());
  // Whether what an image holds at this point, going backwards, is what somebody after it sees.
  std::vector<uint8_t> seen(plan.images.size(), 0);
  for (const std::vector<ImageRef>& images : {graph.wanted(), kept_for_nobody(graph)})
    for (const ImageRef wanted : images) {
      plan.images[wanted.index].live = true;
      seen[wanted.index] = 1;
    }

  std::vector<size_t> running;
  for (size_t i = graph.passes().size(); i-- > 0;) {
    const std::vector<Touch> touches = touches_of(graph, graph.passes()[i]);
    bool runs = graph.passes()[i].root;
    for (const Touch& touch : touches) runs |= touch.facts.writes && seen[touch.image.index] != 0;
    if (!runs) continue;
    running.push_back(i);
    for (const Touch& touch : touches) {
      PlannedImage& image = plan.images[touch.image.index];
      image.needed = true;
      image.live |= touch.facts.reads;
      image.usage |= touch.facts.usage;
      seen[touch.image.index] = touch.keeps || (seen[touch.image.index] != 0 && !touch.facts.writes);
    }
  }
  keep_together(graph, running, plan);
  for (PlannedImage& image : plan.images)
    if (!image.live && (image.usage & VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT) != 0) image.needed = false;
  for (size_t i = running.size(); i-- > 0;) plan.passes.push_back({.pass = running[i]});
  for (size_t place = plan.passes.size(); place-- > 0;)
    for (const Touch& touch : touches_of(graph, graph.passes()[plan.passes[place].pass])) {
      PlannedImage& image = plan.images[touch.image.index];
      image.last_pass = std::max(image.last_pass, place);
      image.first_pass = place;
    }
  return plan;
}

std::vector<LeftOut> unread(const FrameGraph& graph, const FramePlan& plan) {
  constexpr const char* why = "nothing that is shown or kept reads it";
  std::vector<LeftOut> left_out;
  const auto would_be_made = [&](ImageRef image) {
    const FrameGraph::GraphImage& declared = graph.images()[image.index];
    const bool counts = declared.desc.extent.width > 1 || declared.desc.extent.height > 1;
    return counts && !plan.images[image.index].live && !declared.left_out;
  };
  const auto add = [&](const std::string& what) {
    for (const std::vector<LeftOut>& known :
         {graph.left_out(), left_out}) // with a reason of its own, or this
      if (std::ranges::find(known, what, &LeftOut::what) != known.end()) return;
    left_out.push_back({what, why});
  };
  for (size_t i = 0; i < graph.passes().size(); ++i) {
    const Pass& pass = graph.passes()[i];
    const bool runs = std::ranges::find(plan.passes, i, &PlannedPass::pass) != plan.passes.end();
    for (const Touch& touch : touches_of(graph, pass))
      if (touch.facts.writes && would_be_made(touch.image))
        add(runs ? graph.desc(touch.image).name : pass.name);
  }
  return left_out;
}

std::vector<TouchedImage> touched_by(const FrameGraph& graph, const Pass& pass) {
  std::vector<TouchedImage> images;
  for (const Touch& touch : touches_of(graph, pass))
    images.push_back({touch.image, touch.keeps, touch.facts.writes});
  return images;
}

void derive_barriers(const FrameGraph& graph, FramePlan& plan, std::span<const uint32_t> place,
                     std::vector<ImageState>& states) {
  std::vector<uint8_t> touched(graph.images().size(), 0);
  for (PlannedPass& planned : plan.passes)
    for (const Touch& touch : touches_of(graph, graph.passes()[planned.pass])) {
      const size_t index = touch.image.index;
      if (!plan.images[index].needed) continue;
      const bool first = std::exchange(touched[index], 1) == 0;
      const bool discards = first && !graph.images()[index].holds_content;
      assert(!(discards && touch.keeps) && "somebody wrote what is read");
      if (const auto barrier = step(states[place[index]], touch, discards))
        planned.barriers.push_back(*barrier);
    }
}

void note_kept(const FrameGraph& graph, const FramePlan& plan) {
  for (const PlannedPass& planned : plan.passes)
    for (const Touch& touch : touches_of(graph, graph.passes()[planned.pass])) {
      const FrameGraph::GraphImage& image = graph.images()[touch.image.index];
      if (touch.facts.writes && !image.key.empty())
        graph.kept()[image.key] = {.desc = image.desc, .frame = graph.frame(), .version = image.version};
    }
}

} // namespace unghost
