#include "contour/track/attached_things.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "contour/regions/hull_cells.h"
#include "contour/regions/projected_body.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "region/body_drawing.h"

namespace markerless_mocap {
namespace {

constexpr double kReach_m = 0.15;  // from the predicted body, in the image

// Fractions of the body's area: arms and a shank together are less than the first value. A body
// of whom less than the second is covered by the mask is in another place.
constexpr double kMinThing = 0.35, kMinShown = 0.85;
// Of what is around the body within reach: a camera that is covered shows no outline of the person.
constexpr double kMaxAround = 0.7;

/// Cells of a mask and of the predicted body.
struct CellCounts {
  int body = 0, around = 0;  ///< of the body, and the others within reach
  int shown = 0;             ///< of the body, those that the mask shows
  int filled = 0;            ///< of those around it, those that the mask shows
  int far = 0;               ///< of the mask, those out of reach

  bool showThing() const {
    return far > kMinThing * body && shown > kMinShown * body && filled < kMaxAround * around;
  }
};

/// Cells that are nearer to the body than that, in cells: CV_8UC1 0 | 255.
cv::Mat cellsNear(const BodyDrawing& drawing, float distance, const cv::Size& size) {
  cv::Mat near = cv::Mat::zeros(size, CV_8UC1);
  cv::Mat(drawing.distance <= distance).copyTo(near(drawing.box));
  return near;
}

CellCounts counted(const cv::Mat& mask, const cv::Mat& near, const cv::Mat& body) {
  CellCounts counts;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      const uchar value = mask.at<uchar>(y, x);
      if (body.at<uchar>(y, x)) {
        ++counts.body;
        counts.shown += value != 0;
      } else if (near.at<uchar>(y, x)) {
        ++counts.around;
        counts.filled += value != 0;
      } else {
        counts.far += value == kPersonPixel;
      }
    }
  return counts;
}

cv::Mat withFarUnknown(const cv::Mat& mask, int cell, const cv::Mat& near) {
  cv::Mat out = mask.clone();
  for (int y = 0; y < mask.rows; ++y) {
    uchar* row = out.ptr<uchar>(y);
    const uchar* near_row = near.ptr<uchar>(y / cell);
    for (int x = 0; x < mask.cols; ++x)
      if (row[x] && !near_row[x / cell]) row[x] = kUnknownPixel;
  }
  return out;
}

cv::Mat withoutAttachedThings(const cv::Mat& mask, const Camera& camera, const ContourBody& body,
                              const ContourPose& predicted) {
  const int cell = hullCellEdge(mask.cols);
  const cv::Mat cells = maskCells(mask, cell);
  const cv::Size size = cells.size();
  const float reach = float(kReach_m) * samplesPerMetre(camera, cell, predicted);
  const BodyDrawing drawing = drawBody(projectedBody(camera, cell, body, predicted, 0.0),
                                       int(ContourSegment::kCount), size, reach + 1);
  if (drawing.box.area() == 0) return mask;
  const cv::Mat near = cellsNear(drawing, reach, size);
  if (!counted(cells, near, cellsNear(drawing, 0.f, size)).showThing()) return mask;
  return withFarUnknown(mask, cell, near);
}

}  // namespace

std::vector<cv::Mat> withoutAttachedThings(const std::vector<cv::Mat>& masks, const CameraRig& rig,
                                           const ContourBody& body, const ContourPose& predicted) {
  std::vector<cv::Mat> out = masks;
  tbb::parallel_for(size_t(0), std::min(masks.size(), rig.size()), [&](size_t i) {
    if (!masks[i].empty()) out[i] = withoutAttachedThings(masks[i], rig[i], body, predicted);
  });
  return out;
}

}  // namespace markerless_mocap
