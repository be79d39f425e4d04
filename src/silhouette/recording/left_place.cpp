#include "silhouette/recording/left_place.h"

#include <opencv2/imgproc.hpp>

#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

constexpr int kImages = 3;  // in a row

/// What an arm may reach beside somebody.
cv::Rect surroundings(const cv::Rect& person) {
  const int reach = person.height / 4;
  return (person - cv::Point(reach, reach)) + cv::Size(2 * reach, 2 * reach);
}

}  // namespace

bool LeftPlace::isLeft(const Extraction& found) {
  run_ = found.has_left_place ? run_ + 1 : 0;
  return run_ >= kImages;
}

void LeftPlace::hide(const BitMask& outline) {
  place_ = surroundings(cv::boundingRect(outline.toMat()));
}

void LeftPlace::removeGhost(cv::Mat& mask) const {
  cv::Mat near = mask(place_ & cv::Rect({}, mask.size()));
  near.setTo(kUnknownPixel, near == kPersonPixel);
}

}  // namespace markerless_mocap
