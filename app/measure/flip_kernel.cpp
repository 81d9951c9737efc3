#include "app/measure/flip_kernel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "shaders/shared/flip.h"

// Written once, compiled twice: processors with AVX2 take vectors of eight. Nothing is fused or reordered, so
// that both give the same bits.
#define UNGHOST_INLINE inline __attribute__((always_inline))

namespace unghost {
namespace {

/// To 2e-7 of itself, for finite positive numbers that are not denormal.
UNGHOST_INLINE float logarithm_2(float x) {
  const auto bits = std::bit_cast<int32_t>(x);
  const int32_t exponent = (bits - 0x3f3504f3) >> 23; // so that the rest lies around 1
  const float rest = std::bit_cast<float>(bits - (exponent << 23));
  const float s = (rest - 1) / (rest + 1), q = s * s;
  const float series = 1 + q * (1.f / 3 + q * (1.f / 5 + q * (1.f / 7 + q * (1.f / 9))));
  return float(exponent) + 2.88539008f * s * series;
}

/// To 2e-7 of itself, for -120 to 120.
UNGHOST_INLINE float power_of_2(float x) {
  const float shifted = x + 12582912.f; // rounds: 1.5 * 2^23
  const int32_t whole = std::bit_cast<int32_t>(shifted) - 0x4b400000;
  const float f = (x - (shifted - 12582912.f)) * 0.693147181f;
  const float series =
      1 + f * (1 + f * (1.f / 2 + f * (1.f / 6 + f * (1.f / 24 + f * (1.f / 120 + f * (1.f / 720))))));
  return std::bit_cast<float>(std::bit_cast<int32_t>(series) + (whole << 23));
}

/// x to the power p; 0 where x is nearly 0.
UNGHOST_INLINE float power(float x, float p) {
  const float safe = x > 1e-20f ? x : 1e-20f;
  const float exponent = p * logarithm_2(safe);
  const float result = power_of_2(exponent > -120 ? exponent : -120);
  return x > 1e-20f ? result : 0;
}

UNGHOST_INLINE float clamped(float x) { return x < 0 ? 0 : (x > 1 ? 1 : x); }

UNGHOST_INLINE float lab_root(float t) {
  constexpr float delta = FLIP_LAB_DELTA;
  const float linear = t / (3 * delta * delta) + 4.f / 29;
  return t > delta * delta * delta ? power(t, 1.f / 3) : linear;
}

/// CIELab after Hunt's effect: colours weigh less where it is dark.
struct Lab {
  float l, a, b;
};
UNGHOST_INLINE Lab hunted(float x, float y, float z) {
  const float fx = lab_root(x), fy = lab_root(y), fz = lab_root(z), l = 116 * fy - 16;
  return {l, FLIP_HUNT * l * (500 * (fx - fy)), FLIP_HUNT * l * (200 * (fy - fz))};
}
UNGHOST_INLINE Lab hunted_linear(float r, float g, float b) {
  return hunted(FLIP_X_OF_RED * r + FLIP_X_OF_GREEN * g + FLIP_X_OF_BLUE * b,
                FLIP_Y_OF_RED * r + FLIP_Y_OF_GREEN * g + FLIP_Y_OF_BLUE * b,
                FLIP_Z_OF_RED * r + FLIP_Z_OF_GREEN * g + FLIP_Z_OF_BLUE * b);
}
/// From filtered opponent colours, which may lie outside of what a screen shows.
UNGHOST_INLINE Lab hunted_opponent(float yy, float cx, float cz) {
  const float y = (yy + 16) * (1.f / 116), x = (y + cx * (1.f / 500)) * FLIP_WHITE_X,
              z = (y - cz * (1.f / 200)) * FLIP_WHITE_Z;
  return hunted_linear(clamped(FLIP_RED_OF_X * x + FLIP_RED_OF_Y * y + FLIP_RED_OF_Z * z),
                       clamped(FLIP_GREEN_OF_X * x + FLIP_GREEN_OF_Y * y + FLIP_GREEN_OF_Z * z),
                       clamped(FLIP_BLUE_OF_X * x + FLIP_BLUE_OF_Y * y + FLIP_BLUE_OF_Z * z));
}
UNGHOST_INLINE float distance(Lab p, Lab q) {
  const float l = p.l - q.l, a = p.a - q.a, b = p.b - q.b;
  return power((l < 0 ? -l : l) + std::sqrt(a * a + b * b), FLIP_DISTANCE_POWER);
}

/// So many pixels at a time stay in registers.
constexpr size_t block = 32;

/// Row buffers; those with ends to both sides are filtered along the row next.
struct Rows {
  Rows(size_t picture_width, size_t reach)
      : pad(reach), filled(picture_width), width(std::max(picture_width, block)) {
    for (auto* row : {&yy, &cx, &cz, &cz_wide, &g, &edge, &point}) row->resize(width + 2 * pad);
    for (auto* row : {&l, &a, &b, &edge_length, &point_length}) row->resize(width);
    above.resize(reach + 1), below.resize(reach + 1);
  }
  size_t pad, filled, width;
  std::vector<size_t> above, below;                       // what columns of filters see
  std::vector<float> yy, cx, cz, cz_wide, g, edge, point; // filtered down the columns
  std::vector<float> l, a, b, edge_length, point_length;
};

/// Where the rows lie that filters at one row see, the edge going on; from a column on.
struct Column {
  const float* plane;
  const size_t *above, *below; // starts of the rows 0, 1, ... away
};

UNGHOST_INLINE void down_block(const Column& from, const HalfFilter& half, float* __restrict to) {
  const float* middle = from.plane + from.above[0];
  float sum[block];
  for (size_t x = 0; x < block; ++x) sum[x] = half[0] * middle[x];
  for (size_t i = 1; i < half.size(); ++i) {
    const float *up = from.plane + from.above[i], *down = from.plane + from.below[i];
    for (size_t x = 0; x < block; ++x) sum[x] += half[i] * (up[x] + down[x]);
  }
  for (size_t x = 0; x < block; ++x) to[x] = sum[x];
}

UNGHOST_INLINE void features_down_block(const Column& from, const FlipFilters& f, float* __restrict to_g,
                                        float* __restrict to_edge, float* __restrict to_point) {
  const float* middle = from.plane + from.above[0];
  float g[block], edge[block], point[block];
  for (size_t x = 0; x < block; ++x)
    g[x] = f.gaussian[0] * middle[x], edge[x] = 0, point[x] = f.point[0] * middle[x];
  for (size_t i = 1; i < f.gaussian.size(); ++i) {
    const float *up = from.plane + from.above[i], *down = from.plane + from.below[i];
    const float wg = f.gaussian[i], we = f.edge[i], wp = f.point[i];
    for (size_t x = 0; x < block; ++x) {
      const float both = up[x] + down[x];
      g[x] += wg * both, point[x] += wp * both, edge[x] += we * (up[x] - down[x]);
    }
  }
  for (size_t x = 0; x < block; ++x) to_g[x] = g[x], to_edge[x] = edge[x], to_point[x] = point[x];
}

UNGHOST_INLINE void filter_down(const OpponentPlanes& picture, const FlipFilters& f, size_t y, Rows& rows) {
  for (size_t i = 0; i < rows.above.size(); ++i) {
    rows.above[i] = (y - std::min(i, y)) * picture.stride;
    rows.below[i] = std::min(y + i, picture.height - 1) * picture.stride;
  }
  for (size_t first = 0; first < rows.width; first += block) {
    const size_t x = std::min(first, rows.width - block), to = x + rows.pad;
    const auto column = [&](size_t plane) {
      return Column{picture.planes[plane].data() + x, rows.above.data(), rows.below.data()};
    };
    down_block(column(0), f.achromatic, &rows.yy[to]);
    down_block(column(1), f.red_green, &rows.cx[to]);
    down_block(column(2), f.blue_yellow, &rows.cz[to]);
    down_block(column(2), f.blue_yellow_wide, &rows.cz_wide[to]);
    features_down_block(column(0), f, &rows.g[to], &rows.edge[to], &rows.point[to]);
  }
}

inline void extend_ends(std::vector<float>& row, size_t pad, size_t filled) {
  std::fill_n(row.begin(), pad, row[pad]);
  std::fill(row.begin() + std::ptrdiff_t(pad + filled), row.end(), row[pad + filled - 1]);
}

/// `mirror` is 1 for a symmetric filter, -1 for an antisymmetric one.
template <int mirror>
UNGHOST_INLINE void along_block(const float* __restrict row, const HalfFilter& half, float* __restrict sum) {
  for (size_t x = 0; x < block; ++x) sum[x] = half[0] * row[x];
  for (size_t i = 1; i < half.size(); ++i)
    for (size_t x = 0; x < block; ++x) sum[x] += half[i] * (row[x - i] + float(mirror) * row[x + i]);
}

UNGHOST_INLINE void colours_of_row(Rows& rows, const FlipFilters& f) {
  for (size_t first = 0; first < rows.width; first += block) {
    const size_t at = std::min(first, rows.width - block) + rows.pad, to = at - rows.pad;
    float yy[block], cx[block], cz[block], wide[block];
    along_block<1>(&rows.yy[at], f.achromatic, yy);
    along_block<1>(&rows.cx[at], f.red_green, cx);
    along_block<1>(&rows.cz[at], f.blue_yellow, cz);
    along_block<1>(&rows.cz_wide[at], f.blue_yellow_wide, wide);
    for (size_t x = 0; x < block; ++x) {
      const Lab lab = hunted_opponent(yy[x], cx[x], cz[x] + wide[x]);
      rows.l[to + x] = lab.l, rows.a[to + x] = lab.a, rows.b[to + x] = lab.b;
    }
  }
}

UNGHOST_INLINE void features_of_row(Rows& rows, const FlipFilters& f) {
  for (size_t first = 0; first < rows.width; first += block) {
    const size_t at = std::min(first, rows.width - block) + rows.pad, to = at - rows.pad;
    float ex[block], ey[block], px[block], py[block];
    along_block<-1>(&rows.g[at], f.edge, ex);
    along_block<1>(&rows.edge[at], f.gaussian, ey);
    along_block<1>(&rows.g[at], f.point, px);
    along_block<1>(&rows.point[at], f.gaussian, py);
    for (size_t x = 0; x < block; ++x) {
      rows.edge_length[to + x] = std::sqrt(ex[x] * ex[x] + ey[x] * ey[x]);
      rows.point_length[to + x] = std::sqrt(px[x] * px[x] + py[x] * py[x]);
    }
  }
}

UNGHOST_INLINE void see_row(const OpponentPlanes& picture, const FlipFilters& f, size_t y, Rows& rows) {
  filter_down(picture, f, y, rows);
  for (auto* row : {&rows.yy, &rows.cx, &rows.cz, &rows.cz_wide, &rows.g, &rows.edge, &rows.point})
    extend_ends(*row, rows.pad, rows.filled);
  colours_of_row(rows, f);
  features_of_row(rows, f);
}

UNGHOST_INLINE void see(const OpponentPlanes& planes, const FlipFilters& f, size_t first, size_t last,
                        SeenPicture& out) {
  Rows rows(planes.width, f.reach);
  const auto keep = [&](const std::vector<float>& row, size_t y, std::vector<float>& plane) {
    std::copy_n(row.begin(), planes.width, plane.begin() + std::ptrdiff_t(y * planes.width));
  };
  for (size_t y = first; y < last; ++y) {
    see_row(planes, f, y - planes.top, rows);
    keep(rows.l, y, out.l), keep(rows.a, y, out.a), keep(rows.b, y, out.b);
    keep(rows.edge_length, y, out.edge), keep(rows.point_length, y, out.point);
  }
}

UNGHOST_INLINE void compare(const SeenPicture& r, const SeenPicture& t, size_t first, size_t count,
                            float* __restrict errors) {
  const float most = distance(hunted_linear(0, 1, 0), hunted_linear(0, 0, 1)), knee = FLIP_KNEE * most;
  for (size_t x = 0; x < count; ++x) {
    const size_t i = first + x;
    const float far = distance({r.l[i], r.a[i], r.b[i]}, {t.l[i], t.a[i], t.b[i]});
    const float above = FLIP_AT_KNEE + (far - knee) / (most - knee) * FLIP_ABOVE_KNEE;
    const float colour = far < knee ? FLIP_AT_KNEE / knee * far : above;
    const float edge = std::abs(r.edge[i] - t.edge[i]) * (1 / FLIP_LIGHTNESS_RANGE);
    const float point = std::abs(r.point[i] - t.point[i]) * (1 / FLIP_LIGHTNESS_RANGE);
    const float feature = std::sqrt((edge > point ? edge : point) * FLIP_FEATURE_SHARE);
    errors[x] = power(colour, 1 - feature);
  }
}

UNGHOST_INLINE void opponent(const float* __restrict rgb, size_t row, OpponentPlanes& to) {
  float* __restrict yy = &to.planes[0][row * to.stride];
  float* __restrict cx = &to.planes[1][row * to.stride];
  float* __restrict cz = &to.planes[2][row * to.stride];
  for (size_t i = 0; i < to.width; ++i) {
    const float r = clamped(rgb[3 * i]), g = clamped(rgb[3 * i + 1]), b = clamped(rgb[3 * i + 2]);
    const float xn = FLIP_X_OF_RED * r + FLIP_X_OF_GREEN * g + FLIP_X_OF_BLUE * b,
                yn = FLIP_Y_OF_RED * r + FLIP_Y_OF_GREEN * g + FLIP_Y_OF_BLUE * b,
                zn = FLIP_Z_OF_RED * r + FLIP_Z_OF_GREEN * g + FLIP_Z_OF_BLUE * b;
    yy[i] = 116 * yn - 16, cx[i] = 500 * (xn - yn), cz[i] = 200 * (yn - zn);
  }
}

#if defined(__x86_64__)
const bool wide_vectors = __builtin_cpu_supports("avx2");
__attribute__((target("avx2"))) void opponent_avx2(const float* rgb, size_t row, OpponentPlanes& to) {
  opponent(rgb, row, to);
}
__attribute__((target("avx2"))) void see_avx2(const OpponentPlanes& picture, const FlipFilters& f,
                                              size_t first, size_t last, SeenPicture& out) {
  see(picture, f, first, last, out);
}
__attribute__((target("avx2"))) void compare_avx2(const SeenPicture& r, const SeenPicture& t, size_t first,
                                                  size_t count, float* errors) {
  compare(r, t, first, count, errors);
}
#define UNGHOST_WIDEST(kernel) (wide_vectors ? kernel##_avx2 : kernel)
#else
#define UNGHOST_WIDEST(kernel) kernel
#endif

} // namespace

OpponentPlanes::OpponentPlanes(size_t picture_width, size_t picture_height)
    : width(picture_width), height(picture_height), stride(std::max(picture_width, block)) {
  for (std::vector<float>& plane : planes) plane.resize(stride * height);
}

void opponent_row(const float* rgb, size_t row, OpponentPlanes& to) {
  UNGHOST_WIDEST(opponent)(rgb, row, to);
}

void see_rows(const OpponentPlanes& planes, const FlipFilters& filters, size_t first, size_t last,
              SeenPicture& out) {
  UNGHOST_WIDEST(see)(planes, filters, first, last, out);
}

void compare_pixels(const SeenPicture& reference, const SeenPicture& test, size_t first, size_t count,
                    float* errors) {
  UNGHOST_WIDEST(compare)(reference, test, first, count, errors);
}

} // namespace unghost
