#include "contour/fit/outline.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "markerless_mocap/products/silhouette_mask.h"
#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

constexpr int kWord = 8;  // pixels compared at once

uint64_t wordAt(const uchar* row) {
  uint64_t word;
  std::memcpy(&word, row, kWord);
  return word;
}

/// Finds cracks between the pixels of `row` and those of `other`, for x in [first, last).
/// \param dx, dy half pixels from the first pixel to the crack
void compareRows(const uchar* row, const uchar* other, int first, int last, int y, int dx, int dy,
                 std::vector<Crack>& cracks) {
  for (int x = first; x < last;) {
    if (x + kWord <= last && wordAt(row + x) == wordAt(other + x)) {
      x += kWord;
      continue;
    }
    const int end = std::min(x + kWord, last);
    for (; x < end; ++x)
      if ((row[x] != 0) != (other[x] != 0) && row[x] != kUnknownPixel && other[x] != kUnknownPixel)
        cracks.push_back({int16_t(2 * x + dx), int16_t(2 * y + dy)});
  }
}

// Pixels along an edge of a square that holds each disk. Its first pixel is the disk's first.
constexpr int kDiskSide = 16;
static_assert(2 * kMaxNormalRadius + 2 <= kDiskSide);

/// Weights of a square's pixels, and their offsets from a crack in half pixels.
struct Disk {
  int16_t weights[kDiskSide][kDiskSide] = {};
  int16_t dx[kDiskSide] = {}, dy[kDiskSide] = {};  ///< of columns and rows
};

/// \param odd_x whether the crack lies between two columns, else between two rows
constexpr Disk diskOf(int radius, bool odd_x) {
  Disk disk;
  for (int i = 0; i < kDiskSide; ++i) {
    disk.dx[i] = int16_t(2 * (i - radius) - (odd_x ? 1 : 0));
    disk.dy[i] = int16_t(2 * (i - radius) - (odd_x ? 0 : 1));
  }
  const int reach = 2 * radius + 1;
  for (int y = 0; y < kDiskSide; ++y)
    for (int x = 0; x < kDiskSide; ++x) {
      const int weight = reach * reach - disk.dx[x] * disk.dx[x] - disk.dy[y] * disk.dy[y];
      disk.weights[y][x] = int16_t(weight > 0 ? weight : 0);
    }
  return disk;
}

using Disks = std::array<Disk, kMaxNormalRadius + 1>;  // by radius

constexpr Disks disks(bool odd_x) {
  Disks all;
  for (int radius = 0; radius <= kMaxNormalRadius; ++radius)
    all[size_t(radius)] = diskOf(radius, odd_x);
  return all;
}

constexpr std::array<Disks, 2> kDisks{disks(false), disks(true)};

/// The square whose first pixel is x, y, also beyond the image.
void copyPatch(const cv::Mat& mask, int x, int y, uchar* patch) {
  for (int v = 0; v < kDiskSide; ++v) {
    const uchar* row = mask.ptr<uchar>(std::clamp(y + v, 0, mask.rows - 1));
    for (int u = 0; u < kDiskSide; ++u) *patch++ = row[std::clamp(x + u, 0, mask.cols - 1)];
  }
}

/// Adds up offsets of the person's pixels by their weights, along x and y. Everything fits into 16
/// bits. \param side kDiskSide; the compiler makes vectors only of loops whose length it does not
/// know
MOCAP_VECTORISED void sumDisk(const uchar* __restrict first, size_t step, const Disk& disk,
                              int side, int* __restrict sums) {
  int16_t all[kDiskSide] = {}, along_y[kDiskSide] = {};
  for (int y = 0; y < side; ++y, first += step)
    for (int x = 0; x < side; ++x) {
      const auto here = int16_t(disk.weights[y][x] & -int16_t(first[x] != kBackgroundPixel));
      all[x] = int16_t(all[x] + here);
      along_y[x] = int16_t(along_y[x] + here * disk.dy[y]);
    }
  for (int x = 0; x < side; ++x) {
    sums[0] += all[x] * disk.dx[x];
    sums[1] += along_y[x];
  }
}

/// Adds the row's bits to those of all rows. Returns whether it has any.
MOCAP_VECTORISED bool addRow(const uchar* __restrict row, int count, uchar* __restrict all) {
  uchar any = 0;
  for (int i = 0; i < count; ++i) {
    any |= row[i];
    all[i] |= row[i];
  }
  return any != 0;
}

}  // namespace

cv::Rect shownBox(const cv::Mat& mask) {
  std::vector<uchar> columns(size_t(mask.cols), 0);
  int top = -1, bottom = -1;
  for (int y = 0; y < mask.rows; ++y) {
    if (!addRow(mask.ptr(y), mask.cols, columns.data())) continue;
    if (top < 0) top = y;
    bottom = y;
  }
  if (top < 0) return {};
  const auto shown = [](uchar column) { return column != kBackgroundPixel; };
  const auto left = std::find_if(columns.begin(), columns.end(), shown);
  const auto right = std::find_if(columns.rbegin(), columns.rend(), shown).base();
  return {int(left - columns.begin()), top, int(right - left), bottom - top + 1};
}

void findCracks(const cv::Mat& mask, const cv::Rect& box, std::vector<Crack>& cracks) {
  // The box grows by one pixel on every side, but not to the border of the image.
  const int left = std::max(box.x - 1, 1), right = std::min(box.x + box.width, mask.cols - 2);
  const int top = std::max(box.y - 1, 1), bottom = std::min(box.y + box.height, mask.rows - 2);
  for (int y = top; y <= bottom; ++y) {
    const uchar* row = mask.ptr<uchar>(y);
    compareRows(row, row + 1, left, right, y, 1, 0, cracks);
    if (y < bottom) compareRows(row, mask.ptr<uchar>(y + 1), left, right + 1, y, 0, 1, cracks);
  }
}

Eigen::Vector2d outwardNormal(const cv::Mat& mask, const Crack& crack, int radius) {
  const Disk& disk = kDisks[size_t(crack.x2 & 1)].at(size_t(radius));
  const int x = (crack.x2 >> 1) - radius, y = (crack.y2 >> 1) - radius;
  std::array<uchar, kDiskSide * kDiskSide> patch;
  const uchar* first = patch.data();
  size_t step = kDiskSide;
  if (x < 0 || y < 0 || x + kDiskSide > mask.cols || y + kDiskSide > mask.rows) {
    copyPatch(mask, x, y, patch.data());
  } else {
    first = mask.ptr<uchar>(y, x);
    step = mask.step;
  }
  std::array<int, 2> inward{};
  sumDisk(first, step, disk, kDiskSide, inward.data());
  return {-inward[0], -inward[1]};
}

}  // namespace markerless_mocap
