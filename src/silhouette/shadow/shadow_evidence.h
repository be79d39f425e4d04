#pragma once

#include <cstdint>
#include <vector>

#include "silhouette/bits/bit_mask.h"
#include "silhouette/shadow/pixel_shadow.h"

namespace markerless_mocap {

/// The candidate shadow pixels of an image, summed over blocks of 4 x 4 pixels. A block's mean
/// colour has less noise than a pixel's, so it separates shadow from clothes better.
class ShadowBlocks {
 public:
  static constexpr int kSide = ShadowColumns::kMaxRows;

  struct Sums {
    float count = 0;         ///< number of candidate pixels
    float now[3] = {};       ///< sum of their colours in the image
    float expected[3] = {};  ///< sum of their colours in the background
    /// Sum of squared deviations of their brightness ratio from the block's mean.
    float uneven = 0;
    float degrees_of_freedom = 0;  ///< of `uneven`
  };

  /// Sets the size and clears all sums. \param size of the image, px
  void resize(const cv::Size& size);
  /// Adds the 64 columns of one word of a mask to a row of blocks.
  void add(const ShadowColumns& columns, int word, int row);
  int cols() const { return cols_; }
  int rows() const { return rows_; }
  const Sums& at(int column, int row) const { return sums_[size_t(row) * cols_ + column]; }
  bool isEmpty(int column, int row) const { return at(column, row).count == 0; }
  /// Calls `visit(column, row)` for each block that is not empty.
  template <class VisitT>
  void forEach(const VisitT& visit) const {
    for (const size_t i : filled_) visit(int(i % cols_), int(i / cols_));
  }
  /// Sums over a block and its eight neighbours.
  Sums around(int column, int row) const;

 private:
  int cols_ = 0, rows_ = 0;
  std::vector<Sums> sums_;
  std::vector<size_t> filled_;  ///< indices of the sums that are not empty
};

struct BlockShadowThresholds {
  bool is_grey;
  float gain;    ///< light of the image relative to the background's
  float chroma;  ///< maximum relative difference of a shadow's mean colour from the background's
  float squared_noise;  ///< of a pixel, grey levels, squared
};

/// Restores false shadows: candidate pixels that are clothes become foreground. Three kinds of
/// evidence are combined. A shadow has the background's colour. It keeps the texture of the
/// surface, so its brightness ratio hardly varies from pixel to pixel. And clothes have other parts
/// of the person below and beside them, while a shadow on the floor has not.
/// \param blocks sums over the pixels of `shadow`
void restoreFalseShadows(const ShadowBlocks& blocks, const BlockShadowThresholds& limits,
                         BitMask* shadow, BitMask* foreground);

/// For each block of 4 x 4 pixels: whether the mask has pixels within `reach` blocks below it, and
/// also above it or to one side.
BitMask enclosedBlocks(const BitMask& mask, int reach);

}  // namespace markerless_mocap
