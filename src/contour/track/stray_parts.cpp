#include "contour/track/stray_parts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "contour/regions/hull_cells.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

// A mask is changed only if the stray parts have this fraction of the area of the others.
constexpr double kMinStray = 0.03;

/// For each label, whether one of its cells is a cell of the hull.
std::vector<bool> labelsInCells(const cv::Mat& labels, int count, const cv::Mat& cells) {
  std::vector<bool> inside(size_t(count), false);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (labels.at<int>(y, x) && cells.at<uchar>(y, x))
        inside[size_t(labels.at<int>(y, x))] = true;
  return inside;
}

/// Number of cells of each label but 0, the background.
std::vector<int> areasOf(const cv::Mat& labels, int count) {
  std::vector<int> areas(size_t(count), 0);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) ++areas[size_t(labels.at<int>(y, x))];
  areas[0] = 0;
  return areas;
}

/// The parts of a mask, told apart by cells.
struct MaskParts {
  cv::Mat labels;          ///< CV_32SC1, one per cell; 0 is the background
  std::vector<int> areas;  ///< of each label, cells

  int all() const { return std::accumulate(areas.begin(), areas.end(), 0); }
  /// Whether large parts lie apart from the largest one.
  bool areApart() const {
    const int largest = areas.empty() ? 0 : *std::max_element(areas.begin(), areas.end());
    return all() - largest >= kMinStray * largest && largest > 0;
  }
};

MaskParts partsOf(const cv::Mat& mask) {
  MaskParts parts;
  cv::Mat joined;
  cv::dilate(maskCells(mask, hullCellEdge(mask.cols)), joined, cv::Mat());
  const int count = cv::connectedComponents(joined, parts.labels, 8, CV_32S);
  parts.areas = areasOf(parts.labels, count);
  return parts;
}

cv::Mat withoutStrayParts(const cv::Mat& mask, const MaskParts& parts, const VisualHull& hull,
                          const Camera& camera) {
  const int cell = hullCellEdge(mask.cols), count = int(parts.areas.size());
  const std::vector<bool> inside =
      labelsInCells(parts.labels, count, hullCells(hull, camera, cell));
  int kept = 0;
  for (int label = 1; label < count; ++label)
    if (inside[size_t(label)]) kept += parts.areas[size_t(label)];
  if (kept == 0 || parts.all() - kept < kMinStray * kept) return mask;
  cv::Mat cleaned = mask.clone();
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (!inside[size_t(parts.labels.at<int>(y / cell, x / cell))]) cleaned.at<uchar>(y, x) = 0;
  return cleaned;
}

}  // namespace

std::vector<cv::Mat> withoutStrayParts(const std::vector<cv::Mat>& masks,
                                       const std::function<const VisualHull&()>& hull,
                                       const CameraRig& rig) {
  if (masks.size() != rig.size()) return masks;
  std::vector<MaskParts> parts(masks.size());
  std::vector<char> apart(masks.size(), false);
  tbb::parallel_for(size_t(0), masks.size(), [&](size_t i) {
    if (masks[i].empty()) return;
    parts[i] = partsOf(masks[i]);
    apart[i] = parts[i].areApart() && !hasUnknownPixels(masks[i]);
  });
  if (!std::count(apart.begin(), apart.end(), true)) return masks;
  const VisualHull& seen = hull();
  if (seen.voxels.empty()) return masks;
  std::vector<cv::Mat> cleaned = masks;
  tbb::parallel_for(size_t(0), masks.size(), [&](size_t i) {
    if (apart[i]) cleaned[i] = withoutStrayParts(masks[i], parts[i], seen, rig[i]);
  });
  return cleaned;
}

}  // namespace markerless_mocap
