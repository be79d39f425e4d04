#pragma once

#include <deque>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// Images of a recording, evenly spread over it, and what moves in them.
struct SceneSamples {
  cv::Size size;                ///< of the copies that are worked on: the images' or smaller
  std::vector<cv::Mat> colors;  ///< CV_8UC3 of `size`, in the light of the median image
  std::vector<cv::Mat> moving;  ///< CV_8UC1 of `size`; non-zero: something moves here
  cv::Size image_size;
  int image_channels = 0;
  std::vector<cv::Mat> images;  ///< as they came; some are empty if all would need much memory
  std::vector<float> gains;     ///< light of the images relative to the median image

  int count() const { return int(colors.size()); }
};

/// Copy of an image with at most 160000 pixels, CV_8UC3.
cv::Mat smallCopy(const cv::Mat& image);

/// Collects samples from a stream of images.
class SceneSampler {
 public:
  /// One image in so many is looked at: images that follow each other hardly differ.
  static constexpr int kStep = 3;

  /// \param stride one image in so many becomes a sample; rounded up to a multiple of kStep, and
  /// doubled whenever there are too many
  explicit SceneSampler(int stride = kStep) : stride_((stride + kStep - 1) / kStep * kStep) {}

  /// Whether the next image is needed, for a sample or for what moves in one.
  bool wantsNext() const;
  /// \param image CV_8UC1 or CV_8UC3, always the same size and type; empty: it is missing
  void add(const cv::Mat& image);
  int seen() const { return seen_; }
  bool empty() const { return recent_.empty(); }
  /// The last image that was looked at; empty if there is none.
  cv::Mat last() const;
  /// Throws std::invalid_argument if no image has been added.
  SceneSamples samples(bool compensate_flicker) const;
  /// Their pixels that move alone, as SceneSamples::moving, which is much quicker.
  std::vector<cv::Mat> motion() const;

 private:
  struct Frame {
    cv::Mat image, small, smooth;
  };
  struct Kept {
    int index;
    cv::Mat image, small, moving;
  };

  void keep(int index);
  /// Those kept, and those of the last images. Throws as samples().
  std::vector<Kept> allKept() const;
  void thinOut();
  const Frame* frameAt(int index) const;
  cv::Mat movingAt(int index) const;

  int seen_ = 0, stride_;
  cv::Size image_size_;
  int image_channels_ = 0;
  std::deque<Frame> recent_;  ///< the last of them is image seen_ - 1
  std::vector<Kept> kept_;
};

}  // namespace markerless_mocap
