#include "renderer/gpu/graph_runner.h"

#include <algorithm>
#include <cassert>

namespace unghost {
namespace {

constexpr uint64_t frames_until_forgotten = 4;
constexpr uint32_t nowhere = ~0u;

/// A kept image is used in other ways in other frames, and must not lose its content by that.
VkImageUsageFlags usage_of_kept(VkFormat format) {
  constexpr VkImageUsageFlags any =
      VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  return any | (is_depth(format) ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                 : VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
}

/// An image that can be used in more ways serves, too.
bool serves(const GpuImageDesc& there, const GpuImageDesc& wanted) {
  return there.format == wanted.format && (there.usage & wanted.usage) == wanted.usage &&
         there.extent.width == wanted.extent.width && there.extent.height == wanted.extent.height;
}

void record_barriers(VkCommandBuffer commands, const std::vector<ImageBarrier>& barriers,
                     const FrameGraph& graph, const std::function<VkImage(ImageRef)>& image_of) {
  std::vector<VkImageMemoryBarrier2> all;
  for (const ImageBarrier& barrier : barriers)
    all.push_back({.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                   .srcStageMask = barrier.from_stages,
                   .srcAccessMask = barrier.from_access,
                   .dstStageMask = barrier.to_stages,
                   .dstAccessMask = barrier.to_access,
                   .oldLayout = barrier.from,
                   .newLayout = barrier.to,
                   .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                   .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                   .image = image_of(barrier.image),
                   .subresourceRange = {aspects_of(graph.desc(barrier.image).format), 0, 1, 0, 1}});
  const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                              .imageMemoryBarrierCount = uint32_t(all.size()),
                              .pImageMemoryBarriers = all.data()};
  if (!all.empty()) vkCmdPipelineBarrier2(commands, &info);
}

OwnedSampler make_linear_sampler(VkDevice device) {
  const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                 .magFilter = VK_FILTER_LINEAR,
                                 .minFilter = VK_FILTER_LINEAR,
                                 .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                 .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE};
  VkSampler made = VK_NULL_HANDLE;
  check(vkCreateSampler(device, &info, nullptr, &made), "making a sampler");
  return {device, made};
}

} // namespace

GraphRunner::GraphRunner(Device& device, std::filesystem::path shaders)
    : device_(device), pipelines_(device, std::move(shaders)),
      linear_(make_linear_sampler(device.handle())), flights_{Flight(device), Flight(device)} {
  static_assert(frames_in_flight == 2);
}

GraphRunner::~GraphRunner() { device_.wait_idle(); }

/// What was there goes when this frame has been waited for.
void GraphRunner::replace(Place& place, Place with) {
  if (place.image != nullptr) flights_[next_].replaced.push_back(std::move(place.image));
  place = std::move(with);
}

uint32_t GraphRunner::place_for(const FrameGraph::GraphImage& image, const PlannedImage& planned,
                                uint64_t frame) {
  GpuImageDesc desc{.name = image.desc.name, .format = image.desc.format, .usage = planned.usage};
  if (planned.live || !image.key.empty()) desc.extent = image.desc.extent;
  if (!image.key.empty()) desc.usage |= usage_of_kept(desc.format);
  uint32_t place = 0;
  const auto fits = [&](const Place& other) {
    return other.key == image.key && !other.taken && (!image.key.empty() || serves(other.desc, desc));
  };
  while (place < pool_.size() && !fits(pool_[place])) ++place;
  if (place == pool_.size()) { // none fits: one that was forgotten, or another one more
    place = 0;
    while (place < pool_.size() && pool_[place].image != nullptr) ++place;
  }
  if (place == pool_.size()) {
    pool_.push_back({});
    states_.push_back({});
  }
  Place& chosen = pool_[place];
  if (chosen.image == nullptr || !serves(chosen.desc, desc)) {
    states_[place] = {};
    replace(chosen, {.desc = desc, .key = image.key, .image = std::make_unique<GpuImage>(device_, desc)});
    if (image.key.starts_with(neutral_prefix)) clear_neutral(place);
  }
  chosen.taken = true;
  chosen.last_frame = frame;
  return place;
}

