#include "contour/track/stray_parts.h"

#include <tbb/parallel_for.h>

#include <opencv2/imgproc.hpp>

#include "contour/regions/hull_cells.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

// Stray parts are left out if they have this fraction of the area of the others.
constexpr double kMinStray = 0.03;
// What is attached becomes unknown if it has this fraction of the area that the hull projects into:
// a limb that the hull lacks has less.
constexpr double kMinAttached = 0.35;

/// A mask and the hull by cells.
struct HullView {
  cv::Mat mask;    ///< CV_8UC1 0 | 128 unknown | 255
  cv::Mat hull;    ///< CV_8UC1 0 | 255
  cv::Mat labels;  ///< CV_32SC1: of the mask's connected parts; 0 is the background
  int count;       ///< of labels
};

HullView viewOf(const cv::Mat& mask, const VisualHull& hull, const Camera& camera, int cell) {
  HullView view{maskCells(mask, cell), hullCells(hull, camera, cell), {}, 0};
  cv::Mat joined;
  cv::dilate(view.mask, joined, cv::Mat());
  view.count = cv::connectedComponents(joined, view.labels, 8, CV_32S);
  return view;
}

/// The cells of parts of the mask that the hull projects into: CV_8UC1 0 | 255.
cv::Mat reachedParts(const HullView& view) {
  std::vector<bool> reached(size_t(view.count), false);
  for (int y = 0; y < view.labels.rows; ++y)
    for (int x = 0; x < view.labels.cols; ++x)
      if (view.hull.at<uchar>(y, x)) reached[size_t(view.labels.at<int>(y, x))] = true;
  reached[0] = false;
  cv::Mat cells(view.labels.size(), CV_8UC1);
  for (int y = 0; y < cells.rows; ++y)
    for (int x = 0; x < cells.cols; ++x)
      cells.at<uchar>(y, x) = reached[size_t(view.labels.at<int>(y, x))] ? 255 : 0;
  return cells;
}

cv::Mat withoutStrayParts(const cv::Mat& mask, const VisualHull& hull, const Camera& camera) {
  const int cell = hullCellEdge(mask.cols);
  const HullView view = viewOf(mask, hull, camera, cell);
  const cv::Mat reached = reachedParts(view);
  const int kept = cv::countNonZero(reached);
  const int stray = cv::countNonZero((view.labels != 0) & ~reached);
  const cv::Mat attached = (view.mask == kPersonPixel) & reached & ~view.hull;
  const bool has_stray = kept > 0 && stray >= kMinStray * kept;
  const bool has_attached =
      cv::countNonZero(attached) > kMinAttached * cv::countNonZero((view.mask != 0) & view.hull);
  if (!has_stray && !has_attached) return mask;
  cv::Mat cleaned = mask.clone();
  if (has_stray) setCells(~reached, cell, kBackgroundPixel, &cleaned);
  if (has_attached) setCells(attached, cell, kUnknownPixel, &cleaned);
  return cleaned;
}

}  // namespace

std::vector<cv::Mat> withoutStrayParts(const std::vector<cv::Mat>& masks, const VisualHull& hull,
                                       const CameraRig& rig) {
  if (masks.size() != rig.size() || hull.voxels.empty()) return masks;
  std::vector<cv::Mat> cleaned = masks;
  tbb::parallel_for(size_t(0), masks.size(), [&](size_t i) {
    if (!masks[i].empty() && !hasUnknownPixels(masks[i]))
      cleaned[i] = withoutStrayParts(masks[i], hull, rig[i]);
  });
  return cleaned;
}

}  // namespace markerless_mocap
