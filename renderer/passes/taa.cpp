#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {
namespace {

constexpr VkFormat colour_format = VK_FORMAT_R16G16B16A16_SFLOAT, motion_format = VK_FORMAT_R32G32_SFLOAT,
                   depth_format = VK_FORMAT_R32_SFLOAT, probe_format = VK_FORMAT_R32G32B32A32_SFLOAT,
                   object_format = VK_FORMAT_R32_UINT, key_format = VK_FORMAT_R32_UINT,
                   count_format = VK_FORMAT_R32_SFLOAT;

constexpr const char* no_history = "this mode keeps none";

/// What one mode keeps from frame to frame; where it does not keep one, `previous` is neutral and `next` 1x1.
struct Kept {
  History colour, count, motion, depth, objects;
  uint32_t writes = 0; // TAA_WRITES_ bits
  bool valid = true;   // all that the mode asks for hold last frame's
};

Kept kept_by(FrameGraph& graph, const FrameContext& in, size_t place) {
  const TaaPolicy& policy = in.modes[place].taa.policy;
  const bool reset = in.cut || in.policy_changed[place];
  Kept kept;
  const auto keep = [&](bool asked, const LeftOut& thing, VkFormat format, uint32_t bit) {
    if (!graph.needed(asked, thing))
      return History{.previous = graph.neutral(format), .next = graph.image({"none", format})};
    History history =
        graph.history(thing.what + " " + std::to_string(place), {.format = format, .extent = in.size}, reset);
    kept.writes |= bit;
    kept.valid = kept.valid && (history.valid || !asked);
    if (!asked) history.previous = graph.neutral(format); // written for nobody
    return history;
  };
  kept.colour = keep(policy.needs_history(), {"history", no_history}, colour_format, 0);
  const bool counts = policy.blend == Blend::counting || (in.view == View::age && !policy.needs_key());
  kept.count =
      keep(counts, {"history of counts", "this mode counts no frames"}, count_format, TAA_WRITES_COUNT);
  kept.valid = policy.needs_history() && kept.colour.valid; // a count that begins late begins at 1
  kept.motion = keep(policy.needs_previous_motion(), {"history of motion", "this mode compares none"},
                     motion_format, TAA_WRITES_MOTION);
  kept.depth = keep(policy.needs_previous_depth(), {"history of depth", "this mode compares none"},
                    depth_format, TAA_WRITES_DEPTH);
  kept.objects = keep(policy.needs_previous_objects(), {"history of objects", "this mode compares none"},
                      object_format, TAA_WRITES_OBJECT);
  return kept;
}

/// Loads, sixteen or twelve, are what a software device does faster; nine or five taps are what others do.
HistoryFilter filter_for(const FrameContext& in, HistoryFilter asked) {
  if (asked == HistoryFilter::catmull_rom_12) return in.scene.software ? asked : HistoryFilter::catmull_rom_5;
  if (asked != HistoryFilter::catmull_rom) return asked;
  return in.scene.software ? HistoryFilter::catmull_rom_16 : HistoryFilter::catmull_rom_9;
}

/// Thresholds of near and moving that are not set are found from what is tagged: all of it, and as much road
/// beyond as it is long.
std::pair<float, float> near_and_far(const FrameContext& in, const TaaSettings& taa) {
  const float near_m = taa.near_m > 0 ? taa.near_m : in.tagged.deepest_m;
  const float far_m = taa.far_m > 0 ? taa.far_m : near_m + in.tagged.length_m;
  return {std::min(near_m, 0.999f * far_m), far_m};
}

TaaPush push_of(const FrameContext& in, const TaaSettings& taa) {
  const auto [near_m, far_m] = near_and_far(in, taa);
  return {.alpha = taa.alpha,
          .gamma = taa.gamma,
          .motion_threshold_px = taa.motion_threshold_px,
          .near_m = near_m,
          .far_m = far_m,
          .velocity_min = taa.velocity_min,
          .velocity_slope = taa.velocity_slope,
          .motion_length_px = taa.motion_length_px,
          .speed_px = taa.speed_px,
          .depth_share = taa.depth_share,
          .fast_alpha = taa.fast_alpha,
          .inverse_fast_squared = 1 / (taa.fast_px * taa.fast_px),
          .centred_rest = taa.centred_rest,
          .zoom_weight = taa.zoom_weight,
          .cubic = taa.cubic,
          .moved_ids = in.moved_ids,
          .frame = uint32_t(in.index),
          .dilates = taa.policy.dilation != Dilation::centre,
          .probe_px = in.probe ? glm::ivec2(in.probe->x, in.probe->y) : glm::ivec2(-1)};
}

/// What the resolve takes from this frame and from the last one. What it has no use for is neutral, so that
/// nothing is made for it.
struct Reading {
  FrameGraph& graph;
  const TaaPolicy& policy;
  const Kept& kept;
  bool fast = true;       // loads from storage images
  bool surfaces = false;  // there is more than the sky
  bool motion = false;    // there is any
  bool tags = false;      // asks for them, and there are any
  bool neighbours = true; // which of them speaks for a pixel is found out
  bool by_taps = false;   // of the history, through a sampler
  bool relights = false;  // it, where light changes
  bool bounds = false;    // it, by colours

