// The resolve as its definition reads: one pixel an invocation, plain loops over its 3x3 neighbours. The oracle of the
// fast one, and what its time is measured by.
#version 460
#extension GL_GOOGLE_include_directive : require
#define FULLSCREEN_WIDTH TAA_NAIVE_SIDE
#define FULLSCREEN_HEIGHT TAA_NAIVE_SIDE
#include "frame.glsl"
#include "fullscreen.glsl"
#include "taa_store.glsl"
#include "shared/taa_axes.h"

/// The current frame around a pixel, row by row, in the working space.
struct Neighbourhood {
  vec3 colours[9];
  vec3 centre;   // linear
  vec3 blurred;  // linear: 1 2 1, 2 4 2, 1 2 1
  vec3 centred;  // linear, where it is asked for
};

Neighbourhood gather(ivec2 pixel) {
  Neighbourhood n;
  n.blurred = n.centred = vec3(0);
  vec3 across = centred_weights(frame.jitter_px.x), down = centred_weights(frame.jitter_px.y);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      vec3 colour = colour_at(inside(pixel + ivec2(x, y)));
      if (x == 0 && y == 0) n.centre = colour;
      n.colours[3 * y + x + 4] = to_working(colour);
      n.blurred += colour * float((2 - abs(x)) * (2 - abs(y))) / 16;
      if (centres_input()) n.centred += colour * across[x + 1] * down[y + 1];
    }
  return n;
}

/// The pixel whose motion speaks for this one. Of equals the pixel itself, then the first.
ivec2 place_of_speaker(ivec2 pixel) {
  if (dilation == dilation_centre && !asks_neighbours) return pixel;
  ivec2 best = pixel;
  float own = rank_of(rank_at(pixel)), most = own;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = inside(pixel + ivec2(x, y));
      float rank = rank_of(rank_at(at));
      if (rank > most) best = at, most = rank;
    }
  bool edge = dilation != dilation_depth_edges || most > 1.2 * own || object_at(best) != object_at(pixel);
  if (asks_neighbours) edge = edge && push.dilates != 0;
  return edge ? best : pixel;
}

/// The closest by its key, or the pixel itself. Of those as close the highest key, so what moves before what rests; of equal
/// keys the first.
ivec2 place_by_key(ivec2 pixel) {
  ivec2 best = pixel;
  uint own = key_at(pixel), most = own;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = inside(pixel + ivec2(x, y));
      uint key = key_at(at);
      if (key > most) best = at, most = key;
    }
  bool edge = dilation == dilation_closest_depth ? rank_of_key(most) > rank_of_key(own)
                                                 : dilation == dilation_depth_edges && is_edge(own, most);
  return edge ? best : pixel;
}

Around around_of(ivec2 pixel) {
  Around around = Around(key_at(pixel), false, false, 0);
  uint ids = 0, sum = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      uint key = key_at(inside(pixel + ivec2(x, y)));
      around.mixed = around.mixed || mixes_depths(around.own, key, key);
      ids |= id_bit_of_key(key), sum += light_bits_of(key);
    }
  around.mixed = around.mixed || several(ids);
  around.moving = (ids & push.moved_ids) != 0;
  around.mean = mean_lightness(sum);
  return around;
}

Speaker speaker_of(ivec2 pixel) {
  ivec2 at = keyed() && dilation != dilation_longest ? place_by_key(pixel) : place_of_speaker(pixel);
  Speaker speaker = Speaker(at, asks_for_depth() ? depth_at(at) : 0, reads_tags ? fetch(tag_map, at).r : 0, 0, nothing_around);
  if (keyed()) speaker.key = key_at(at), speaker.around = around_of(pixel);
  return speaker;
}

void box_of(vec3 colours[9], out vec3 low, out vec3 high) {
  low = high = colours[0];
  for (int i = 1; i < 9; ++i) low = min(low, colours[i]), high = max(high, colours[i]);
}

void variance_box_of(vec3 colours[9], out vec3 low, out vec3 high) {
  vec3 means[3], squares[3];
  for (int y = 0; y < 3; ++y) {
    ROW_MOMENTS(colours[3 * y], colours[3 * y + 1], colours[3 * y + 2], means[y], squares[y]);
  }
  NINE_MOMENTS(vec3, 0, means, squares, mean, reach);
  low = mean - reach, high = mean + reach;
}

/// The share of the segment from the middle colour to the history that the slab across `axis` leaves.
float share_along(vec3 axis, vec3 colours[9], vec3 history) {
  float at[9], low = 1e30, high = -1e30;
  for (int i = 0; i < 9; ++i) {
    at[i] = dot(colours[i], axis);
    low = min(low, at[i]), high = max(high, at[i]);
  }
  if (rectify == rectify_dop_variance) {
    float means[3], squares[3];
    for (int y = 0; y < 3; ++y) {
      ROW_MOMENTS(at[3 * y], at[3 * y + 1], at[3 * y + 2], means[y], squares[y]);
    }
    NINE_MOMENTS(float, 0, means, squares, mean, reach);
    low = min(mean - reach, at[4]), high = max(mean + reach, at[4]);
  }
  return slab_share(low, high, at[4], dot(history, axis));
}

vec3 clip_to_dop(vec3 colours[9], vec3 history) {
  float share = 1e30;
#define AXIS(x, y, z) share = min(share, share_along(vec3(x, y, z), colours, history));
  TAA_EACH_AXIS
#undef AXIS
  return on_segment(colours[4], history, share);
}

vec3 rectified(vec3 history, vec3 colours[9]) {
  vec3 low, high;
  if (rectify == rectify_dop_clip || rectify == rectify_dop_variance) return clip_to_dop(colours, history);
  if (rectify == rectify_box_clamp || rectify == rectify_box_clip) box_of(colours, low, high);
  else variance_box_of(colours, low, high);
  if (may_brighten()) {
    float brightest = 0;
    for (int i = 0; i < 9; ++i) brightest = max(brightest, weighted_luminance(colours[i]));
    return not_brighter(clamp(history, low, high), history, brightest);
  }
  if (rectify == rectify_box_clamp || rectify == rectify_variance_clamp) return clamp(history, low, high);
  return clip_to_box(history, colours[4], min(low, colours[4]), max(high, colours[4]));
}

void main() {
  pixel_or_return(pixel);
  Speaker speaker = speaker_of(pixel);
  if (!has_history) {
    vec3 centre = colour_at(pixel);
    write_pixel(pixel, speaker, centre, without_history(centre, speaker));
    return;
  }
  Neighbourhood n;
  if (needs_volume() || needs_blurred() || centres_input()) n = gather(pixel);
  else n.centre = n.blurred = colour_at(pixel);
  Reprojected r = reproject(pixel, speaker.at);
  take_history(r, read_history(r.at));
  r.alphas = read_alphas(r.at);
  if (keyed()) take_kept(r, speaker.key);
  if (relights) follow_light(r, speaker.around);
  vec3 found = to_working(r.found), bounded = found;
  if (needs_volume() && needs_bounds(speaker, r)) bounded = rectified(found, n.colours);
  float moved = needs_volume() ? moved_by(found, bounded) : 0;
  vec3 centre = centres_input() ? mix(n.centre, n.centred, centred_share(r)) : n.centre;
  Resolve result = resolve(r, speaker, rejection(r, speaker), centre, n.blurred, bounded, moved);
  write_pixel(pixel, speaker, n.centre, result);
}
