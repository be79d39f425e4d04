#include "hull/selection/unknown_views.h"

#include <cmath>
#include <opencv2/core.hpp>

#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

/// Fraction of the image up to which unknown pixels are accepted.
constexpr double kMaxUnknown = 0.25;

double unknownFraction(const cv::Mat& mask) {
  // Most masks have no unknown pixels, and finding none is much faster than counting.
  if (mask.empty() || !hasUnknownPixels(mask)) return 0;
  return double(cv::countNonZero(mask == kUnknownPixel)) / double(mask.total());
}

}  // namespace

std::vector<HullView> withoutUnknownViews(std::vector<HullView> views, const CameraRig& rig,
                                          std::vector<LeftOutCamera>* left_out) {
  for (size_t c = 0; c < views.size(); ++c) {
    const double unknown = unknownFraction(views[c].mask);
    if (unknown <= kMaxUnknown) continue;
    views[c].mask.release();
    left_out->push_back({rig[c].name(), "the background of " +
                                            std::to_string(std::lround(100 * unknown)) +
                                            " % of its image is not known"});
  }
  return views;
}

}  // namespace markerless_mocap