  bool reads_anything() const { return kept.valid || kept.writes != 0; }
  bool key() const { return policy.needs_key(); } // what it keeps begins with the first frame
  bool objects() const {
    const bool compares = policy.needs_previous_objects() || (kept.writes & TAA_WRITES_OBJECT) != 0 ||
                          (neighbours && !key() && policy.dilation == Dilation::depth_edges);
    return surfaces && reads_anything() && compares;
  }
  bool depth() const {
    const bool compares = policy.rejects(Reject::near_moving | Reject::depth) ||
                          (kept.writes & TAA_WRITES_DEPTH) != 0 ||
                          (neighbours && !key() && policy.dilation != Dilation::longest);
    return surfaces && ((reads_anything() && compares) || tags);
  }

  Binding read(uint32_t slot, ImageRef image) const {
    return fast ? storage_read(slot, image) : sampled(slot, image);
  }
  Binding read_if(bool needed, uint32_t slot, ImageRef image, VkFormat format) const {
    return read(slot, needed ? image : graph.neutral(format));
  }
  // Neutral images that are sampled have formats of their own: in one pass an image has one layout.
  ImageRef no_integers() const { return graph.neutral(VK_FORMAT_R16_UINT); }
  ImageRef no_floats() const { return graph.neutral(VK_FORMAT_R8_UNORM); }
};

/// Without motion it is only tests that hear who speaks for a pixel, and what a key leaves for the next
/// frame's.
bool asks_neighbours(FrameGraph& graph, const TaaPolicy& policy, bool motion, bool tags) {
  const bool dilates = policy.dilation != Dilation::centre;
  const bool tests = policy.needs_previous_objects() || policy.needs_key() ||
                     policy.rejects(Reject::near_moving | Reject::depth) ||
                     (tags && policy.rejects(Reject::tag));
  const char* why =
      dilates ? "nothing moves, and no test asks who speaks for a pixel" : "this mode does not dilate";
  return graph.needed(dilates && (motion || tests), {"depth of neighbours", why});
}

/// A history that no light makes wrong is not asked what fell on it.
bool asks_light(FrameGraph& graph, const FrameContext& in, const TaaPolicy& policy, bool lit) {
  const bool changes = lit && in.light_changes;
  return policy.rejects(Reject::visibility) &&
         graph.needed(changes, {"light of the history", lit ? "no light changes" : "nothing is lit"});
}

/// Of a row that bounds what is not known: all is, where the picture and its light rest.
bool asks_bounds(FrameGraph& graph, const FrameContext& in, const TaaPolicy& policy) {
  if (!policy.rectifies_unknown_only()) return true;
  return graph.needed(in.mirrors_change,
                      {"bounds of what is not known", "nothing moves and no light changes"});
}

Reading reading_of(FrameGraph& graph, const FrameContext& in, const TaaInputs& inputs, const TaaSettings& taa,
                   const Kept& kept) {
  const HistoryFilter filter = filter_for(in, taa.policy.history);
  const bool tags =
      inputs.gbuffer.tagged && graph.needed(taa.policy.needs_tags(), {"test of tags", "this mode has none"});
  return {.graph = graph,
          .policy = taa.policy,
          .kept = kept,
          .fast = taa.resolver == Resolver::fast,
          .surfaces = inputs.gbuffer.surfaces,
          .motion = inputs.motion.moves,
          .tags = tags,
          .neighbours = asks_neighbours(graph, taa.policy, inputs.motion.moves, tags),
          .by_taps = filter == HistoryFilter::catmull_rom_9 || filter == HistoryFilter::catmull_rom_5,
          .relights = asks_light(graph, in, taa.policy, inputs.gbuffer.lit),
          .bounds = asks_bounds(graph, in, taa.policy)};
}

std::vector<Binding> reads_of_frame(const Reading& r, const TaaInputs& inputs) {
  const bool longest = r.neighbours && r.policy.dilation == Dilation::longest;
  const bool motion = r.motion && (r.kept.valid || (r.kept.writes & TAA_WRITES_MOTION) != 0 || longest);
  return {r.read(TAA_COLOUR, inputs.colour),
          r.read_if(motion, TAA_MOTION, inputs.motion.motion_px, motion_format),
          r.fast ? r.read_if(r.depth(), TAA_DEPTH, inputs.motion.depth, depth_format)
                 : sampled(TAA_DEPTH, r.depth() ? inputs.gbuffer.depth : r.no_floats()),
          r.tags && !r.fast ? sampled_stencil(TAA_TAG, inputs.gbuffer.depth)
                            : sampled(TAA_TAG, r.no_integers()),
          r.read_if(r.key(), TAA_KEY, inputs.motion.key, key_format),
          sampled(TAA_OBJECT, r.objects() ? inputs.gbuffer.object : r.no_integers()),
          r.read_if(r.kept.valid && r.policy.needs_previous_depth(), TAA_EXPECTED_DEPTH,
                    inputs.motion.previous_depth, depth_format)};
}

std::vector<Binding> reads_of_last_frame(const Reading& r) {
  const ImageRef colour = r.kept.colour.previous;
  return {r.read_if(r.kept.valid && !r.by_taps, TAA_PREVIOUS, colour, colour_format),
          filtered(TAA_HISTORY_SAMPLER, r.kept.valid && r.by_taps ? colour : r.no_floats()),
          r.read(TAA_PREVIOUS_COUNT, r.kept.count.previous),
          r.read(TAA_PREVIOUS_MOTION, r.kept.motion.previous),
          r.read(TAA_PREVIOUS_DEPTH, r.kept.depth.previous),
          r.read(TAA_PREVIOUS_OBJECT, r.kept.objects.previous)};
}

std::vector<Binding> writes_of(FrameGraph& graph, const TaaPolicy& policy, const Kept& kept,
                               const Resolved& resolved) {
  const ImageRef nothing = graph.image({"none", colour_format});
  return {
      storage_write(TAA_OUT, resolved.colour),
      storage_write(TAA_INPUT_OUT, policy.keeps == Keeps::input ? kept.colour.next : nothing),
      storage_write(TAA_COUNT_OUT, kept.count.next),
      storage_write(TAA_MOTION_OUT, kept.motion.next),
      storage_write(TAA_DEPTH_OUT, kept.depth.next),
      storage_write(TAA_OBJECT_OUT, kept.objects.next),
      storage_write(TAA_WHY_OUT, resolved.why),
      storage_write(TAA_HISTORY_OUT, resolved.history),
      storage_write(TAA_PROBE_OUT, resolved.probe ? resolved.probe : graph.image({"none", probe_format}))};
}

std::vector<Binding> bindings_of(const FrameContext& in, const TaaInputs& inputs, const Reading& reading,
                                 const Resolved& resolved) {
  std::vector<Binding> bindings{uniform(FRAME_BINDING, in.constants)};
  for (const std::vector<Binding>& part : {reads_of_frame(reading, inputs), reads_of_last_frame(reading),
                                           writes_of(reading.graph, reading.policy, reading.kept, resolved)})
    bindings.insert(bindings.end(), part.begin(), part.end());
  return bindings;
}

/// In the order of the TAA_..._ID constants.
std::vector<Constant> constants_of(const FrameContext& in, const TaaSettings& taa, const Reading& r,
                                   const Resolved& resolved) {
  const TaaPolicy& policy = r.policy;
  return {uint32_t(r.neighbours ? policy.dilation : Dilation::centre),
          uint32_t(filter_for(in, policy.history)),
          uint32_t(policy.ringing),
          uint32_t(policy.space),
          uint32_t(policy.weighting),
          uint32_t(policy.rectify),
          policy.uses_dop() ? uint32_t(policy.axes) : 0u,
          uint32_t(policy.reject),
          uint32_t(policy.blend),
          uint32_t(policy.keeps),
          uint32_t(r.kept.valid),
          uint32_t(r.tags),
          {r.kept.writes | (resolved.probe ? TAA_WRITES_PROBE : 0),
           {{resolved.why, TAA_WRITES_WHY}, {resolved.history, TAA_WRITES_HISTORY}}},
          uint32_t(taa.store),
          uint32_t(r.motion),
          uint32_t(r.surfaces),
          uint32_t(r.neighbours && policy.dilation == Dilation::centre),
          uint32_t(policy.where),
          uint32_t(policy.fill),
          uint32_t(policy.input),
          uint32_t(r.relights),
          uint32_t(r.bounds)};
}

} // namespace

