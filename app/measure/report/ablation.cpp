#include "app/measure/report/ablation.h"

#include <algorithm>

#include "app/measure/report/html.h"
#include "app/measure/report/variants.h"

namespace unghost {
namespace {

constexpr Part all_parts[] = {
    {"reject=off-screen+visibility",
     "Moved objects: a history that was another object's is given up where either of the two moves, or the "
     "picture does. Without it, what a vehicle uncovers shows the vehicle."},
    {"reject=off-screen+moved-object", "Light that changes: a history keeps how much light fell on it, and "
                                       "is lit anew where another amount falls. Without it, shadows trail."},
    {"dilation=centre", "Edges: a pixel follows the nearest surface of its 3x3, across an edge of depth or "
                        "object alone. Without it, the smooth edge of what moves stays behind."},
    {"rectify=none",
     "A bound for what is not known: what a glossy surface mirrors while anything moves, the edges of "
     "what moves, and what was lit anew are clipped to the box of the 3x3."},
    {"where=everywhere", "No bound for what is known: all else keeps its history whole, whatever the 3x3 "
                         "looks like. With it, the row is unghost-safe."},
    {"blend=constant", "Speed: each frame blurs a history that is read between its pixels. Where the picture "
                       "is fast, the new frame weighs more."},
    {"zoom-weight=0", "What comes nearer: it shows more detail than its history has. The new frame weighs "
                      "more by as much as it came nearer."},
    {"input=sampled", "The pixel's middle: the jitter samples the frame beside it. What enters the average "
                      "is interpolated back, wholly where the picture is fast."},
    {"jitter-moving=1",
     "Less jitter while the camera moves: motion itself brings every surface to other places of its pixels."},
    {"history=bilinear", "A sharp history: Catmull-Rom over 12 texels."},
    {"ringing=kept", "No ringing: what Catmull-Rom finds stays between the four texels that it lies among."},
};

} // namespace

std::span<const Part> parts() { return all_parts; }

std::string name_without(const Part& part) {
  return std::string(ablated_row) + ":" + std::string(part.change);
}

std::string parts_explained(std::span<const std::string> names) {
  std::string list;
  for (const Part& part : parts()) {
    if (std::ranges::find(names, name_without(part)) == names.end()) continue;
    const std::string change = change_of(name_without(part));
    list +=
        "<dt><code>" + escaped(change) + "</code></dt><dd>" + escaped(std::string(part.sentence)) + "</dd>\n";
  }
  if (list.empty()) return list;
  return "<p>A renderer does not have to guess from colours whether a history is wrong: it knows each "
         "pixel's object, depth, motion and light, this frame and last. <code>unghost</code> gives a history "
         "up, lights it anew or trusts it less for causes that are known, and bounds it by colours where "
         "none is. Below are its parts, by the setting that takes each of them out, and then what is more or "
         "less of each figure without it.</p>\n"
         "<dl class=\"parts\">\n" +
         list + "</dl>\n";
}

} // namespace unghost
