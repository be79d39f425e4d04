#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <opencv2/core.hpp>

namespace markerless_mocap {

/// Tells an image that differs from the last one nearly everywhere, or from some row down to the
/// bottom: a damaged JPEG that could be decoded all the same is wrong from the damage on. Where the
/// change stays, as of a lamp, the third image is taken; and at once what is as it was before that.
class SuddenChange {
 public:
  /// \return whether the image is to be left out
  bool add(const cv::Mat& image) {
    const cv::Mat sample = sampleOf(image);
    const bool stays = !changed_.empty() && isLike(sample, changed_) && ++run_ >= kStays;
    const bool is_back = !before_.empty() && isLike(sample, before_);
    if (last_.empty() || isLike(sample, last_) || stays || is_back) {
      if (stays) before_ = last_;
      if (is_back) before_.release();
      last_ = sample;
      changed_.release();
      usual_ *= kForgotten;
      return false;
    }
    if (changed_.empty() || !isLike(sample, changed_)) run_ = 1;
    changed_ = sample;
    usual_ += 1.0;
    return true;
  }
  /// An image between could not be read at all.
  void interrupt() {
    changed_.release();
    usual_ = 0.0;  // what changes is damaged, not the room
  }

 private:
  static constexpr int kSide = 48, kStays = 3, kMinRows = 2;
  static constexpr int kLevels = 20, kPartLevels = 12;
  static constexpr double kMost = 0.6, kMostOfPart = 0.5;
  // Images left out lately, of which 700 good ones forget half: a screen that flickers is no
  // damage.
  static constexpr double kForgotten = 0.999, kUsual = 20.0;

  /// Evenly distributed pixels.
  static cv::Mat sampleOf(const cv::Mat& image) {
    cv::Mat sample(kSide, kSide, image.type());
    const size_t pixel = image.elemSize();
    for (int y = 0; y < kSide; ++y) {
      const uchar* row = image.ptr(y * image.rows / kSide);
      for (int x = 0; x < kSide; ++x)
        std::memcpy(sample.ptr(y, x), row + size_t(x * image.cols / kSide) * pixel, pixel);
    }
    return sample;
  }

  bool isLike(const cv::Mat& a, const cv::Mat& b) const {
    if (a.type() != b.type()) return false;
    const int channels = a.channels();
    int values_changed = 0;
    std::array<int, kSide> pixels_changed{};  // of each row
    for (int y = 0; y < kSide; ++y) {
      const uchar *of_a = a.ptr(y), *of_b = b.ptr(y);
      for (int x = 0; x < kSide; ++x, of_a += channels, of_b += channels) {
        int largest = 0;
        for (int c = 0; c < channels; ++c) {
          const int difference = std::abs(of_a[c] - of_b[c]);
          values_changed += difference > kLevels;
          largest = std::max(largest, difference);
        }
        pixels_changed[size_t(y)] += largest > kPartLevels;
      }
    }
    if (values_changed > kMost * kSide * kSide * channels) return false;
    return usual_ > kUsual || !isOtherBelow(pixels_changed);
  }

  /// Whether from some row down to the bottom nearly everything differs, in any channel.
  static bool isOtherBelow(const std::array<int, kSide>& pixels_changed) {
    int below = 0;
    for (int rows = 1; rows <= kSide; ++rows) {
      below += pixels_changed[size_t(kSide - rows)];
      if (rows >= kMinRows && below > kMostOfPart * rows * kSide) return true;
    }
    return false;
  }

  cv::Mat last_, changed_;
  cv::Mat before_;      ///< the last image before a change that stayed
  int run_ = 0;         ///< images in a row that are like changed_
  double usual_ = 0.0;  ///< images left out lately, see kForgotten
};

}  // namespace markerless_mocap