Resolved resolve_taa(FrameGraph& graph, const FrameContext& in, const TaaInputs& inputs, size_t place) {
  const TaaSettings& taa = in.modes[place].taa;
  const bool keeps_history = taa.policy.needs_history();
  if (!graph.needed(keeps_history, {"history", no_history}))
    return {.colour = inputs.colour, .why = {}, .history = {}, .probe = {}};
  const Kept kept = kept_by(graph, in, place);
  const auto image = [&](const char* name, VkFormat format) {
    return graph.image({.name = name, .format = format, .extent = in.size});
  };
  const bool probed = keeps_history && in.probe && in.probe->mode == place;
  const Resolved resolved{
      .colour = taa.policy.keeps == Keeps::result ? kept.colour.next : image("resolved", colour_format),
      .why = image("reasons of the resolve", VK_FORMAT_R32G32B32A32_SFLOAT),
      .history = image("history as it was used", colour_format),
      .probe = probed ? graph.image({"probe", probe_format, {TAA_PROBE_TEXELS, 1}}) : ImageRef{}};
  const Reading reading = reading_of(graph, in, inputs, taa, kept);
  const TaaPush push = push_of(in, taa);
  const auto bytes = std::as_bytes(std::span(&push, 1));
  const bool fast = taa.resolver == Resolver::fast;
  graph.compute({.name = "taa " + in.modes[place].name,
                 .shader = fast ? "taa.comp" : "taa_naive.comp",
                 .constants = constants_of(in, taa, reading, resolved),
                 .bindings = bindings_of(in, inputs, reading, resolved),
                 .push = {bytes.begin(), bytes.end()},
                 .cover = in.size,
                 .group = fast ? VkExtent2D{TAA_GROUP_WIDTH, TAA_GROUP_HEIGHT}
                               : VkExtent2D{TAA_NAIVE_SIDE, TAA_NAIVE_SIDE}});
  if (keeps_history) return resolved;
  return {.colour = resolved.colour, .why = {}, .history = {}, .probe = {}}; // the views know of none
}

} // namespace unghost
