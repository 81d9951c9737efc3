#include <algorithm>

#include "app/measure/flip.h"
#include "app/measure/magma.h"
#include "app/measure/report/html.h"
#include "app/measure/report/jpeg.h"
#include "app/measure/report/sections.h"

namespace unghost {
namespace {

/// What a page shows of a picture at most.
constexpr uint32_t window_width = 640, window_height = 360;

struct Window {
  uint32_t x = 0, y = 0, width = 0, height = 0;
};

template <class Pixel>
std::vector<Pixel> cut(const std::vector<Pixel>& pixels, uint32_t stride, size_t channels, const Window& w) {
  std::vector<Pixel> part;
  part.reserve(size_t(w.width) * w.height * channels);
  for (uint32_t y = w.y; y < w.y + w.height; ++y) {
    const auto row = pixels.begin() + std::ptrdiff_t((size_t(y) * stride + w.x) * channels);
    part.insert(part.end(), row, row + std::ptrdiff_t(w.width * channels));
  }
  return part;
}

Image cut(const Image& from, const Window& w) {
  return {.name = {}, .width = w.width, .height = w.height, .rgba = cut(from.rgba, from.width, 4, w)};
}

FloatImage cut(const FloatImage& from, const Window& w) {
  return {w.width, w.height, 1, cut(from.values, from.width, 1, w)};
}

/// Where the sum of the errors is largest, in steps of eight pixels; all of a picture that is small enough.
Window worst_window(const FloatImage& error) {
  const uint32_t width = error.width, height = error.height;
  Window best{0, 0, std::min(width, window_width), std::min(height, window_height)};
  if (best.width == width && best.height == height) return best;
  std::vector<double> sums(size_t(width + 1) * (height + 1)); // of all that is above and to the left
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      sums[size_t(y + 1) * (width + 1) + x + 1] =
          double(error.values[size_t(y) * width + x]) + sums[size_t(y) * (width + 1) + x + 1] +
          sums[size_t(y + 1) * (width + 1) + x] - sums[size_t(y) * (width + 1) + x];
  const auto at = [&](uint32_t x, uint32_t y) { return sums[size_t(y) * (width + 1) + x]; };
  double most = -1;
  for (uint32_t y = 0; y + best.height <= height; y += 8)
    for (uint32_t x = 0; x + best.width <= width; x += 8) {
      const uint32_t right = x + best.width, down = y + best.height;
      const double sum = at(right, down) - at(x, down) - at(right, y) + at(x, y);
      if (sum > most + 1e-9) most = sum, best.x = x, best.y = y;
    }
  return best;
}

std::string img(const Image& picture, const std::string& attributes, const std::string& alt) {
  return "<img " + attributes + "width=\"" + std::to_string(picture.width) + "\" height=\"" +
         std::to_string(picture.height) + "\" alt=\"" + escaped(alt) + "\" src=\"data:image/jpeg;base64," +
         base64(encode_jpeg(picture)) + "\">";
}

std::string figure(const Image& picture, const std::string& caption, const std::string& attributes = {}) {
  return "<figure>" + img(picture, attributes, caption) + "<figcaption>" + escaped(caption) +
         "</figcaption></figure>";
}

std::string cropped_note(const Window& w, uint32_t width, uint32_t height) {
  if (w.width == width && w.height == height) return {};
  return " The " + std::to_string(w.width) + "x" + std::to_string(w.height) +
         " pixels with the most error, from " + std::to_string(w.x) + ", " + std::to_string(w.y) + " of " +
         std::to_string(width) + "x" + std::to_string(height) + ".";
}

bool alike(const std::optional<Image>& a, const std::optional<Image>& b) {
  return a && b && a->width == b->width && a->height == b->height && a->width > 0 && a->height > 0;
}

std::string worst_frame(const KeptFrame& kept, const Looks& looks, const FindPicture& pictures,
                        const std::string& group, bool open) {
  const std::optional<Image> picture = pictures(kept, kept.picture),
                             reference = pictures(kept, kept.reference);
  if (!alike(picture, reference)) return {};
  const FloatImage error = flip(linear_from_srgb(*reference), linear_from_srgb(*picture));
  const Window window = worst_window(error);
  return "<details class=\"worst\" name=\"" + group + "\" data-mode=\"" + escaped(kept.mode) + "\"" +
         (open ? " open" : "") + "><summary>" +
         (looks.contains(kept.mode) ? mode_html(kept.mode, looks) : escaped(kept.mode)) +
         " <span class=\"count\">mean FLIP " + number(kept.flip, 4) + ", frame " +
         std::to_string(kept.frame) + "</span></summary><div class=\"three\">" +
         figure(cut(*picture, window), kept.mode) + figure(cut(*reference, window), "aliased reference") +
         figure(magma(cut(error, window)), "FLIP map: dark 0, bright 1") + "</div>" +
         (window.width == picture->width && window.height == picture->height
              ? ""
              : "<p class=\"note\">" + cropped_note(window, picture->width, picture->height) + "</p>") +
         "</details>\n";
}

struct Instant {
  const KeptFrame* kept;
  Image picture;
  FloatImage error;
};

/// Those of one frame whose picture is as large as the reference, the worst first.
std::vector<Instant> instants_of(const std::vector<const KeptFrame*>& frames, const Image& reference,
                                 const FindPicture& pictures) {
  std::vector<Instant> all;
  const FloatImage linear = linear_from_srgb(reference);
  for (const KeptFrame* kept : frames) {
    std::optional<Image> picture = pictures(*kept, kept->picture);
    if (!alike(picture, reference)) continue;
    FloatImage error = flip(linear, linear_from_srgb(*picture));
    all.push_back({kept, std::move(*picture), std::move(error)});
  }
  std::ranges::stable_sort(all, std::ranges::greater(), [](const Instant& one) { return one.kept->flip; });
  return all;
}

/// Of all modes, so that each shows the same place.
Window common_window(const std::vector<Instant>& instants) {
  FloatImage sum = instants.front().error;
  for (size_t i = 1; i < instants.size(); ++i)
    for (size_t at = 0; at < sum.values.size(); ++at) sum.values[at] += instants[i].error.values[at];
  return worst_window(sum);
}

/// A map needs no more to be read, and there are many.
FloatImage half_size(const FloatImage& error) {
  FloatImage half{std::max(1u, error.width / 2), std::max(1u, error.height / 2), 1, {}};
  for (uint32_t y = 0; y < half.height; ++y)
    for (uint32_t x = 0; x < half.width; ++x) {
      const size_t at = size_t(2 * y) * error.width + 2 * x, right = error.width > 1,
                   down = error.height > 1 ? error.width : 0;
      half.values.push_back((error.values[at] + error.values[at + right] + error.values[at + down] +
                             error.values[at + down + right]) /
                            4);
    }
  return half;
}

std::string instant_html(const std::vector<Instant>& instants, const Image& reference, uint32_t frame) {
  const Window window = common_window(instants);
  std::string html = "<div class=\"instant\"><p class=\"note\">Frame " + std::to_string(frame) +
                     ", all modes at the same instant, from the most error to the least." +
                     cropped_note(window, reference.width, reference.height) +
                     "</p><details class=\"stills\"><summary>All pictures and their FLIP maps</summary><div "
                     "class=\"many\">" +
                     figure(cut(reference, window), "supersampled reference", "data-picture=\"reference\" ");
  for (const Instant& one : instants) {
    const std::string mode = escaped(one.kept->mode);
    html += figure(cut(one.picture, window), one.kept->mode + ", mean FLIP " + number(one.kept->flip, 4),
                   "data-picture=\"" + mode + "\" ") +
            figure(magma(half_size(cut(one.error, window))), one.kept->mode + ", FLIP map",
                   "data-map=\"" + mode + "\" ");
  }
  return html + "</div></details></div>\n";
}

std::vector<const KeptFrame*> kept_of(const Measured& m, std::string_view kind) {
  std::vector<const KeptFrame*> frames;
  for (const KeptFrame& kept : m.kept)
    if (kept.kind == kind) frames.push_back(&kept);
  return frames;
}

} // namespace

std::string worst_frames(const Measured& m, const Looks& looks, const FindPicture& pictures,
                         const std::string& id) {
  std::vector<const KeptFrame*> frames = kept_of(m, "ghosting");
  std::ranges::stable_sort(frames, std::ranges::greater(), &KeptFrame::flip);
  std::string html;
  for (const KeptFrame* kept : frames)
    html += worst_frame(*kept, looks, pictures, id + "-worst", html.empty());
  return html;
}

std::string instant_pictures(const Measured& m, const FindPicture& pictures) {
  std::vector<const KeptFrame*> frames = kept_of(m, "error");
  std::string html;
  while (!frames.empty()) {
    const uint32_t frame = frames.front()->frame;
    std::vector<const KeptFrame*> now, later;
    for (const KeptFrame* kept : frames) (kept->frame == frame ? now : later).push_back(kept);
    if (const std::optional<Image> reference = pictures(*now.front(), now.front()->reference))
      if (const auto instants = instants_of(now, *reference, pictures); !instants.empty())
        html += instant_html(instants, *reference, frame);
    frames = later;
  }
  return html;
}

} // namespace unghost
