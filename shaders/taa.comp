// The resolve as fast as a software device does it: an invocation does TAA_ROWS pixels above one another, which share the
// rows of their neighbourhoods. A row's minimum, maximum and sum are taken once and serve three pixels; colours are
// turned into the working space once and serve nine. What a GPU asks of it, it has, too: the lanes of a subgroup lie
// beside one another, so that every load and store is of neighbours; what the row's answers decide is decided when the
// pipeline is made, so that lanes part only where motion does; and the window of the history, which takes many
// registers, is in no GPU's pipeline: there Catmull-Rom goes through the sampler (filter_for in passes/taa.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#define TAA_FAST
#include "frame.glsl"
#include "shared/workgroup.h"
#include "taa_pixel.glsl"
#include "shared/taa_axes.h"

layout(local_size_x = TAA_GROUP_WIDTH) in;

const int R = int(TAA_ROWS), COLUMN = R + 2;  // with a row above and one below

/// Three columns of colours, row by row, in the working space; and each row's 1 2 1 of linear colours.
struct Strip {
  vec3 colours[3 * COLUMN];
  vec3 centres[COLUMN];  // linear
  vec3 blurred_rows[COLUMN];
  vec3 centred_rows[COLUMN];
};

Strip gather(ivec2 first) {
  Strip s;
  int last_y = last_pixel().y, last_x = last_pixel().x;
  int left = max(first.x - 1, 0), right = min(first.x + 1, last_x);
  vec3 weights = centred_weights(frame.jitter_px.x);
  for (int y = 0; y < COLUMN; ++y) {
    int at = clamp(first.y + y - 1, 0, last_y);
    vec3 a = colour_at(ivec2(left, at)), b = colour_at(ivec2(first.x, at)), c = colour_at(ivec2(right, at));
    s.centres[y] = b;
    if (needs_blurred()) s.blurred_rows[y] = (a + c) + 2 * b;
    if (centres_input()) s.centred_rows[y] = weights.x * a + weights.y * b + weights.z * c;
    s.colours[3 * y] = to_working(a), s.colours[3 * y + 1] = to_working(b), s.colours[3 * y + 2] = to_working(c);
  }
  return s;
}

Speaker speaker_with(ivec2 at, float loaded_depth) {
  return Speaker(at, comparable_depth(loaded_depth), reads_tags ? tag_of(loaded_depth) : 0, 0, nothing_around);
}

Speaker speaker_at(ivec2 at) {
  return speaker_with(at, asks_for_depth() || reads_tags ? loaded_depth(at) : 0);
}

/// The pixels that speak for these. Of equals the pixel itself, then the first: the row above, from the left.
void speakers_by_rank(ivec2 first, out Speaker speakers[R]) {
  float own[COLUMN], most[COLUMN];  // as loaded
  int column[COLUMN];
  int left = max(first.x - 1, 0), right = min(first.x + 1, last_pixel().x);
  for (int y = 0; y < COLUMN; ++y) {
    int at = clamp(first.y + y - 1, 0, last_pixel().y);
    float a = rank_at(ivec2(left, at)), b = rank_at(ivec2(first.x, at)), c = rank_at(ivec2(right, at));
    own[y] = b;
    most[y] = a, column[y] = left;
    if (rank_of(b) > rank_of(most[y])) most[y] = b, column[y] = first.x;
    if (rank_of(c) > rank_of(most[y])) most[y] = c, column[y] = right;
  }
  for (int i = 0; i < R; ++i) {
    ivec2 pixel = inside(first + ivec2(0, i)), at = ivec2(column[i], max(first.y + i - 1, 0));
    float best = most[i];
    if (rank_of(most[i + 1]) > rank_of(best)) best = most[i + 1], at = ivec2(column[i + 1], first.y + i);
    if (rank_of(most[i + 2]) > rank_of(best))
      best = most[i + 2], at = ivec2(column[i + 2], min(first.y + i + 1, last_pixel().y));
    bool moves = rank_of(best) > rank_of(own[i + 1]);
    if (dilation == dilation_depth_edges)
      moves = moves && (rank_of(best) > 1.2 * rank_of(own[i + 1]) || object_at(at) != object_at(pixel));
    if (asks_neighbours) moves = moves && push.dilates != 0;
    if (!moves) best = own[i + 1], at = pixel;
    speakers[i] = dilation == dilation_longest ? speaker_at(at) : speaker_with(at, best);
  }
}

/// What the keys of a row of three have in common, and which is the closest.
struct KeyRow {
  uint most, least, ids, sum;
  int column;
};

