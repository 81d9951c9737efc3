#include "app/picture_grid.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/label.h"

namespace unghost {
namespace {

struct Colour {
  uint8_t r, g, b;
};

constexpr Colour background{20, 20, 22};
constexpr Colour crop_colours[crops_a_row] = {{255, 200, 40}, {70, 220, 255}};

struct Place {
  uint32_t x = 0, y = 0;
};

/// Everything in pixels.
struct Layout {
  uint32_t count = 1, columns = 1, rows = 1;
  uint32_t border = 0; // around and between cells
  uint32_t cell_width = 0, cell_height = 0;
  uint32_t text_scale = 1;

  // A last row that is not full stands in the middle.
  Place cell(size_t index) const {
    const uint32_t column = uint32_t(index) % columns, row = uint32_t(index) / columns;
    const uint32_t empty = row + 1 == rows ? columns * rows - count : 0, step = cell_width + border;
    return {border + column * step + empty * step / 2, border + row * (cell_height + border)};
  }
};

// As near to twice as wide as high as the cells allow, with few cells left empty.
uint32_t best_columns(size_t count, double cell_aspect) {
  uint32_t best = 1;
  double least = 1e9;
  for (uint32_t columns = 1; columns <= count; ++columns) {
    const size_t rows = (count + columns - 1) / columns;
    const double aspect = cell_aspect * columns / double(rows);
    const double empty = double(rows * columns - count) / double(count);
    const double cost = std::abs(std::log(aspect / 2)) + empty;
    if (cost < least) best = columns, least = cost;
  }
  return best;
}

Layout layout_of(size_t count, const Image& first, bool with_crops) {
  Layout layout;
  layout.count = uint32_t(count);
  layout.text_scale = label_scale(first.height);
  layout.border = 4 * layout.text_scale;
  layout.cell_width = first.width;
  layout.cell_height = first.height;
  if (with_crops) layout.cell_height += layout.border + first.height / crop_share * crop_zoom;
  layout.columns = best_columns(count, double(layout.cell_width) / layout.cell_height);
  layout.rows = uint32_t((count + layout.columns - 1) / layout.columns);
  return layout;
}

Image canvas_of(const Layout& layout) {
  Image canvas;
  canvas.width = layout.columns * (layout.cell_width + layout.border) + layout.border;
  canvas.height = layout.rows * (layout.cell_height + layout.border) + layout.border;
  canvas.rgba.resize(size_t(canvas.width) * canvas.height * 4);
  for (size_t i = 0; i < canvas.rgba.size(); i += 4)
    canvas.rgba[i] = background.r, canvas.rgba[i + 1] = background.g, canvas.rgba[i + 2] = background.b,
    canvas.rgba[i + 3] = 255;
  return canvas;
}

void set(Image& canvas, uint32_t x, uint32_t y, Colour colour) {
  if (x >= canvas.width || y >= canvas.height) return;
  uint8_t* pixel = canvas.rgba.data() + (size_t(y) * canvas.width + x) * 4;
  pixel[0] = colour.r, pixel[1] = colour.g, pixel[2] = colour.b;
}

void copy(Image& canvas, const Image& picture, Place place) {
  for (uint32_t y = 0; y < picture.height; ++y)
    std::memcpy(canvas.rgba.data() + (size_t(place.y + y) * canvas.width + place.x) * 4,
                picture.rgba.data() + size_t(y) * picture.width * 4, size_t(picture.width) * 4);
}

void copy_enlarged(Image& canvas, const Image& picture, const Window& window, Place place) {
  for (uint32_t y = 0; y < window.height * crop_zoom; ++y)
    for (uint32_t x = 0; x < window.width * crop_zoom; ++x) {
      const uint8_t* from = picture.rgba.data() +
                            (size_t(window.y + y / crop_zoom) * picture.width + window.x + x / crop_zoom) * 4;
      set(canvas, place.x + x, place.y + y, {from[0], from[1], from[2]});
    }
}

void draw_frame(Image& canvas, Place place, uint32_t width, uint32_t height, uint32_t thickness,
                Colour colour) {
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      if (x < thickness || y < thickness || x + thickness >= width || y + thickness >= height)
        set(canvas, place.x + x, place.y + y, colour);
}

void draw_crops(Image& canvas, const Image& picture, std::span<const Window> crops, Place cell,
                const Layout& layout) {
  Place below{cell.x, cell.y + picture.height + layout.border};
  for (size_t i = 0; i < crops.size(); ++i) {
    const Window& window = crops[i];
    const Colour colour = crop_colours[i % crops_a_row];
    const uint32_t width = window.width * crop_zoom, height = window.height * crop_zoom;
    copy_enlarged(canvas, picture, window, below);
    draw_frame(canvas, below, width, height, layout.text_scale, colour);
    draw_frame(canvas, {cell.x + window.x, cell.y + window.y}, window.width, window.height, layout.text_scale,
               colour);
    below.x += width;
  }
}

} // namespace

Image picture_grid(std::span<const LabelledPicture> pictures, std::span<const Window> crops) {
  const Layout layout = layout_of(pictures.size(), pictures.front().picture, !crops.empty());
  Image canvas = canvas_of(layout);
  for (size_t i = 0; i < pictures.size(); ++i) {
    const Place cell = layout.cell(i);
    copy(canvas, pictures[i].picture, cell);
    draw_crops(canvas, pictures[i].picture, crops, cell, layout);
    draw_label(canvas, pictures[i].label, {cell.x, cell.y, layout.cell_width, layout.cell_height},
               layout.text_scale);
  }
  return canvas;
}

} // namespace unghost
