#include "contour/regions/body_regions.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <opencv2/core.hpp>

#include "contour/model/contour_kinematics.h"
#include "contour/regions/hull_cells.h"
#include "contour/regions/placed_contour_body.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

// Expected error of a body around which candidates are looked for, and how far from it, metres.
constexpr double kCandidateError = 0.04;
constexpr float kCandidateReach = 0.5f;

// If background subtraction sees more of what colours found in a view as background, but so it is
// in less than half of the views that tell, the camera of that view was turned or covered.
constexpr double kMostContradicted = 0.25;

/// Limb of each segment, which is a part of the segmenter.
ContourLimb::Id limbOfPart(size_t part) {
  for (size_t c = 0; c < kContourCones; ++c)
    if (size_t(contourKinematicTree().cones[c].ends[0].segment) == part)
      return contourKinematicTree().cones[c].limb;
  return ContourLimb::kTrunk;
}

double ratio(double part, double whole, double of_nothing) {
  return whole > 0 ? part / whole : of_nothing;
}

/// How much of what colours found has a known background, and how much is background.
struct Verdict {
  double known = 0.0, contradicted = 0.0;
};

Verdict verdictOn(const RegionMask& view) {
  const auto sum = [](const std::vector<int>& parts) {
    return double(std::accumulate(parts.begin(), parts.end(), 0));
  };
  const double colored = sum(view.colored), known = sum(view.known);
  return {ratio(known, colored, 0), ratio(known - sum(view.agreeing), colored, 0)};
}

/// Takes out what was found in views that most others contradict; their masks become unknown.
/// \param masks_tell number of views in which masks decide
void leaveOutContradicted(const std::vector<cv::Mat>& masks, int masks_tell,
                          std::vector<RegionMask>& found, RegionMasks& out) {
  std::vector<size_t> contradicted;
  int telling = masks_tell;
  for (size_t i = 0; i < found.size(); ++i) {
    const Verdict verdict = verdictOn(found[i]);
    telling += verdict.known > kMostContradicted;
    if (verdict.contradicted > kMostContradicted) contradicted.push_back(i);
  }
  if (2 * int(contradicted.size()) >= telling) return;
  for (const size_t i : contradicted) {
    found[i] = RegionMask();
    out.masks[i] = cv::Mat(masks[i].size(), CV_8UC1, kUnknownPixel);
  }
}

void measureAgreement(const std::vector<RegionMask>& found, RegionMasks& out) {
  std::array<double, ContourLimb::kCount> colored{}, contradicted{};
  double silhouette = 0, known = 0, agreeing = 0;
  for (const RegionMask& view : found) {
    silhouette += view.silhouette;
    for (size_t part = 0; part < view.known.size(); ++part) {
      colored[limbOfPart(part)] += view.colored[part];
      contradicted[limbOfPart(part)] += view.known[part] - view.agreeing[part];
      known += view.known[part];
      agreeing += view.agreeing[part];
    }
  }
  for (size_t limb = 0; limb < colored.size(); ++limb)
    out.limb_agreement[limb] = 1 - ratio(contradicted[limb], colored[limb], 0);
  out.agreement = ratio(agreeing, known, 1);
  out.overlap = ratio(agreeing, known + silhouette - agreeing, 1);
}

}  // namespace

RegionFrame::RegionFrame(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks)
    : masks(masks), views(masks.size()) {
  std::vector<char> known(masks.size());
  tbb::parallel_for(size_t(0), masks.size(), [&](size_t i) {
    known[i] = !masks[i].empty() && !hasUnknownBackground(masks[i]);
    const bool has_colors = i < images.size() && images[i].type() == CV_8UC3 && !images[i].empty();
    if (has_colors && !masks[i].empty() && !known[i]) views[i] = regionView(images[i], masks[i]);
  });
  tells.assign(known.begin(), known.end());
}

RegionFrame RegionFrame::coarser() const {
  RegionFrame out = *this;
  out.is_coarse = true;
  tbb::parallel_for(size_t(0), views.size(), [&](size_t i) {
    if (!views[i].colors.empty()) out.views[i] = markerless_mocap::coarser(views[i]);
  });
  return out;
}

RegionFrame RegionFrame::clone() const {
  RegionFrame out = *this;
  for (cv::Mat& mask : out.masks) mask = mask.clone();
  for (RegionView& view : out.views) view = {view.step, view.colors.clone(), view.known.clone()};
  return out;
}

bool RegionFrame::needsColors() const {
  return std::any_of(views.begin(), views.end(),
                     [](const RegionView& view) { return !view.colors.empty(); });
}

BodyRegions::BodyRegions(const CameraRig& rig)
    : rig_(rig), prepared_(std::async(std::launch::async, RegionSegmenter::prepare).share()) {
  for (size_t i = 0; i < rig.size(); ++i) segmenters_.emplace_back(int(ContourSegment::kCount));
}

void BodyRegions::reset() {
  for (RegionSegmenter& segmenter : segmenters_) segmenter.reset();
}

RegionMasks BodyRegions::segment(const RegionFrame& frame, const ContourBody& body,
                                 const ContourPose& pose, double error_m) const {
  RegionMasks out;
  out.masks = frame.masks;
  const PlacedBody placed = placedBody(body, pose);
  std::vector<RegionMask> found(rig_.size());
  std::atomic<int> masks_tell{0};
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    const RegionView& view = frame.views[i];
    if (view.colors.empty()) {
      masks_tell += frame.tells[i];
      return;
    }
    const ProjectedBody at = projectedBody(rig_[i], view.step, placed, error_m);
    if (!isUnknownNear(at, view.known)) {
      ++masks_tell;
      return;
    }
    found[i] = segmenters_[i].segment(view.colors, at, view.known);
    out.masks[i] = enlarged(found[i].mask, view.step, frame.masks[i].size());
  });
  leaveOutContradicted(frame.masks, masks_tell, found, out);
  measureAgreement(found, out);
  return out;
}

std::vector<cv::Mat> BodyRegions::candidates(const RegionFrame& frame, const VisualHull& hull,
                                             const ContourBody& body,
                                             const ContourPose& pose) const {
  const PlacedBody placed = placedBody(body, pose);
  std::vector<cv::Mat> out = frame.masks;
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    const RegionView& view = frame.views[i];
    if (view.colors.empty()) return;
    const ProjectedBody at = projectedBody(rig_[i], view.step, placed, kCandidateError);
    const float samples_per_metre = samplesPerMetre(rig_[i], view.step, pose.position);
    const cv::Mat found =
        segmenters_[i].candidates(view.colors, at, view.known, kCandidateReach * samples_per_metre);
    out[i] = enlarged(found, view.step, frame.masks[i].size());
    if (!hull.voxels.empty()) out[i] &= hullPixels(hull, rig_[i]);
  });
  return out;
}

std::vector<cv::Mat> BodyRegions::largest(const RegionFrame& frame, const VisualHull& hull) const {
  std::vector<cv::Mat> out = frame.masks;
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    if (frame.views[i].colors.empty()) return;
    out[i] = cv::Mat(frame.masks[i] > 0);  // a new one: masks share their pixels
    if (!hull.voxels.empty()) out[i] &= hullPixels(hull, rig_[i]);
  });
  return out;
}

void BodyRegions::learn(const RegionFrame& frame, const ContourBody& body, const ContourPose& pose,
                        double error_m) {
  const PlacedBody placed = placedBody(body, pose);
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    const RegionView& view = frame.views[i];
    if (view.colors.empty()) return;
    segmenters_[i].learn(view.colors, projectedBody(rig_[i], view.step, placed, error_m));
  });
}

}  // namespace markerless_mocap