std::vector<uint32_t> GraphRunner::assign(const FrameGraph& graph, const FramePlan& plan) {
  std::vector<uint32_t> places(plan.images.size(), nowhere);
  for (Place& place : pool_) place.taken = false;
  for (size_t pass = 0; pass < plan.passes.size(); ++pass) {
    for (size_t i = 0; i < places.size(); ++i)
      if (plan.images[i].needed && plan.images[i].first_pass == pass)
        places[i] = place_for(graph.images()[i], plan.images[i], graph.frame());
    for (size_t i = 0; i < places.size(); ++i)
      if (places[i] != nowhere && plan.images[i].last_pass == pass) pool_[places[i]].taken = false;
  }
  return places;
}

void GraphRunner::clear_neutral(uint32_t place) {
  const VkImage image = pool_[place].image->image;
  constexpr VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  const auto to_layout = [&](VkImageLayout from, VkImageLayout to) {
    return VkImageMemoryBarrier2{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
                                 .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                 .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
                                 .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                                 .dstAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT | VK_ACCESS_2_MEMORY_READ_BIT,
                                 .oldLayout = from,
                                 .newLayout = to,
                                 .image = image,
                                 .subresourceRange = range};
  };
  device_.run([&](VkCommandBuffer commands) {
    const VkImageMemoryBarrier2 before =
        to_layout(VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                .imageMemoryBarrierCount = 1,
                                .pImageMemoryBarriers = &before};
    vkCmdPipelineBarrier2(commands, &info);
    const VkClearColorValue zero{};
    vkCmdClearColorImage(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &zero, 1, &range);
  });
  states_[place] = {.layout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                    .written_in = VK_PIPELINE_STAGE_2_CLEAR_BIT,
                    .write_access = VK_ACCESS_2_TRANSFER_WRITE_BIT};
}

void GraphRunner::forget_unused(uint64_t frame) {
  for (Place& place : pool_)
    if (place.last_frame + frames_until_forgotten < frame && !place.key.starts_with(neutral_prefix)) {
      kept_.erase(place.key);
      replace(place, {});
    }
}

void GraphRunner::prepare_queries(Flight& flight, size_t count) const {
  if (count > flight.query_count) {
    const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = uint32_t(count)};
    VkQueryPool made = VK_NULL_HANDLE;
    check(vkCreateQueryPool(device_.handle(), &info, nullptr, &made), "making a query pool");
    flight.queries = OwnedQueryPool(device_.handle(), made);
    flight.query_count = count;
  }
  vkResetQueryPool(device_.handle(), flight.queries, 0, uint32_t(count));
}

void GraphRunner::submit(const FrameGraph& graph, const SubmitSync& sync) {
  Flight& flight = flights_[next_];
  assert(!flight.result && "make_room comes first");
  FramePlan plan = cull(graph);
  const std::vector<uint32_t> places = assign(graph, plan);
  std::vector<ImageState> states = states_;
  derive_barriers(graph, plan, places, states);
  prepare_queries(flight, plan.passes.size() + 1);
  while (flight.readbacks.size() < graph.readbacks().size()) flight.readbacks.push_back(nullptr);

  const PassCommands::Context context{*this, graph, plan, places};
  const auto image_of = [&](ImageRef image) { return VkImage(pool_[places[image.index]].image->image); };
  RunResult result;
  device_.submit(
      next_,
      [&](VkCommandBuffer commands) {
        vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, flight.queries, 0);
        for (size_t i = 0; i < plan.passes.size(); ++i) {
          const Pass& pass = graph.passes()[plan.passes[i].pass];
          record_barriers(commands, plan.passes[i].barriers, graph, image_of);
          PassCommands pass_commands(context, pass, commands);
          pass.record(pass_commands);
          result.passes.push_back({.name = pass.name, .pipelines = pass_commands.used()});
          vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, flight.queries,
                               uint32_t(i + 1));
        }
      },
      sync);
  states_ = std::move(states);
  note_kept(graph, plan); // only now: what was not carried out changed nothing
  count_images(graph, plan, places, result);
  result.left_out = graph.left_out();
  for (LeftOut& thing : unread(graph, plan)) result.left_out.push_back(std::move(thing));
  flight.readback_bytes.clear();
  for (const auto& [image, aspect, part] : graph.readbacks())
    flight.readback_bytes.push_back(size_t(part.extent.width) * part.extent.height *
                                    texel_bytes(graph.desc(image).format, aspect));
  flight.result = std::move(result);
  forget_unused(graph.frame());
  next_ = (next_ + 1) % flights_.size();
}