KeyRow key_row(uint a, uint b, uint c, ivec3 columns) {
  KeyRow r;
  r.most = a, r.column = columns.x;
  if (rank_of_key(b) > rank_of_key(r.most)) r.most = b, r.column = columns.y;
  if (rank_of_key(c) > rank_of_key(r.most)) r.most = c, r.column = columns.z;
  r.least = min(min(a, b), c);
  r.ids = id_bit_of_key(a) | id_bit_of_key(b) | id_bit_of_key(c);
  r.sum = light_step_of(a) + light_step_of(b) + light_step_of(c);
  return r;
}

Around around_by(uint own, KeyRow a, KeyRow b, KeyRow c) {
  uint most = max(max(a.most, b.most), c.most), least = min(min(a.least, b.least), c.least),
       ids = a.ids | b.ids | c.ids;
  float depth = depth_of_key(own);
  bool mixed = several(ids) || depth_of_key(most) > 1.25 * depth || depth_of_key(least) < 0.8 * depth;
  return Around(own, mixed, (ids & push.moved_ids) != 0, mean_lightness(a.sum + b.sum + c.sum));
}

/// As speakers_by_rank, by keys, and what those around say beside.
void speakers_by_key(ivec2 first, out Speaker speakers[R]) {
  KeyRow rows[COLUMN];
  uint own[COLUMN];
  ivec3 columns = ivec3(max(first.x - 1, 0), first.x, min(first.x + 1, last_pixel().x));
  for (int y = 0; y < COLUMN; ++y) {
    int at = clamp(first.y + y - 1, 0, last_pixel().y);
    own[y] = key_at(ivec2(columns.y, at));
    rows[y] = key_row(key_at(ivec2(columns.x, at)), own[y], key_at(ivec2(columns.z, at)), columns);
  }
  for (int i = 0; i < R; ++i) {
    ivec2 pixel = inside(first + ivec2(0, i)), at = ivec2(rows[i].column, max(first.y + i - 1, 0));
    uint key = rows[i].most;
    if (rank_of_key(rows[i + 1].most) > rank_of_key(key))
      key = rows[i + 1].most, at = ivec2(rows[i + 1].column, first.y + i);
    if (rank_of_key(rows[i + 2].most) > rank_of_key(key))
      key = rows[i + 2].most, at = ivec2(rows[i + 2].column, min(first.y + i + 1, last_pixel().y));
    bool moves = dilation == dilation_depth_edges ? is_edge(own[i + 1], key)
                                                  : dilation == dilation_closest_depth &&
                                                        rank_of_key(key) > rank_of_key(own[i + 1]);
    if (!moves) key = own[i + 1], at = pixel;
    bool asks = asks_for_depth() || reads_tags;
    speakers[i] = asks ? speaker_at(at) : speaker_with(at, 0);
    speakers[i].key = key, speakers[i].around = around_by(own[i + 1], rows[i], rows[i + 1], rows[i + 2]);
  }
}

void speakers_of(ivec2 first, out Speaker speakers[R]) {
  if (keyed()) {
    speakers_by_key(first, speakers);
    if (dilation != dilation_longest) return;
    Speaker by_motion[R];
    speakers_by_rank(first, by_motion);
    for (int i = 0; i < R; ++i) {
      by_motion[i].around = speakers[i].around;
      speakers[i] = by_motion[i], speakers[i].key = key_at(by_motion[i].at);
    }
    return;
  }
  bool asks = dilation != dilation_centre || asks_neighbours;
  if (asks && (has_history || writes != 0 || tests_tags())) speakers_by_rank(first, speakers);
  else
    for (int i = 0; i < R; ++i) speakers[i] = speaker_at(inside(first + ivec2(0, i)));
}

/// The box of each pixel's neighbourhood.
void boxes_of(Strip s, out vec3 low[R], out vec3 high[R]) {
  vec3 low_row[COLUMN], high_row[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    low_row[y] = min(min(s.colours[3 * y], s.colours[3 * y + 1]), s.colours[3 * y + 2]);
    high_row[y] = max(max(s.colours[3 * y], s.colours[3 * y + 1]), s.colours[3 * y + 2]);
  }
  for (int i = 0; i < R; ++i) {
    low[i] = min(min(low_row[i], low_row[i + 1]), low_row[i + 2]);
    high[i] = max(max(high_row[i], high_row[i + 1]), high_row[i + 2]);
  }
}

