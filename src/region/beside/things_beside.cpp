#include "region/things_beside.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "markerless_mocap/products/silhouette_mask.h"
#include "region/body_drawing.h"
#include "region/mask_cells.h"

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

/// Numbers of cells of a mask and a predicted body.
struct CellCounts {
  int body = 0;
  int body_shown = 0, body_person = 0, body_known = 0;  ///< by what the mask says there
  int around = 0, around_shown = 0;                     ///< within reach, without the body
  int excess = 0;                                       ///< those of them that are person
};

/// A mask and the predicted body by cells.
struct ViewCells {
  int edge = 1;               ///< of a cell, pixels
  float cells_per_metre = 0;  ///< at the body
  float reach = 0;            ///< cells
  cv::Mat mask;               ///< CV_8UC1, 0 | 128 unknown | 255
  BodyDistance body;          ///< of the predicted body; its box is empty if that is outside
  CellCounts counts;

  bool hasBody() const { return body.box.area() > 0; }
  /// What is at most that far from the body, cells: CV_8UC1, 0 | 255. 0: the body itself.
  cv::Mat within(float distance) const {
    cv::Mat near = cv::Mat::zeros(mask.size(), CV_8UC1);
    cv::Mat(body.distance <= distance).copyTo(near(body.box));
    return near;
  }
  /// Which fraction of the body the mask shows.
  double shown() const { return double(counts.body_shown) / std::max(1, counts.body); }
};

CellCounts countsOf(const ViewCells& view) {
  CellCounts counts;
  for (int y = 0; y < view.body.box.height; ++y) {
    const uchar* mask = view.mask.ptr<uchar>(view.body.box.y + y) + view.body.box.x;
    const float* distance = view.body.distance.ptr<float>(y);
    for (int x = 0; x < view.body.box.width; ++x) {
      const bool body = distance[x] <= 0, around = !body && distance[x] <= view.reach;
      const bool shown = mask[x] != kBackgroundPixel, person = mask[x] == kPersonPixel;
      counts.body += body;
      counts.body_shown += body && shown;
      counts.body_person += body && person;
      counts.body_known += body && mask[x] != kUnknownPixel;
      counts.around += around;
      counts.around_shown += around && shown;
      counts.excess += around && person;
    }
  }
  return counts;
}

/// The cells outside all parts of the mask that come near the body; empty if the mask shows nothing
/// there.
cv::Mat partsApart(const ViewCells& view) {
  const int person = cv::countNonZero(view.mask == kPersonPixel);
  if (person == view.counts.body_person + view.counts.excess) return {};
  const cv::Mat apart = ~partsThatMeet(view.mask, view.within(view.reach));
  return cv::countNonZero(view.mask & apart) > 0 ? apart : cv::Mat();
}

cv::Mat disk(int radius) {
  const int edge = 2 * radius + 1;
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {edge, edge});
}

/// Where the mask cannot be the person's, if the body is about where it is predicted; empty if
/// there is too little of it.
cv::Mat doubtful(const ViewCells& view, const DoubtLimits& limits) {
  const CellCounts& counts = view.counts;
  if (view.shown() < limits.min_shown ||
      counts.around_shown >= kMaxAround * std::max(1, counts.around))
    return {};
  const bool may_miss = limits.max_missing < 1;
  const double max_excess = limits.max_excess * counts.body,
               max_missing = limits.max_missing * counts.body;
  // What is thick is a part of it, and mostly there is too little.
  if (counts.excess <= max_excess && (!may_miss || counts.body - counts.body_shown <= max_missing))
    return {};
  const int thick = std::max(1, int(std::lround(float(kThick_m) * view.cells_per_metre)));
  const cv::Mat body = view.within(0.f);
  const cv::Mat excess = (view.mask == kPersonPixel) & ~body;
  cv::Mat missing = body & (view.mask == kBackgroundPixel);
  if (!may_miss) missing.setTo(0);
  cv::Mat thick_excess, thick_missing, around;
  cv::morphologyEx(excess, thick_excess, cv::MORPH_OPEN, disk(thick));
  cv::morphologyEx(missing, thick_missing, cv::MORPH_OPEN, disk(1));
  if (cv::countNonZero(thick_excess & view.within(view.reach)) <= max_excess &&
      cv::countNonZero(thick_missing) <= max_missing)
    return {};
  cv::dilate(thick_excess, around, disk(thick));
  return (excess & around) | missing;
}

/// \param edge of a cell, pixels
ViewCells cellsOf(const cv::Mat& mask, int edge, const Camera& camera,
                  const PlacedBody& predicted) {
  ViewCells view;
  view.edge = edge;
  view.cells_per_metre = samplesPerMetre(camera, view.edge, predicted.pelvis);
  view.mask = maskCells(mask, view.edge);
  view.reach = float(kReach_m) * view.cells_per_metre;
  view.body = distanceFrom(projectedBody(camera, view.edge, predicted, 0.0), view.mask.size(),
                           view.reach + 1);
  view.counts = countsOf(view);
  return view;
}

bool isSupported(const std::vector<ViewCells>& views) {
  double person = 0, known = 0;
  for (const ViewCells& view : views) {
    person += view.counts.body_person;
    known += view.counts.body_known;
  }
  return person >= kMinSupported * known;
}

/// Parts that are apart are taken from the cells, too.
cv::Mat partsTakenFrom(ViewCells& view) {
  cv::Mat apart;
  if (view.shown() >= kMinShownApart) apart = partsApart(view);
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
                                 const std::vector<bool>& has_colors, const CameraRig& rig,
                                 const PlacedBody& predicted, double seconds) {
  const size_t count = std::min(masks.size(), rig.size());
  const bool is_fresh = seconds <= kLongestPrediction;
  const auto by_color = [&](size_t i) {
    return is_fresh && i < has_colors.size() && has_colors[i];
  };
  std::vector<ViewCells> views(count);
  tbb::parallel_for(size_t(0), count, [&](size_t i) {
    if (masks[i].empty()) return;
    const int edge = maskCellEdge(masks[i].cols);
    views[i] = cellsOf(masks[i], by_color(i) ? std::max(1, edge / 2) : edge, rig[i], predicted);
  });
  DoubtLimits with_colors = kWithColors;
  if (seconds > 0.0 && !isSupported(views)) with_colors.max_missing = 1;
  ClearedMasks out{masks, {}};
  std::vector<char> doubted(masks.size(), 0);
  tbb::parallel_for(size_t(0), count, [&](size_t i) {
    ViewCells& view = views[i];
    if (!view.hasBody()) return;
    const cv::Mat apart = partsTakenFrom(view);
    cv::Mat doubt = doubtful(view, with_colors);
    doubted[i] = is_fresh && !doubt.empty();
    if (!doubt.empty() && !by_color(i)) doubt = doubtful(view, kWithoutColors);
    out.masks[i] = cleaned(masks[i], view.edge, apart, doubt);
  });
  out.doubted.assign(doubted.begin(), doubted.end());
  return out;
}

}  // namespace markerless_mocap