std::optional<RunResult> GraphRunner::land(size_t number) {
  Flight& flight = flights_[number];
  device_.wait(number);
  flight.replaced.clear();
  flight.memory.reset();
  if (!flight.result) return {};
  std::optional<RunResult> result = std::exchange(flight.result, std::nullopt);
  std::vector<uint64_t> ticks(result->passes.size() + 1);
  check(vkGetQueryPoolResults(device_.handle(), flight.queries, 0, uint32_t(ticks.size()), ticks.size() * 8,
                              ticks.data(), 8, VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "reading times");
  for (size_t i = 0; i < result->passes.size(); ++i)
    result->passes[i].ms =
        double((ticks[i + 1] - ticks[i]) & device_.tick_mask()) * device_.nanoseconds_per_tick() * 1e-6;
  for (size_t i = 0; i < flight.readback_bytes.size(); ++i) {
    const std::byte* bytes = flight.readbacks[i]->bytes().data();
    result->readbacks.emplace_back(bytes, bytes + flight.readback_bytes[i]);
  }
  return result;
}

void GraphRunner::reload_shaders() {
  pipelines_.reload();
  std::erase_if(kept_, [](const auto& kept) { return !kept.first.starts_with(neutral_prefix); });
}

std::optional<RunResult> GraphRunner::make_room() { return land(next_); }

RunResult GraphRunner::finish() {
  const size_t last = (next_ + flights_.size() - 1) % flights_.size();
  assert(flights_[last].result && "something was submitted");
  return *land(last);
}

/// But for those that stand for none.
std::vector<PassImage> GraphRunner::images_of(const FrameGraph& graph, const FramePlan& plan,
                                              const std::vector<uint32_t>& places, const Pass& pass) const {
  std::vector<PassImage> images;
  for (const auto& [image, reads, writes] : touched_by(graph, pass)) {
    const uint32_t place = places[image.index];
    if (place == nowhere || !plan.images[image.index].live || pool_[place].key.starts_with(neutral_prefix))
      continue;
    images.push_back({.name = graph.desc(image).name,
                      .bytes = pool_[place].image->bytes,
                      .reads = reads,
                      .writes = writes});
  }
  return images;
}

void GraphRunner::count_images(const FrameGraph& graph, const FramePlan& plan,
                               const std::vector<uint32_t>& places, RunResult& result) const {
  std::map<uint32_t, UsedImage> used; // by place
  for (size_t i = 0; i < plan.passes.size(); ++i) {
    result.passes[i].images = images_of(graph, plan, places, graph.passes()[plan.passes[i].pass]);
    for (size_t image = 0; image < places.size(); ++image) {
      if (places[image] == nowhere || plan.images[image].first_pass != i) continue;
      const Place& place = pool_[places[image]];
      const auto [found, first] = used.try_emplace(places[image]);
      UsedImage& here = found->second;
      const std::string& name = graph.images()[image].desc.name;
      here.name += (first ? "" : ", ") + name;
      here.bytes = place.image->bytes;
      if (first) result.passes[i].image_bytes += here.bytes;
    }
  }
  for (auto& [place, image] : used) {
    result.image_bytes += image.bytes;
    result.images.push_back(std::move(image));
  }
}

} // namespace unghost
