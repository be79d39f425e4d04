#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// A binary image in columns of 32 pixels: word `y` of column `c` holds the pixels 32 c to 32 c +
/// 31 of row y, the leftmost in the lowest bit. The words of a column are contiguous, so that rows
/// can be processed in parallel by SIMD instructions.
class BitImage {
 public:
  BitImage() = default;
  BitImage(int width, int height);
  /// \param mask CV_8UC1, non-zero = set
  explicit BitImage(const cv::Mat& mask);

  int width() const { return width_; }
  int height() const { return height_; }
  int columns() const { return (width_ + 31) / 32; }
  uint32_t* column(int c) { return words_.data() + size_t(c) * size_t(height_); }
  const uint32_t* column(int c) const { return words_.data() + size_t(c) * size_t(height_); }
  bool at(int x, int y) const { return column(x / 32)[y] >> (x % 32) & 1u; }
  int64_t count() const;
  /// CV_8UC1, 0 or 255.
  cv::Mat mask() const;

 private:
  int width_ = 0, height_ = 0;
  std::vector<uint32_t> words_;
};

}  // namespace markerless_mocap