/// The box of mean and standard deviation.
void variance_boxes_of(Strip s, out vec3 low[R], out vec3 high[R]) {
  vec3 means[COLUMN], squares[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    ROW_MOMENTS(s.colours[3 * y], s.colours[3 * y + 1], s.colours[3 * y + 2], means[y], squares[y]);
  }
  for (int i = 0; i < R; ++i) {
    NINE_MOMENTS(vec3, i, means, squares, mean, reach);
    low[i] = mean - reach, high[i] = mean + reach;
  }
}

/// The slab across `axis`, for each pixel: what it leaves of the segment to its history.
void clip_along(vec3 axis, Strip s, vec3 histories[R], inout float share[R]) {
  float own[COLUMN], low[COLUMN], high[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    float a = dot(s.colours[3 * y], axis), b = dot(s.colours[3 * y + 1], axis), c = dot(s.colours[3 * y + 2], axis);
    own[y] = b, low[y] = min(min(a, b), c), high[y] = max(max(a, b), c);
  }
  for (int i = 0; i < R; ++i)
    share[i] = min(share[i], slab_share(min(min(low[i], low[i + 1]), low[i + 2]),
                                        max(max(high[i], high[i + 1]), high[i + 2]), own[i + 1],
                                        dot(histories[i], axis)));
}

void clip_variance_along(vec3 axis, Strip s, vec3 histories[R], inout float share[R]) {
  float own[COLUMN], means[COLUMN], squares[COLUMN];
  for (int y = 0; y < COLUMN; ++y) {
    float a = dot(s.colours[3 * y], axis), b = dot(s.colours[3 * y + 1], axis), c = dot(s.colours[3 * y + 2], axis);
    own[y] = b;
    ROW_MOMENTS(a, b, c, means[y], squares[y]);
  }
  for (int i = 0; i < R; ++i) {
    NINE_MOMENTS(float, i, means, squares, mean, reach);
    float from = own[i + 1];
    share[i] = min(share[i], slab_share(min(mean - reach, from), max(mean + reach, from), from, dot(histories[i], axis)));
  }
}

void rectify_all(Strip s, vec3 found[R], out vec3 bounded[R]) {
  float share[R];
  for (int i = 0; i < R; ++i) share[i] = 1e30;
  if (rectify == rectify_dop_clip) {
#define AXIS(x, y, z) clip_along(vec3(x, y, z), s, found, share);
    TAA_EACH_AXIS
#undef AXIS
    for (int i = 0; i < R; ++i) bounded[i] = on_segment(s.colours[3 * i + 4], found[i], share[i]);
    return;
  }
  if (rectify == rectify_dop_variance) {
#define AXIS(x, y, z) clip_variance_along(vec3(x, y, z), s, found, share);
    TAA_EACH_AXIS
#undef AXIS
    for (int i = 0; i < R; ++i) bounded[i] = on_segment(s.colours[3 * i + 4], found[i], share[i]);
    return;
  }
  vec3 low[R], high[R];
  if (rectify == rectify_box_clamp || rectify == rectify_box_clip) boxes_of(s, low, high);
  else variance_boxes_of(s, low, high);
  float brightest[COLUMN];
  for (int y = 0; y < COLUMN && may_brighten(); ++y)
    brightest[y] = max(max(weighted_luminance(s.colours[3 * y]), weighted_luminance(s.colours[3 * y + 1])),
                       weighted_luminance(s.colours[3 * y + 2]));
  for (int i = 0; i < R; ++i) {
    vec3 centre = s.colours[3 * i + 4];
    if (may_brighten())
      bounded[i] = not_brighter(clamp(found[i], low[i], high[i]), found[i],
                                max(max(brightest[i], brightest[i + 1]), brightest[i + 2]));
    else if (rectify == rectify_box_clamp || rectify == rectify_variance_clamp) bounded[i] = clamp(found[i], low[i], high[i]);
    else bounded[i] = clip_to_box(found[i], centre, min(low[i], centre), max(high[i], centre));
  }
}

/// Where no cause is known. A loop, which lanes that all know leave out as a whole; a branch would be taken by all of them.
void rectify_unknown(ivec2 first, Strip s, bool gathered, Speaker speakers[R], vec3 found[R], inout vec3 bounded[R]) {
  bool any_unknown = false;
  for (int i = 0; i < R; ++i) any_unknown = any_unknown || is_unknown(speakers[i]);
  for (uint round = any_unknown ? 0 : 1; round < 1; ++round) {
    if (!gathered) s = gather(first);
    rectify_all(s, found, bounded);
  }
  for (int i = 0; i < R; ++i)
    if (!is_unknown(speakers[i])) bounded[i] = found[i];
}

const int WINDOW_WIDTH = 5, WINDOW_HEIGHT = R + 4;

