#include "contour/regions/body_regions.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "contour/model/contour_kinematics.h"
#include "contour/regions/hull_cells.h"
#include "contour/regions/projected_body.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

constexpr int kSamplesAcross = 330;  // every second pixel up to VGA, fewer of larger images
// Expected error of a body around which candidates are looked for, and how far from it, metres.
constexpr double kCandidateError = 0.04;
constexpr float kCandidateReach = 0.5f;

// Colours decide if a larger fraction of the body's box is unknown. The box is wider than the body
// by kNear_sigmas expected errors and kNear samples.
constexpr double kMaxUnknownNear = 0.005;
constexpr float kNear_sigmas = 2.5f, kNear = 2.f;

// If background subtraction sees more of what colours found in a view as background, but so it is
// in less than half of the views that tell, the camera of that view was turned or covered.
constexpr double kMostContradicted = 0.25;

int stepOf(const cv::Mat& image) {
  return std::max(1, (image.cols + kSamplesAcross - 1) / kSamplesAcross);
}

/// The part of the image that whole samples cover.
cv::Rect sampledBox(const cv::Mat& image, int step) {
  return {0, 0, image.cols / step * step, image.rows / step * step};
}

cv::Mat sampled(const cv::Mat& image, int step, cv::InterpolationFlags how) {
  if (step == 1) return image;
  cv::Mat out;
  cv::resize(image(sampledBox(image, step)), out, {image.cols / step, image.rows / step}, 0, 0,
             how);
  return out;
}

/// Whether the background is not known near the body.
bool isUnknownNear(const ProjectedBody& body, const cv::Mat& known) {
  const float reach = kNear_sigmas * body.sigma + kNear;
  cv::Rect2f box;
  for (const ProjectedCone& cone : body.cones) {
    const float x = std::min(cone.a.x() - cone.radius_a, cone.b.x() - cone.radius_b) - reach;
    const float y = std::min(cone.a.y() - cone.radius_a, cone.b.y() - cone.radius_b) - reach;
    const float right = std::max(cone.a.x() + cone.radius_a, cone.b.x() + cone.radius_b) + reach;
    const float bottom = std::max(cone.a.y() + cone.radius_a, cone.b.y() + cone.radius_b) + reach;
    const cv::Rect2f wide(x, y, right - x, bottom - y);
    box = box.area() > 0 ? box | wide : wide;
  }
  const cv::Rect near = cv::Rect(box) & cv::Rect(0, 0, known.cols, known.rows);
  return near.area() > 0 &&
         cv::countNonZero(known(near) == kUnknownPixel) > kMaxUnknownNear * near.area();
}

/// The mask at the samples, enlarged to the image with smooth borders.
cv::Mat enlarged(const cv::Mat& samples, int step, const cv::Size& image) {
  if (step == 1) return samples;
  cv::Mat out = cv::Mat::zeros(image, CV_8UC1), smooth;
  const cv::Rect box = cv::boundingRect(samples);
  if (box.area() == 0) return out;
  const cv::Rect wide =
      (box + cv::Size(2, 2) - cv::Point(1, 1)) & cv::Rect(0, 0, samples.cols, samples.rows);
  cv::resize(samples(wide), smooth, wide.size() * step, 0, 0, cv::INTER_LINEAR);
  cv::Mat(smooth > 127)
      .copyTo(out(cv::Rect(wide.x * step, wide.y * step, smooth.cols, smooth.rows)));
  return out;
}

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
  tbb::parallel_for(size_t(0), std::min(images.size(), masks.size()), [&](size_t i) {
    if (images[i].empty() || images[i].type() != CV_8UC3 || !hasUnknownBackground(masks[i])) return;
    RegionView& view = views[i];
    view.step = stepOf(images[i]);
    view.colors = sampled(images[i], view.step, cv::INTER_AREA);
    view.known = sampled(masks[i], view.step, cv::INTER_NEAREST);
  });
}

RegionFrame RegionFrame::coarser() const {
  RegionFrame out = *this;
  out.is_coarse = true;
  tbb::parallel_for(size_t(0), views.size(), [&](size_t i) {
    if (views[i].colors.empty()) return;
    out.views[i] = {2 * views[i].step, sampled(views[i].colors, 2, cv::INTER_AREA),
                    sampled(views[i].known, 2, cv::INTER_NEAREST)};
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
  std::vector<RegionMask> found(rig_.size());
  std::atomic<int> masks_tell{0};
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    const RegionView& view = frame.views[i];
    if (view.colors.empty()) {
      masks_tell += !frame.masks[i].empty() && !hasUnknownBackground(frame.masks[i]);
      return;
    }
    const ProjectedBody at = projectedBody(rig_[i], view.step, body, pose, error_m);
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
  std::vector<cv::Mat> out = frame.masks;
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    const RegionView& view = frame.views[i];
    if (view.colors.empty()) return;
    const ProjectedBody at = projectedBody(rig_[i], view.step, body, pose, kCandidateError);
    const float samples_per_metre = samplesPerMetre(rig_[i], view.step, pose);
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
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    const RegionView& view = frame.views[i];
    if (view.colors.empty()) return;
    segmenters_[i].learn(view.colors, projectedBody(rig_[i], view.step, body, pose, error_m));
  });
}

}  // namespace markerless_mocap
