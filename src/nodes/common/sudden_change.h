#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {

/// Tells an image that differs from the last one nearly everywhere, as a damaged one does that
/// could be decoded all the same. Where the change stays, as of a lamp, the third image is taken.
class SuddenChange {
 public:
  /// \return whether the image is to be left out
  bool add(const cv::Mat& image) {
    cv::Mat sample;
    cv::resize(image, sample, cv::Size(kSide, kSide), 0, 0, cv::INTER_NEAREST);
    const bool stays = !changed_.empty() && isLike(sample, changed_) && ++run_ >= kStays;
    if (last_.empty() || isLike(sample, last_) || stays) {
      last_ = sample;
      interrupt();
      return false;
    }
    if (changed_.empty() || !isLike(sample, changed_)) run_ = 1;
    changed_ = sample;
    return true;
  }
  /// An image between could not be read at all.
  void interrupt() { changed_.release(); }

 private:
  static constexpr int kSide = 48, kStays = 3;
  static constexpr double kLevels = 20.0, kMost = 0.6;

  static bool isLike(const cv::Mat& a, const cv::Mat& b) {
    if (a.type() != b.type()) return false;
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    const cv::Mat values = difference.reshape(1);
    return double(cv::countNonZero(values > kLevels)) <= kMost * double(values.total());
  }

  cv::Mat last_, changed_;
  int run_ = 0;  ///< images in a row that are like changed_
};

}  // namespace markerless_mocap
