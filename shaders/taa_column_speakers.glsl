// Who speaks for the pixels of a column, by depth, by motion or by key.
#ifndef UNGHOST_TAA_COLUMN_SPEAKERS_GLSL
#define UNGHOST_TAA_COLUMN_SPEAKERS_GLSL

#include "taa_column.glsl"

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

/// What the keys of a row of three have in common, and which is the closest: of those as close the highest key, so what moves
/// before what rests; of equal keys the first.
struct KeyRow {
  uint most, least, ids, sum;
  int column;
};

KeyRow key_row(uint a, uint b, uint c, ivec3 columns) {
  KeyRow r;
  r.most = max(max(a, b), c);
  r.column = r.most == a ? columns.x : r.most == b ? columns.y : columns.z;
  r.least = min(min(a, b), c);
  r.ids = id_bit_of_key(a) | id_bit_of_key(b) | id_bit_of_key(c);
  r.sum = light_bits_of(a) + light_bits_of(b) + light_bits_of(c);
  return r;
}

Around around_by(uint own, KeyRow a, KeyRow b, KeyRow c) {
  uint most = max(max(a.most, b.most), c.most), least = min(min(a.least, b.least), c.least),
       ids = a.ids | b.ids | c.ids;
  return Around(own, several(ids) || mixes_depths(own, most, least), (ids & push.moved_ids) != 0, mean_lightness(a.sum + b.sum + c.sum));
}

/// The same by keys (key_row), and what those around say beside.
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
    ivec2 pixel = inside(first + ivec2(0, i));
    uint key = max(max(rows[i].most, rows[i + 1].most), rows[i + 2].most);
    ivec2 at = key == rows[i].most       ? ivec2(rows[i].column, max(first.y + i - 1, 0))
               : key == rows[i + 1].most ? ivec2(rows[i + 1].column, first.y + i)
                                         : ivec2(rows[i + 2].column, min(first.y + i + 1, last_pixel().y));
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

#endif
