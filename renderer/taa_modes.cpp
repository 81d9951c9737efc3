#include "renderer/taa_modes.h"

#include <algorithm>

namespace unghost {
namespace {

constexpr Reject leaves_screen = Reject::off_screen;

constexpr TaaPolicy accumulate{.jitter = Jitter::halton_8, .reject = leaves_screen, .blend = Blend::constant};

constexpr TaaPolicy gdk(Rectify rectify) {
  TaaPolicy policy = accumulate;
  policy.rectify = rectify;
  return policy;
}

/// Sharp and dilated, with a box clamp: what the articles of games build upon.
constexpr TaaPolicy clamped(Reject reject) {
  TaaPolicy policy = gdk(Rectify::box_clamp);
  policy.dilation = Dilation::closest_depth;
  policy.history = HistoryFilter::catmull_rom;
  policy.reject = leaves_screen | reject;
  return policy;
}

/// Two input frames, half of each.
constexpr TaaSettings two_frames(Reject reject) {
  return {.policy = {.jitter = Jitter::two_samples,
                     .reject = leaves_screen | reject,
                     .blend = Blend::constant,
                     .keeps = Keeps::input},
          .alpha = 0.5f};
}

/// The baseline of the k-DOP paper.
constexpr TaaPolicy clipped(Rectify rectify, Space space = Space::rgb, Axes axes = Axes::dop32) {
  return {.jitter = Jitter::r2_10,
          .dilation = Dilation::closest_depth,
          .history = HistoryFilter::catmull_rom,
          .space = space,
          .rectify = rectify,
          .axes = axes,
          .reject = leaves_screen,
          .blend = Blend::constant};
}

constexpr TaaSettings holy_trail() {
  TaaSettings settings{.policy = clamped(Reject::velocity)};
  settings.policy.weighting = Weighting::inverse_luminance;
  return settings;
}

/// Nothing is guessed from colours where the renderer knows what became of a pixel: objects that moved,
/// light that changed, the speed of the picture. What it cannot know is bounded by the neighbourhood.
constexpr TaaSettings known_causes(Rectify rectify, Where where, Input input) {
  return {.policy = {.jitter = Jitter::r2_10,
                     .dilation = Dilation::depth_edges,
                     .history = HistoryFilter::catmull_rom_12,
                     .ringing = Ringing::clamped,
                     .rectify = rectify,
                     .where = where,
                     .reject = leaves_screen | Reject::moved_object | Reject::visibility,
                     .fill = Fill::plain,
                     .blend = Blend::speed,
                     .input = input},
          .alpha = 0.08f,
          .jitter_scale = 0.85f,
          .jitter_moving = 0.6f};
}

constexpr std::string_view gdk_sample = "GDK sample", dop_paper = "Ikkala et al. 2024", ours = "this project";

constexpr TaaMode rows[] = {
    {"off", "The frame as it is drawn: no jitter, no history, every edge aliased.", "", {}},
    {"blend",
     "Exponential average of reprojected frames and nothing against ghosts, which last as long as it "
     "remembers: what every other mode must beat.",
     "GDK sample, clamping off",
     {.policy = accumulate}},
    {"gdk-clamp",
     "History clamped to the box of the 3x3 neighbourhood.",
     gdk_sample,
     {.policy = gdk(Rectify::box_clamp)}},
    {"gdk-clip",
     "History clipped to that box, along the way to the current colour.",
     gdk_sample,
     {.policy = gdk(Rectify::box_clip)}},
    {"gdk-variance",
     "History clamped to the neighbourhood's mean and standard deviation.",
     gdk_sample,
     {.policy = gdk(Rectify::variance_clamp)}},
    {"uncharted",
     "Box clamp, and history rejected where the vehicle tag differs from last frame's.",
     "Naughty Dog 2016, as in The Grand Tour Game (simple)",
     {.policy = clamped(Reject::tag)}},
    {"grand-tour",
     "As uncharted, and untagged pixels that are near and moving give up their history, too.",
     "The Grand Tour Game (complex)",
     {.policy = clamped(Reject::tag | Reject::near_moving)}},
    {"crytek-2x", "Half of this frame, half of the last, where both moved by as much.", "Sousa 2011",
     two_frames(Reject::motion_length)},
    {"ac4", "As crytek-2x, and nothing of the last frame where anything moves faster than 2 pixels.",
     "Wronski 2014 (Assassin's Creed 4)", two_frames(Reject::motion_length | Reject::speed)},
    {"holy-trail",
     "Box clamp, bright pixels weigh less, and where motion differs from last frame's the picture is "
     "blurred.",
     "Temporal AA and the quest for the Holy Trail", holy_trail()},
    {"rgb", "History clipped to the RGB box.", dop_paper, {.policy = clipped(Rectify::box_clip)}},
    {"ycocg",
     "History clipped to the YCoCg box.",
     "Karis 2014, as in Ikkala et al. 2024",
     {.policy = clipped(Rectify::box_clip, Space::ycocg)}},
    {"rgb-var",
     "History clipped to the neighbourhood's mean and standard deviation in RGB.",
     "Salvi 2016, as in Ikkala et al. 2024",
     {.policy = clipped(Rectify::variance_clip)}},
    {"ycocg-var",
     "The same in YCoCg.",
     "Salvi 2016, as in Ikkala et al. 2024",
     {.policy = clipped(Rectify::variance_clip, Space::ycocg)}},
    {"dop32",
     "History clipped to a polytope of 32 faces around the neighbourhood.",
     dop_paper,
     {.policy = clipped(Rectify::dop_clip)}},
    {"dop32-var",
     "The same with mean and standard deviation along each axis.",
     dop_paper,
     {.policy = clipped(Rectify::dop_variance)}},
    {"dop16-opt",
     "A polytope of 16 faces whose axes were found for this asphalt.",
     dop_paper,
     {.policy = clipped(Rectify::dop_clip, Space::rgb, Axes::dop16_ours)}},
    {"unghost",
     "History given up where an object moved, lit anew where light changed, and clipped to the box only "
     "where neither is known: reflections, and edges that move.",
     ours, known_causes(Rectify::box_clip, Where::unknown, Input::centred)},
    {"unghost-safe",
     "As unghost, and clipped everywhere: bounds what the renderer does not know, such as a sprite without "
     "an id.",
     ours, known_causes(Rectify::box_clip, Where::everywhere, Input::centred)},
    {"unghost-lite", "As unghost, without any colour neighbourhood.", ours,
     known_causes(Rectify::none, Where::everywhere, Input::sampled)},
};

} // namespace

std::span<const TaaMode> taa_modes() { return rows; }

const TaaMode* find_taa_mode(std::string_view name) {
  const auto found = std::ranges::find(rows, name, &TaaMode::name);
  return found == std::end(rows) ? nullptr : &*found;
}

} // namespace unghost
