#include "fleischmann/fitness/quad_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

// Minimum height of a side in pixels; flatter sides do not bound rows, as their inverse gradient is
// not finite.
constexpr float kFlat = 1e-6f;

/// A side of a quadrilateral, x as a function of y.
struct Line {
  float x, y, slope;
};

/// The left and right sides of a quadrilateral. A convex quadrilateral has at most three of each;
/// unused elements repeat another side.
struct Sides {
  Line left[3], right[3];
};

/// First pixel and end of each row's span; `low` is greater than `high` in an empty row.
MOCAP_WIDEST void findSpans(const Sides& sides, int first_row, int rows, int width, int32_t* low,
                            int32_t* high) {
  const Line l[3] = {sides.left[0], sides.left[1], sides.left[2]};
  const Line r[3] = {sides.right[0], sides.right[1], sides.right[2]};
  const float limit = float(width);
  for (int i = 0; i < rows; ++i) {
    const float y = float(first_row + i);
    const float left =
        std::max(std::max(l[0].x + (y - l[0].y) * l[0].slope, l[1].x + (y - l[1].y) * l[1].slope),
                 l[2].x + (y - l[2].y) * l[2].slope);
    const float right =
        std::min(std::min(r[0].x + (y - r[0].y) * r[0].slope, r[1].x + (y - r[1].y) * r[1].slope),
                 r[2].x + (y - r[2].y) * r[2].slope);
    const float from = std::min(std::max(left, 0.0f), limit);
    const float to = std::min(std::max(right, -1.0f), limit - 1.0f);
    const int32_t from_whole = int32_t(from), to_whole = int32_t(to);
    low[i] = from_whole + (float(from_whole) < from);
    high[i] = to_whole - (float(to_whole) > to) + 1;
  }
}

/// Sets the bits of the spans in one column. A shift by 32 is split in two, because it would be
/// undefined behaviour.
MOCAP_WIDEST void fillColumn(const int32_t* low, const int32_t* high, int rows, int first_pixel,
                             uint32_t* words) {
  for (int i = 0; i < rows; ++i) {
    const int32_t from = std::min(std::max(low[i] - first_pixel, 0), 32);
    const int32_t to = std::max(std::min(std::max(high[i] - first_pixel, 0), 32), from);
    const uint32_t from_half = uint32_t(from) >> 1, to_half = uint32_t(to) >> 1;
    const uint32_t above_from = (~0u << from_half) << (uint32_t(from) - from_half);
    const uint32_t above_to = (~0u << to_half) << (uint32_t(to) - to_half);
    words[i] |= above_from ^ above_to;
  }
}

MOCAP_COUNTING void countColumn(const uint32_t* drawn, const uint32_t* silhouette, int rows,
                                int64_t* sums) {
  int64_t count = 0, shared = 0;
  int i = 0;
  for (; i + 1 < rows; i += 2) {
    uint64_t a, b;
    std::memcpy(&a, drawn + i, sizeof(a));
    std::memcpy(&b, silhouette + i, sizeof(b));
    count += __builtin_popcountll(a);
    shared += __builtin_popcountll(a & b);
  }
  if (i < rows) {
    count += __builtin_popcount(drawn[i]);
    shared += __builtin_popcount(drawn[i] & silhouette[i]);
  }
  sums[0] += count;
  sums[1] += shared;
}

}  // namespace

struct QuadCanvas::Placed {
  Sides sides;
  int first_row, last_row, first_column, last_column;
};

QuadCanvas::QuadCanvas(int width, int height)
    : image_(width, height), low_(size_t(height)), high_(size_t(height)) {}

/// Returns false if no pixel can be inside.
bool QuadCanvas::place(const Quad& quad, int width, int height, Placed& out) {
  float x_low = quad.x[0], x_high = x_low, y_low = quad.y[0], y_high = y_low, area = 0.0f;
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) & 3;
    x_low = std::min(x_low, quad.x[i]);
    x_high = std::max(x_high, quad.x[i]);
    y_low = std::min(y_low, quad.y[i]);
    y_high = std::max(y_high, quad.y[i]);
    area += (quad.x[i] - quad.x[0]) * (quad.y[next] - quad.y[0]) -
            (quad.x[next] - quad.x[0]) * (quad.y[i] - quad.y[0]);
  }
  if (!(x_high >= 0.0f && x_low <= float(width - 1) && y_high >= 0.0f &&
        y_low <= float(height - 1)))
    return false;
  out.first_row = int(std::max(y_low, 0.0f));
  out.first_row += float(out.first_row) < y_low;
  out.last_row = int(std::min(y_high, float(height - 1)));
  out.first_column = int(std::max(x_low, 0.0f)) / 32;
  out.last_column = int(std::min(x_high, float(width - 1))) / 32;
  int lefts = 0, rights = 0;
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) & 3;
    const float rise = quad.y[next] - quad.y[i];
    if (std::abs(rise) < kFlat) continue;
    const Line line = {quad.x[i], quad.y[i], (quad.x[next] - quad.x[i]) / rise};
    // In a quadrilateral of positive area (y points down), the left sides go up.
    const bool left = (rise < 0.0f) == (area > 0.0f);
    if (left && lefts < 3) out.sides.left[lefts++] = line;
    if (!left && rights < 3) out.sides.right[rights++] = line;
  }
  if (lefts == 0 || rights == 0) return false;
  for (; lefts < 3; ++lefts) out.sides.left[lefts] = out.sides.left[0];
  for (; rights < 3; ++rights) out.sides.right[rights] = out.sides.right[0];
  return out.first_row <= out.last_row;
}

void QuadCanvas::fill(const Placed& quad) {
  const int rows = quad.last_row - quad.first_row + 1;
  findSpans(quad.sides, quad.first_row, rows, image_.width(), low_.data(), high_.data());
  for (int c = quad.first_column; c <= quad.last_column; ++c)
    fillColumn(low_.data(), high_.data(), rows, 32 * c, image_.column(c) + quad.first_row);
}

void QuadCanvas::draw(const Quad* quads, int count) {
  for (int c = 0; c < window_.columns; ++c)
    std::fill_n(image_.column(window_.first_column + c) + window_.first_row, window_.rows, 0u);
  int first_column = image_.columns(), last_column = -1, first_row = image_.height(), last_row = -1;
  for (int i = 0; i < count; ++i) {
    Placed quad;
    if (!place(quads[i], image_.width(), image_.height(), quad)) continue;
    fill(quad);
    first_column = std::min(first_column, quad.first_column);
    last_column = std::max(last_column, quad.last_column);
    first_row = std::min(first_row, quad.first_row);
    last_row = std::max(last_row, quad.last_row);
  }
  window_ = {first_column, std::max(0, last_column - first_column + 1), first_row,
             std::max(0, last_row - first_row + 1)};
}

Overlap QuadCanvas::overlap(const BitImage& silhouette) const {
  int64_t sums[2] = {0, 0};
  for (int c = 0; c < window_.columns; ++c) {
    const int column = window_.first_column + c;
    countColumn(image_.column(column) + window_.first_row,
                silhouette.column(column) + window_.first_row, window_.rows, sums);
  }
  return {sums[0], sums[1]};
}

}  // namespace markerless_mocap
