#include "app/difference.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace unghost {
namespace {

constexpr uint32_t block = 4;

/// One number a block of 4x4 pixels.
struct Blocks {
  uint32_t width = 0, height = 0;
  std::vector<double> values;
};

double block_difference(const Image& a, const Image& b, uint32_t column, uint32_t row) {
  double sum[3] = {};
  for (uint32_t y = row * block; y < (row + 1) * block; ++y)
    for (uint32_t x = column * block; x < (column + 1) * block; ++x)
      for (uint32_t c = 0; c < 3; ++c) {
        const size_t at = (size_t(y) * a.width + x) * 4 + c;
        sum[c] += double(a.rgba[at]) - double(b.rgba[at]);
      }
  return std::abs(sum[0]) + std::abs(sum[1]) + std::abs(sum[2]);
}

/// Entry (x, y) is the sum over all blocks left of x and above y, so it has one row and one column more.
Blocks summed_differences(const Image& a, const Image& b) {
  Blocks sums{.width = a.width / block + 1, .height = a.height / block + 1, .values = {}};
  sums.values.assign(size_t(sums.width) * sums.height, 0.0);
  for (uint32_t y = 1; y < sums.height; ++y) {
    double row = 0;
    for (uint32_t x = 1; x < sums.width; ++x) {
      row += block_difference(a, b, x - 1, y - 1);
      sums.values[size_t(y) * sums.width + x] = sums.values[size_t(y - 1) * sums.width + x] + row;
    }
  }
  return sums;
}

bool overlap(const Window& a, const Window& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

// Windows start on a block and lie in the picture; what of them is no whole block is not weighed.
std::optional<Window> best_window(const Blocks& sums, const Image& picture, const Window& size,
                                  const std::vector<Window>& taken) {
  const uint32_t columns = std::max(1u, size.width / block), rows = std::max(1u, size.height / block);
  const auto at = [&](uint32_t x, uint32_t y) { return sums.values[size_t(y) * sums.width + x]; };
  std::optional<Window> best;
  double most = 0; // pictures that are the same everywhere have no window worth a look
  for (uint32_t y = 0; y + rows < sums.height && y * block + size.height <= picture.height; ++y)
    for (uint32_t x = 0; x + columns < sums.width && x * block + size.width <= picture.width; ++x) {
      const Window window{x * block, y * block, size.width, size.height};
      const double sum = at(x + columns, y + rows) - at(x, y + rows) - at(x + columns, y) + at(x, y);
      if (sum <= most || std::ranges::any_of(taken, [&](const Window& w) { return overlap(w, window); }))
        continue;
      best = window, most = sum;
    }
  return best;
}

} // namespace

std::vector<Window> windows_of_difference(const Image& a, const Image& b, uint32_t width, uint32_t height,
                                          size_t count) {
  std::vector<Window> windows;
  if (width == 0 || height == 0) return windows;
  const Blocks sums = summed_differences(a, b);
  while (windows.size() < count) {
    const std::optional<Window> window = best_window(sums, a, {0, 0, width, height}, windows);
    if (!window) break;
    windows.push_back(*window);
  }
  return windows;
}

} // namespace unghost
