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
#include "taa_column_colours.glsl"
#include "taa_column_histories.glsl"
#include "taa_column_speakers.glsl"
#include "taa_store.glsl"

layout(local_size_x = TAA_GROUP_WIDTH) in;

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
      if (keyed()) take_kept(r[i], speakers[i].key);
      if (relights) follow_light(r[i], speakers[i].around);
      found[i] = clipped[i] = to_working(r[i].found);
    }
  }
  Strip s;
  bool bounds = has_history && needs_volume();
  if (bounds || (has_history && (needs_blurred() || centres_input()))) s = gather(first);
  else
    for (int i = 0; i < R; ++i) s.centres[i + 1] = colour_at(inside(first + ivec2(0, i)));
  if (bounds) rectify_histories(s, found, clipped);
  for (int i = 0; i < R; ++i) {
    ivec2 pixel = first + ivec2(0, i);
    if (pixel.y > last.y) return;
    if (has_history && rectifies_unknown_only() && !needs_bounds(speakers[i], r[i])) clipped[i] = found[i];
    vec3 centre = s.centres[i + 1];
    Resolve result = without_history(centre, speakers[i]);
    if (has_history) {
      vec3 blurred = needs_blurred()
                         ? (s.blurred_rows[i] + 2 * s.blurred_rows[i + 1] + s.blurred_rows[i + 2]) / 16
                         : centre;
      vec3 input_colour = centres_input() ? mix(centre, centred_of(s, i), centred_share(r[i])) : centre;
      float moved = needs_volume() && (blend == blend_attenuated || writes_to(TAA_WRITES_WHY | TAA_WRITES_PROBE))
                        ? moved_by(found[i], clipped[i])
                        : 0;
      result = resolve(r[i], speakers[i], rejection(r[i], speakers[i]), input_colour, blurred, clipped[i], moved);
    }
    write_pixel(pixel, speakers[i], centre, result);
  }
}
