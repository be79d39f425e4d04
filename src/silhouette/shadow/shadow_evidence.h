#pragma once

#include <cstdint>
#include <vector>

#include "silhouette/background/row_kernels.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// The shades of an image, summed over blocks of 4 x 4 pixels: in a block's mean colour noise
/// cancels, so it tells a shadow from clothes where a pixel's own cannot.
class ShadowBlocks {
 public:
  static constexpr int kSide = ShadowColumns::kMostRows;

  struct Sums {
    float count = 0;         ///< of shades
    float now[3] = {};       ///< their colour in the image
    float expected[3] = {};  ///< and in the background
    float uneven = 0;        ///< squared deviations of their brightness from their block's mean
    float freedom = 0;       ///< how many of those are free
  };

  /// All sums are 0 afterwards. \param size of the image, px
  void resize(const cv::Size& size);
  /// Adds 64 columns, those of a mask's word, to a row of blocks.
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
  /// Of a block and its eight neighbours.
  Sums around(int column, int row) const;

 private:
  int cols_ = 0, rows_ = 0;
  std::vector<Sums> sums_;
  std::vector<size_t> filled_;  ///< of the sums
};

struct BlockShadowThresholds {
  bool is_grey;
  float gain;           ///< light of the image relative to the background's
  float chroma;         ///< how far a shadow's mean colour may be from its background's, relative
  float squared_noise;  ///< of a pixel, grey levels, squared
};

/// Turns those shades into foreground that are clothes, not shadow. Three kinds of evidence weigh
/// together: a shadow has its background's colour; it keeps the texture of what it falls on, so
/// its brightness ratio hardly varies from pixel to pixel; and clothes have more of the person
/// below them and beside them, a shadow on the floor has not. \param blocks the sums over `shade`
void restoreFalseShadows(const ShadowBlocks& blocks, const BlockShadowThresholds& limits,
                         BitMask* shadow, BitMask* foreground);

/// For each block of 4 x 4 pixels: whether the mask has pixels within `reach` blocks below it and
/// also above it or to a side.
BitMask enclosedBlocks(const BitMask& mask, int reach);

}  // namespace markerless_mocap