/// The four weights at one of two places of five.
float[5] placed(vec4 weights, bool later) {
  return later ? float[5](0, weights.x, weights.y, weights.z, weights.w)
               : float[5](weights.x, weights.y, weights.z, weights.w, 0);
}

/// A window of the history, from `corner` on; pixel i of the column looks i rows further down, and may look one more to
/// the right and down.
struct Window {
  ivec2 corner;
  vec3 texels[WINDOW_WIDTH * WINDOW_HEIGHT];
  float alphas[WINDOW_WIDTH * WINDOW_HEIGHT];
};

Window load_window(ivec2 corner) {
  Window w;
  w.corner = corner;
  for (int y = 0; y < WINDOW_HEIGHT; ++y)
    for (int x = 0; x < WINDOW_WIDTH; ++x) {
      vec4 texel = history_texel(corner + ivec2(x, y));
      w.texels[WINDOW_WIDTH * y + x] = texel.rgb;
      if (reads_alpha()) w.alphas[WINDOW_WIDTH * y + x] = texel.a;
    }
  return w;
}

/// As read_alphas.
vec4 alphas_in(Window w, int i, bvec2 later) {
  int at = WINDOW_WIDTH * (i + 1) + 1, below = at + WINDOW_WIDTH, last = below + WINDOW_WIDTH;
  vec3 first_row = vec3(w.alphas[at], w.alphas[at + 1], w.alphas[at + 2]),
       second_row = vec3(w.alphas[below], w.alphas[below + 1], w.alphas[below + 2]),
       third_row = vec3(w.alphas[last], w.alphas[last + 1], w.alphas[last + 2]);
  vec3 top = later.y ? second_row : first_row, bottom = later.y ? third_row : second_row;
  return later.x ? vec4(top.yz, bottom.yz) : vec4(top.xy, bottom.xy);
}

vec3 catmull_rom_in(Window w, int i, vec2 at) {
  vec2 f = fract(at - 0.5);
  bvec2 later = greaterThan(catmull_rom_corner(at) - ivec2(0, i), w.corner);
  float across[5] = placed(catmull_rom_weights(f.x), later.x), down[5] = placed(catmull_rom_weights(f.y), later.y);
  vec3 sum = vec3(0);
  for (int y = 0; y < 5; ++y) {
    vec3 row = vec3(0);
    for (int x = 0; x < 5; ++x) row += across[x] * w.texels[WINDOW_WIDTH * (i + y) + x];
    sum += down[y] * row;
  }
  return sum;
}

/// Without the corners: the middle two columns whole, of the outer two only the middle two rows.
vec3 catmull_rom_cross_in(Window w, int i, vec2 at) {
  vec2 f = fract(at - 0.5);
  bvec2 later = greaterThan(catmull_rom_corner(at) - ivec2(0, i), w.corner);
  vec4 across = catmull_rom_weights(f.x), down = catmull_rom_weights(f.y);
  float inner[5] = placed(vec4(0, across.yz, 0), later.x), outer[5] = placed(vec4(across.x, 0, 0, across.w), later.x),
        all_down[5] = placed(down, later.y), inner_down[5] = placed(vec4(0, down.yz, 0), later.y);
  vec3 sum = vec3(0);
  for (int y = 0; y < 5; ++y) {
    int row = WINDOW_WIDTH * (i + y);
    sum += all_down[y] * (inner[1] * w.texels[row + 1] + inner[2] * w.texels[row + 2] + inner[3] * w.texels[row + 3]);
    if (y > 0 && y < 4)
      sum += inner_down[y] * (outer[0] * w.texels[row] + outer[1] * w.texels[row + 1] + outer[3] * w.texels[row + 3] +
                              outer[4] * w.texels[row + 4]);
  }
  return sum / cross_share(across, down);
}

/// The bounds of the four texels around `at`.
void bounds_in(Window w, int i, vec2 at, out vec3 low, out vec3 high) {
  bvec2 later = greaterThan(catmull_rom_corner(at) - ivec2(0, i), w.corner);
  vec3 lows[3], highs[3];
  for (int y = 0; y < 3; ++y) {
    int row = WINDOW_WIDTH * (i + y + 1) + 1;
    vec3 a = w.texels[row], b = w.texels[row + 1], c = w.texels[row + 2];
    vec3 other = later.x ? c : a;
    lows[y] = min(b, other), highs[y] = max(b, other);
  }
  low = min(lows[1], later.y ? lows[2] : lows[0]), high = max(highs[1], later.y ? highs[2] : highs[0]);
}

