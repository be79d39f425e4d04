#pragma once

#include <deque>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// Images of a recording, evenly spread over it, and what moves in them.
struct SceneSamples {
  /// CV_8UC3, of `size`, in the light of the median image.
  std::vector<cv::Mat> colors;
  std::vector<cv::Mat> moving;  ///< CV_8UC1 of `size`; non-zero: something moves here
  std::vector<cv::Mat> images;  ///< as they came
  std::vector<float> gains;     ///< light of the images relative to the median image
  cv::Size size;                ///< of the copies that are worked on; the images' or smaller

  int count() const { return int(images.size()); }
};

/// Collects the samples from the stream of all images.
class SceneSampler {
 public:
  /// \param image CV_8UC1 or CV_8UC3, always the same size and type
  void add(const cv::Mat& image);
  int seen() const { return seen_; }
  /// At least one image must have been added.
  SceneSamples samples(bool compensate_flicker) const;

 private:
  struct Frame {
    cv::Mat image, small, smooth;
  };
  struct Kept {
    int index;
    cv::Mat image, small, moving;
  };

  void keep(int index);
  cv::Mat movingAt(int index) const;
  const cv::Mat* smoothAt(int index) const;

  int seen_ = 0, stride_ = 1;
  std::deque<Frame> recent_;  ///< the last of them is image seen_ - 1
  std::vector<Kept> kept_;
};

}  // namespace markerless_mocap
