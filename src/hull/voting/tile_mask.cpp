#include "hull/voting/tile_mask.h"

#include <algorithm>

#include "hull/voting/mask_packing.h"

namespace markerless_mocap {

void TileBox::add(const TileBox& other) {
  x0 = std::min(x0, other.x0);
  y0 = std::min(y0, other.y0);
  x1 = std::max(x1, other.x1);
  y1 = std::max(y1, other.y1);
}

void TileMask::resize(int width, int height) {
  const int columns = (width + 7) / 8, rows = (height + 7) / 8;
  if (columns == columns_ && rows == rows_) return;
  columns_ = columns;
  rows_ = rows;
  stride_ = rows + 2;
  words_.assign(size_t(columns + 3) * stride_, 0);
  sums_.assign(size_t(columns + 1) * (rows + 1), 0);
}

void TileMask::pack(const cv::Mat& mask) {
  resize(mask.cols, mask.rows);
  for (int row = 0; row < rows_; ++row)
    packTileRow(mask.ptr(row * 8), mask.step, mask.cols, std::min(8, mask.rows - row * 8),
                &words_[row], stride_);
  sumTiles(mask.cols, mask.rows);
}

void TileMask::sumTiles(int width, int height) {
  set_pixels_ = 0;
  const uint64_t below = height % 8 == 0 ? 0 : ~uint64_t(0) << (height % 8 * 8);
  const uint64_t right = 0x0101010101010101u * (width % 8 == 0 ? 0 : 0xffu << (width % 8) & 0xffu);
  for (int column = 0; column < columns_; ++column) {
    // A tile at the edge of the image is full if all of its pixels in the image are set.
    const uint64_t beside = column == columns_ - 1 ? right : 0;
    const Sum* before = &sums_[sumAt(column, 0)];
    set_pixels_ += sumTileColumn(&words_[size_t(column) * stride_], rows_, beside, below, before,
                                 &sums_[sumAt(column + 1, 0)]);
  }
}

}  // namespace markerless_mocap