Filtered filtered_in(Window w, int i, vec2 at) {
  Filtered r;
  r.colour = history_filter == history_catmull_rom_12 ? catmull_rom_cross_in(w, i, at) : catmull_rom_in(w, i, at);
  if (ringing == ringing_clamped) bounds_in(w, i, at, r.low, r.high);
  return r;
}

/// Pixels above one another mostly come from pixels above one another, give or take one: then 5 x (R + 4) loads do the
/// work of 16 x R. Those that come from elsewhere wait for another round.
void read_shared_histories(inout Reprojected r[R]) {
  bool done[R];
  ivec2 corners[R];
  for (int i = 0; i < R; ++i) done[i] = false, corners[i] = catmull_rom_corner(r[i].at) - ivec2(0, i);
  for (int round = 0; round < R; ++round) {
    ivec2 of_first = corners[R - 1];
    for (int i = R - 2; i >= 0; --i) of_first = done[i] ? of_first : corners[i];
    ivec2 corner = of_first;
    for (int i = 0; i < R; ++i)
      if (!done[i] && all(lessThanEqual(abs(corners[i] - of_first), ivec2(1)))) corner = min(corner, corners[i]);
    Window w = load_window(corner);
    bool all_done = true;
    for (int i = 0; i < R; ++i) {
      ivec2 off = corners[i] - w.corner;
      if (!done[i] && all(greaterThanEqual(off, ivec2(0))) && all(lessThanEqual(off, ivec2(1)))) {
        take_history(r[i], bounded(filtered_in(w, i, r[i].at)));
        if (reads_alpha()) r[i].alphas = alphas_in(w, i, greaterThan(off, ivec2(0)));
        done[i] = true;
      }
      all_done = all_done && done[i];
    }
    if (all_done) break;
  }
}

void read_histories(inout Reprojected r[R]) {
  bool by_loads = history_filter == history_catmull_rom || history_filter == history_catmull_rom_16 ||
                  history_filter == history_catmull_rom_12;
  if (by_loads) read_shared_histories(r);
  else
    for (int i = 0; i < R; ++i) {
      take_history(r[i], read_history(r[i].at));
      if (reads_alpha()) r[i].alphas = read_alphas(r[i].at);
    }
}

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.x, gl_WorkGroupID.y * TAA_ROWS), last = last_pixel();
  if (first.x > last.x) return;
  Speaker speakers[R];
  speakers_of(first, speakers);
  Reprojected r[R];
  vec3 found[R], clipped[R];
  if (has_history) {  // before the neighbourhood is read, so that not both of them have to be kept
    for (int i = 0; i < R; ++i) r[i] = reproject(first + ivec2(0, i), speakers[i].at);
    read_histories(r);
    for (int i = 0; i < R; ++i) {
      if (keyed()) take_kept(r[i]);
      if (rejects(reject_visibility)) follow_light(r[i], speakers[i].around);
      found[i] = clipped[i] = to_working(r[i].found);
    }
  }
  Strip s;
  bool bounds = has_history && needs_volume(), gathers = has_history && (needs_blurred() || centres_input());
  if (gathers || (bounds && !rectifies_unknown_only())) s = gather(first);
  else
    for (int i = 0; i < R; ++i) s.centres[i + 1] = colour_at(inside(first + ivec2(0, i)));
  if (bounds && rectifies_unknown_only()) rectify_unknown(first, s, gathers, speakers, found, clipped);
  else if (bounds) rectify_all(s, found, clipped);
  for (int i = 0; i < R; ++i) {
    ivec2 pixel = first + ivec2(0, i);
    if (pixel.y > last.y) return;
    vec3 centre = s.centres[i + 1];
    Resolve result = without_history(centre, speakers[i]);
    if (has_history) {
      vec3 blurred = needs_blurred()
                         ? (s.blurred_rows[i] + 2 * s.blurred_rows[i + 1] + s.blurred_rows[i + 2]) / 16
                         : centre;
      vec3 input_colour = centre;
      if (centres_input()) {
        vec3 down = centred_weights(frame.jitter_px.y);
        vec3 centred = down.x * s.centred_rows[i] + down.y * s.centred_rows[i + 1] + down.z * s.centred_rows[i + 2];
        input_colour = mix(centre, centred, fast_share(r[i]));
      }
      float moved = needs_volume() && (blend == blend_attenuated || writes_to(TAA_WRITES_WHY | TAA_WRITES_PROBE))
                        ? moved_by(found[i], clipped[i])
                        : 0;
      result = resolve(r[i], speakers[i], rejection(r[i], speakers[i]), input_colour, blurred, clipped[i], moved);
    }
    write_pixel(pixel, speakers[i], centre, result);
  }
}
