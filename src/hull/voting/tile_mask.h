#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// Rectangle of 8 x 8 pixel tiles: columns x0 to x1 - 1, rows y0 to y1 - 1. Empty: x1 is 0.
struct TileBox {
  uint16_t x0 = 0xffff, y0 = 0xffff, x1 = 0, y1 = 0;

  void add(const TileBox& other);
  uint32_t count() const { return uint32_t(x1 - x0) * uint32_t(y1 - y0); }
};

/// Number of tiles of a rectangle with any pixel set, and with all pixels set.
struct TileCount {
  uint32_t any, all;
};

/// A silhouette as bits: one 64-bit word per tile of 8 x 8 pixels (bit 8 * row + column), stored
/// column by column. A summed-area table gives the number of tiles with any and with all pixels set
/// in any rectangle of tiles.
class TileMask {
 public:
  /// \param mask CV_8UC1, not 0 where set. Reuses the memory of the last mask.
  void pack(const cv::Mat& mask);

  size_t setPixels() const { return set_pixels_; }
  TileCount count(const TileBox& box) const {
    const Sum sum = sums_[sumAt(box.x1, box.y1)] - sums_[sumAt(box.x0, box.y1)] -
                    sums_[sumAt(box.x1, box.y0)] + sums_[sumAt(box.x0, box.y0)];
    return {uint32_t(sum), uint32_t(sum >> 32)};
  }
  bool at(int x, int y) const { return pixels(x >> 3, y)[0] >> (x & 7) & 1; }
  uint64_t tile(int column, int row) const { return words_[size_t(column) * stride_ + row]; }
  /// Rows y, y + 1, ... of one column of tiles, one byte for eight pixels; the lowest bit is the
  /// leftmost pixel. At least 16 rows and two further columns can be read; pixels outside the image
  /// are clear.
  const uint8_t* pixels(int tile_column, int y) const {
    return reinterpret_cast<const uint8_t*>(words_.data()) + size_t(tile_column) * columnBytes() +
           y;
  }
  size_t columnBytes() const { return size_t(stride_) * 8; }

 private:
  using Sum = uint64_t;  ///< low half: tiles with any pixel; high half: with all

  size_t sumAt(int x, int y) const { return size_t(x) * (rows_ + 1) + y; }
  void resize(int width, int height);
  void sumTiles(int width, int height);

  int columns_ = 0, rows_ = 0;  ///< tiles
  int stride_ = 0;              ///< words from column to column
  std::vector<uint64_t> words_;
  std::vector<Sum> sums_;
  size_t set_pixels_ = 0;
};

}  // namespace markerless_mocap
