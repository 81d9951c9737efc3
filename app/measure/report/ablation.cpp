#include "app/measure/report/ablation.h"

#include <algorithm>

#include "app/measure/report/html.h"

namespace unghost {
namespace {

constexpr Part all_parts[] = {
    {"reject=off-screen+visibility", "without moved objects",
     "A history that was another object's is given up where either of the two moves, or, where the picture "
     "moves, most of it was. Without it, what a vehicle uncovers shows the vehicle."},
    {"reject=off-screen+moved-object", "without light that changes",
     "A history keeps how much light fell on it, and is lit anew where another amount falls. Without it, "
     "shadows trail."},
    {"dilation=centre", "without dilation at edges",
     "A pixel follows the nearest surface of its 3x3, across an edge of depth or object alone. Without it, "
     "the smooth edge of what moves stays behind."},
    {"rectify=none", "without a bound for the unknown",
     "What a glossy surface mirrors while anything moves or light changes, edges that move, and what was lit "
     "anew are clipped to the box of the 3x3."},
    {"where=everywhere", "with a bound for the known, too",
     "All else keeps its history whole, whatever the 3x3 looks like. With a bound for it, too, the row is "
     "unghost-safe."},
    {"fast-alpha=0.08", "without the weight by speed",
     "Each frame blurs a history that is read between its pixels. Where the picture is fast, the new frame "
     "weighs more."},
    {"zoom-weight=0", "without the weight by nearness",
     "What comes nearer shows more detail than its history has. The new frame weighs more by as much as it "
     "came nearer."},
    {"blend=constant", "with one weight for all frames",
     "Speed, nearness and age together: what has come into view is the mean of its first frames. Without "
     "all three, each new frame weighs the same."},
    {"input=sampled", "without the pixel's middle",
     "The jitter samples the frame beside the middle of a pixel. What enters the average is interpolated "
     "back, wholly where the picture is fast."},
    {"centred-rest=1", "with the middle alone at rest",
     "At rest half of the sample beside the middle goes in, too: the average of many finds what lies between "
     "the middles."},
    {"jitter-moving=1", "with all of the jitter in motion",
     "There is less jitter while the camera moves: motion itself brings every surface to other places of its "
     "pixels."},
    {"history=bilinear", "with a bilinear history", "The history is sharp: Catmull-Rom over 12 texels."},
    {"ringing=kept", "with ringing",
     "What Catmull-Rom finds stays between the four texels that it lies among."},
};

} // namespace

std::span<const Part> parts() { return all_parts; }

std::string name_without(const Part& part) {
  return std::string(ablated_row) + ":" + std::string(part.change);
}

const Part* find_part(std::string_view name) {
  const auto found = std::ranges::find(all_parts, name, name_without);
  return found == std::end(all_parts) ? nullptr : &*found;
}

std::string parts_explained(std::span<const std::string> names) {
  std::string list;
  for (const Part& part : parts()) {
    if (std::ranges::find(names, name_without(part)) == names.end()) continue;
    list += "<dt>" + escaped(part.name) + "<small><code>" + escaped(part.change) +
            "</code></small></dt><dd>" + escaped(part.sentence) + "</dd>\n";
  }
  if (list.empty()) return list;
  return "<p>A renderer does not have to guess from colours whether a history is wrong: it knows each "
         "pixel's object, depth, motion and light, this frame and last. <code>unghost</code> gives a history "
         "up, lights it anew or trusts it less for causes that are known, and bounds it by colours where "
         "none is. Below are its parts, by what the row is without each of them, and then what is more or "
         "less of each figure there.</p>\n"
         "<dl class=\"parts\">\n" +
         list + "</dl>\n";
}

} // namespace unghost
