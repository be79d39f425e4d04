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

// A body of whom the mask shows a smaller fraction is in another place, or hidden: parts that are
// apart could be the person then.
constexpr double kMinShownApart = 0.5;
// Of what is around the body within reach: a camera that is covered shows no outline of the person.
constexpr double kMaxAround = 0.7;

// What is thicker than twice this, or than three cells, is hardly a limb that moved.
constexpr double kThick_m = 0.04;

/// How much of a mask must be wrong until the body says so: fractions of the predicted body's area.
struct DoubtLimits {
  double min_shown;    ///< shown of the body, else it is in another place, or hidden
  double max_excess;   ///< thick, within reach, but not the body
  double max_missing;  ///< thick, of the body, but not in the mask; 1: the mask is right there
};
// Colours find limbs that are elsewhere. Without them what is unknown is lost: both arms and a
// shank have less than this excess.
constexpr DoubtLimits kWithColors{0.3, 0.03, 0.1}, kWithoutColors{0.85, 0.2, 1.0};
// Seconds. What is predicted farther ahead may itself be off by more than kWithColors allows.
constexpr double kLongestPrediction = 0.12;
// If all masks together show a smaller fraction of the body where they are known, it is the body
// that is wrong.
constexpr double kMinSupported = 0.75;

/// A mask and the predicted body by cells, each CV_8UC1 0 | 255.
struct ViewCells {
  int edge = 1;               ///< of a cell, pixels
  float cells_per_metre = 0;  ///< at the body
  cv::Mat mask;               ///< 0 | 128 unknown | 255
  cv::Mat body;               ///< the predicted body
  cv::Mat near;               ///< what is within reach of it, itself included
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

/// The cells outside all parts of the mask that come near the body; empty if the mask shows nothing
/// there.
cv::Mat partsApart(const ViewCells& view) {
  if (cv::countNonZero((view.mask == kPersonPixel) & ~view.near) == 0) return {};
  const cv::Mat apart = ~partsThatMeet(view.mask, view.near);
  return cv::countNonZero(view.mask & apart) > 0 ? apart : cv::Mat();
}

cv::Mat disk(int radius) {
  const int edge = 2 * radius + 1;
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {edge, edge});
}

/// Where the mask cannot be the person's, if the body is about where it is predicted; empty if
/// there is too little of it.
cv::Mat doubtful(const ViewCells& view, const DoubtLimits& limits) {
  if (shownOf(view.body, view.mask) < limits.min_shown ||
      shownOf(view.near & ~view.body, view.mask) >= kMaxAround)
    return {};
  const int thick = std::max(1, int(std::lround(float(kThick_m) * view.cells_per_metre)));
  const cv::Mat excess = (view.mask == kPersonPixel) & ~view.body;
  cv::Mat missing = view.body & (view.mask == kBackgroundPixel);
  if (limits.max_missing >= 1) missing.setTo(0);
  cv::Mat thick_excess, thick_missing, around;
  cv::morphologyEx(excess, thick_excess, cv::MORPH_OPEN, disk(thick));
  cv::morphologyEx(missing, thick_missing, cv::MORPH_OPEN, disk(1));
  const int whole = cv::countNonZero(view.body);
  if (cv::countNonZero(thick_excess & view.near) <= limits.max_excess * whole &&
      cv::countNonZero(thick_missing) <= limits.max_missing * whole)
    return {};
  cv::dilate(thick_excess, around, disk(thick));
  return (excess & around) | missing;
}

/// `near` is empty if the body is outside the image. \param edge of a cell, pixels
ViewCells cellsOf(const cv::Mat& mask, int edge, const Camera& camera, const ContourBody& body,
                  const ContourPose& predicted) {
  ViewCells view;
  view.edge = edge;
  view.cells_per_metre = samplesPerMetre(camera, view.edge, predicted);
  view.mask = maskCells(mask, view.edge);
  const float reach = float(kReach_m) * view.cells_per_metre;
  const cv::Size size = view.mask.size();
  const BodyDrawing drawing = drawBody(projectedBody(camera, view.edge, body, predicted, 0.0),
                                       int(ContourSegment::kCount), size, reach + 1);
  if (drawing.box.area() == 0) return view;
  view.body = cellsNear(drawing, 0.f, size);
  view.near = cellsNear(drawing, reach, size);
  return view;
}

bool isSupported(const std::vector<ViewCells>& views) {
  double shown = 0, known = 0;
  for (const ViewCells& view : views) {
    if (view.near.empty()) continue;
    shown += cv::countNonZero(view.body & (view.mask == kPersonPixel));
    known += cv::countNonZero(view.body & (view.mask != kUnknownPixel));
  }
  return shown >= kMinSupported * known;
}

/// Parts that are apart are taken from the cells, too.
cv::Mat partsTakenFrom(ViewCells& view) {
  cv::Mat apart;
  if (shownOf(view.body, view.mask) >= kMinShownApart) apart = partsApart(view);
  if (!apart.empty()) view.mask.setTo(kBackgroundPixel, apart);
  return apart;
}

cv::Mat cleaned(const cv::Mat& mask, int edge, const cv::Mat& apart, const cv::Mat& doubt) {
  if (apart.empty() && doubt.empty()) return mask;
  cv::Mat out = mask.clone();
  if (!apart.empty()) setCells(apart, edge, kBackgroundPixel, &out);
  if (!doubt.empty()) setCells(doubt, edge, kUnknownPixel, &out);
  return out;
}

}  // namespace

ClearedMasks withoutThingsBeside(const std::vector<cv::Mat>& masks,
                                 const std::vector<cv::Mat>& images, const CameraRig& rig,
                                 const ContourBody& body, const ContourPrediction& predicted) {
  const size_t count = std::min(masks.size(), rig.size());
  const bool is_fresh = predicted.seconds <= kLongestPrediction;
  const auto has_colors = [&](size_t i) {
    return is_fresh && i < images.size() && images[i].type() == CV_8UC3;
  };
  std::vector<ViewCells> views(count);
  tbb::parallel_for(size_t(0), count, [&](size_t i) {
    if (masks[i].empty()) return;
    const int edge = hullCellEdge(masks[i].cols);
    views[i] = cellsOf(masks[i], has_colors(i) ? std::max(1, edge / 2) : edge, rig[i], body,
                       predicted.pose);
  });
  DoubtLimits with_colors = kWithColors;
  if (!isSupported(views)) with_colors.max_missing = 1;
  ClearedMasks out{masks, {}};
  std::vector<char> doubted(masks.size(), 0);
  tbb::parallel_for(size_t(0), count, [&](size_t i) {
    ViewCells& view = views[i];
    if (view.near.empty()) return;
    const cv::Mat apart = partsTakenFrom(view);
    cv::Mat doubt = doubtful(view, with_colors);
    doubted[i] = is_fresh && !doubt.empty();
    if (!doubt.empty() && !has_colors(i)) doubt = doubtful(view, kWithoutColors);
    out.masks[i] = cleaned(masks[i], view.edge, apart, doubt);
  });
  out.doubted.assign(doubted.begin(), doubted.end());
  return out;
}

}  // namespace markerless_mocap
