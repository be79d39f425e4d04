#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {

/// Tells an image that differs from the last one nearly everywhere, or from some row down to the
/// bottom: a damaged JPEG that could be decoded all the same is wrong from the damage on. Where the
/// change stays, as of a lamp, the third image is taken; and at once what is as it was before that.
class SuddenChange {
 public:
  /// \return whether the image is to be left out
  bool add(const cv::Mat& image) {
    cv::Mat sample;
    cv::resize(image, sample, cv::Size(kSide, kSide), 0, 0, cv::INTER_NEAREST);
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
  static constexpr double kLevels = 20.0, kMost = 0.6;
  static constexpr double kPartLevels = 12.0, kMostOfPart = 0.5;
  // Images left out lately, of which 700 good ones forget half: a screen that flickers is no
  // damage.
  static constexpr double kForgotten = 0.999, kUsual = 20.0;

  bool isLike(const cv::Mat& a, const cv::Mat& b) const {
    if (a.type() != b.type()) return false;
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    if (changed(difference.reshape(1), kLevels) > kMost) return false;
    return usual_ > kUsual || !isOtherBelow(difference);
  }

  /// Whether from some row down to the bottom nearly everything differs, in any channel.
  static bool isOtherBelow(const cv::Mat& difference) {
    cv::Mat largest;
    cv::reduce(difference.reshape(1, kSide * kSide), largest, 1, cv::REDUCE_MAX);
    const cv::Mat differs = largest.reshape(1, kSide) > kPartLevels;
    int below = 0;
    for (int rows = 1; rows <= kSide; ++rows) {
      below += cv::countNonZero(differs.row(kSide - rows));
      if (rows >= kMinRows && below > kMostOfPart * rows * kSide) return true;
    }
    return false;
  }

  /// Fraction of the values.
  static double changed(const cv::Mat& values, double levels) {
    return double(cv::countNonZero(values > levels)) / double(values.total());
  }

  cv::Mat last_, changed_;
  cv::Mat before_;      ///< the last image before a change that stayed
  int run_ = 0;         ///< images in a row that are like changed_
  double usual_ = 0.0;  ///< images left out lately, see kForgotten
};

}  // namespace markerless_mocap
