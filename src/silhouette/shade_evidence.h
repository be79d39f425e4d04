#pragma once

#include <cstdint>
#include <vector>

#include "silhouette/bit_mask.h"

namespace markerless_mocap {

/// How bright the shades of an image are, summed over blocks of 4 x 4 pixels.
class ShadeBlocks {
 public:
  static constexpr int kSide = 4;

  /// All sums are 0 afterwards. \param size of the image, px
  void resize(const cv::Size& size);
  /// \param ratio brightness relative to the background's, 255 for 1
  void add(int x, int y, uint8_t ratio) {
    Sums& sums = sums_[size_t(y / kSide) * cols_ + x / kSide];
    ++sums.count;
    sums.sum += ratio;
    sums.squares += uint32_t(ratio) * ratio;
  }
  int cols() const { return cols_; }
  int rows() const { return rows_; }
  bool isEmpty(int column, int row) const { return sums_[size_t(row) * cols_ + column].count == 0; }
  /// Variance of the ratio, 1 being full brightness, over a block and its eight neighbours.
  float variance(int column, int row) const;

 private:
  struct Sums {
    uint32_t count = 0, sum = 0, squares = 0;
  };

  int cols_ = 0, rows_ = 0;
  std::vector<Sums> sums_;
};

/// Makes those shades foreground that are clothes, not shadow. Two kinds of evidence weigh
/// together: a shadow keeps the texture of what it falls on, so its brightness ratio hardly varies
/// within a window; and clothes have more of the person below them and beside them, a shadow on the
/// floor has not. \param blocks the sums over `shade`
void restoreClothes(const BitMask& shade, const ShadeBlocks& blocks, BitMask* foreground);

/// For each block of 4 x 4 pixels: whether the mask has pixels within `reach` blocks below it and
/// also above it or to a side.
BitMask enclosedBlocks(const BitMask& mask, int reach);

}  // namespace markerless_mocap
