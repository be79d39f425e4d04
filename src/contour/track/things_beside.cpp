#include "contour/track/things_beside.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "contour/regions/hull_cells.h"
#include "contour/regions/projected_body.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "region/body_drawing.h"

namespace markerless_mocap {
namespace {

constexpr double kReach_m = 0.15;  // from the predicted body, in the image

// Fractions of the predicted body's area. Both arms and a shank are less than the first one.
constexpr double kMinThing = 0.35;
// A body of whom the mask shows less is in another place, or hidden: the mask tells parts that are
// apart from it from the person, but nothing that is attached.
constexpr double kMinShown = 0.5, kMinShownWithThing = 0.85;
// Of what is around the body within reach: a camera that is covered shows no outline of the person.
constexpr double kMaxAround = 0.7;

/// A mask and the predicted body by cells, each CV_8UC1 0 | 255.
struct ViewCells {
  cv::Mat mask;   ///< 0 | 128 unknown | 255
  cv::Mat body;   ///< the predicted body
  cv::Mat reach;  ///< what is within reach of it, itself included

  cv::Mat personOutOfReach() const { return (mask == kPersonPixel) & ~reach; }
};

/// Cells that are nearer to the body than that, in cells.
cv::Mat cellsNear(const BodyDrawing& drawing, float distance, const cv::Size& size) {
  cv::Mat near = cv::Mat::zeros(size, CV_8UC1);
  cv::Mat(drawing.distance <= distance).copyTo(near(drawing.box));
  return near;
}

/// Which fraction of the cells the mask shows.
double shownOf(const cv::Mat& cells, const cv::Mat& mask) {
  return double(cv::countNonZero((mask != 0) & cells)) / std::max(1, cv::countNonZero(cells));
}

bool isThing(const cv::Mat& attached, const ViewCells& view) {
  return cv::countNonZero(attached) > kMinThing * cv::countNonZero(view.body) &&
         shownOf(view.body, view.mask) > kMinShownWithThing &&
         shownOf(view.reach & ~view.body, view.mask) < kMaxAround;
}

/// The cells and what is nearer to them than that, in cells.
cv::Mat grown(const cv::Mat& cells, float distance) {
  const int edge = 2 * int(std::ceil(distance)) + 1;
  cv::Mat out;
  cv::dilate(cells, out, cv::getStructuringElement(cv::MORPH_ELLIPSE, {edge, edge}));
  return out;
}

cv::Mat withoutThingsBeside(const cv::Mat& mask, const Camera& camera, const ContourBody& body,
                            const ContourPose& predicted) {
  const int edge = hullCellEdge(mask.cols);
  const float reach = float(kReach_m) * samplesPerMetre(camera, edge, predicted);
  ViewCells view{maskCells(mask, edge), {}, {}};
  const cv::Size size = view.mask.size();
  const BodyDrawing drawing = drawBody(projectedBody(camera, edge, body, predicted, 0.0),
                                       int(ContourSegment::kCount), size, reach + 1);
  if (drawing.box.area() == 0) return mask;
  view.body = cellsNear(drawing, 0.f, size);
  view.reach = cellsNear(drawing, reach, size);
  const cv::Mat outside = view.personOutOfReach();
  if (cv::countNonZero(outside) == 0 || shownOf(view.body, view.mask) < kMinShown) return mask;

  const cv::Mat apart = ~partsThatMeet(view.mask, view.reach), attached = outside & ~apart;
  const bool has_parts = cv::countNonZero(view.mask & apart) > 0;
  const bool has_thing = isThing(attached, view);
  if (!has_parts && !has_thing) return mask;
  cv::Mat out = mask.clone();
  if (has_parts) setCells(apart, edge, kBackgroundPixel, &out);
  if (has_thing) setCells(grown(attached, reach) & ~view.body, edge, kUnknownPixel, &out);
  return out;
}

}  // namespace

std::vector<cv::Mat> withoutThingsBeside(const std::vector<cv::Mat>& masks, const CameraRig& rig,
                                         const ContourBody& body, const ContourPose& predicted) {
  std::vector<cv::Mat> out = masks;
  tbb::parallel_for(size_t(0), std::min(masks.size(), rig.size()), [&](size_t i) {
    if (!masks[i].empty()) out[i] = withoutThingsBeside(masks[i], rig[i], body, predicted);
  });
  return out;
}

}  // namespace markerless_mocap
