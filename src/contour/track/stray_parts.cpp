#include "contour/track/stray_parts.h"

#include <tbb/parallel_for.h>

#include <opencv2/core.hpp>

#include "contour/regions/hull_cells.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "region/mask_cells.h"

namespace markerless_mocap {
namespace {

// Stray parts are left out if they have this fraction of the area of the others.
constexpr double kMinStray = 0.03;
// What is attached becomes unknown if it has this fraction of the area that the hull projects into:
// a limb that the hull lacks has less.
constexpr double kMinAttached = 0.35;

cv::Mat withoutStrayParts(const cv::Mat& mask, const VisualHull& hull, const Camera& camera) {
  const int edge = maskCellEdge(mask.cols);
  const cv::Mat shown = maskCells(mask, edge), inside = hullCells(hull, camera, edge);
  const cv::Mat reached = partsThatMeet(shown, inside);
  const int kept = cv::countNonZero((shown != 0) & reached);
  const int stray = cv::countNonZero((shown != 0) & ~reached);
  const cv::Mat attached = (shown == kPersonPixel) & reached & ~inside;
  const bool has_stray = kept > 0 && stray >= kMinStray * kept;
  const bool has_attached =
      cv::countNonZero(attached) > kMinAttached * cv::countNonZero((shown != 0) & inside);
  if (!has_stray && !has_attached) return mask;
  cv::Mat cleaned = mask.clone();
  if (has_stray) setCells(~reached, edge, kBackgroundPixel, &cleaned);
  if (has_attached) setCells(attached, edge, kUnknownPixel, &cleaned);
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
