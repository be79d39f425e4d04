#pragma once

#include <opencv2/core/mat.hpp>

#include "studies/reproduce/fleischmann/fleischmann_run.h"

namespace markerless_mocap {

/// A body to be drawn.
struct DrawnPose {
  FleischmannVector v;
  cv::Scalar left, right, middle;  ///< colours of the limbs of each side, and of torso and head
};
DrawnPose truePose(const FleischmannVector& v);       ///< red: black is not seen on dark clothes
DrawnPose estimatedPose(const FleischmannVector& v);  ///< left cyan, right yellow (Fig. 5.1)
DrawnPose plainPose(const FleischmannVector& v, const cv::Scalar& color);

/// Draws bodies over the first view of a capture.
class FilmPictures {
 public:
  /// Reads the frames once. \param numbers of frames, in any order
  FilmPictures(const Capture& capture, const FilmTruth& truth, std::vector<size_t> numbers);

  /// The view, cropped to the person, with the bodies' cones; CV_8UC3. Throws std::out_of_range on
  /// a frame that was not read.
  cv::Mat picture(size_t number, const std::vector<DrawnPose>& poses) const;

 private:
  void draw(const DrawnPose& pose, cv::Mat* image) const;

  FleischmannFitness fitness_;
  std::map<size_t, FleischmannView> views_;
};

/// Pictures side by side, with a line of text below each.
cv::Mat strip(const std::vector<cv::Mat>& pictures, const std::vector<std::string>& texts);

/// Parameters of a JSON list.
FleischmannVector poseOf(const Json& list);

}  // namespace markerless_mocap
