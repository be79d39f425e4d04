#include "contour/measure/online_shape_estimator.h"

#include <chrono>
#include <utility>

#include "numerics/low_priority.h"

namespace markerless_mocap {
namespace {

// A pose differs if the mean displacement of the joints is larger than this. A person who stands
// still is therefore added rarely.
constexpr double kMinPoseChange = 0.04;  // metres
constexpr int64_t kSoonest_ns = 60000000, kLatest_ns = 300000000;

constexpr double kMinOverlap = 0.7;  // with the mean shape

// After this time, a person who hardly moves is estimated from fewer poses.
constexpr int64_t kMaxWait_ns = 5000000000;
constexpr size_t kMinPoses = 8;

// The second round starts with the correspondences that the first one has improved.
constexpr int kRounds = 2;

// Poses that differ by less than this from their mean, mean over the joints about the pelvis, show
// the person from one side only: a chair or a mask then looks like a part of the body. The shape
// keeps near the mean shape, and only the stature is left free.
constexpr double kMinVariety = 0.03;     // metres
constexpr double kStiffDeviation = 0.2;  // factor on the standard deviations of the shape

/// Mean distance of the joints, from the pelvis, from their mean over the samples, metres.
double varietyOf(const std::vector<ShapeSample>& samples, const ContourBody& body) {
  std::vector<Eigen::Matrix3Xd> all;
  for (const ShapeSample& sample : samples) {
    const Eigen::Matrix3Xd points = body.points(sample.start);
    all.push_back(points.colwise() - points.col(0));
  }
  Eigen::Matrix3Xd mean = Eigen::Matrix3Xd::Zero(3, all.front().cols());
  for (const Eigen::Matrix3Xd& points : all) mean += points / double(all.size());
  double variety = 0.0;
  for (const Eigen::Matrix3Xd& points : all)
    variety += (points - mean).colwise().norm().mean() / double(all.size());
  return variety;
}

ShapeParameters estimated(const CameraRig& rig, const ContourOptions& contour, ShapePrior prior,
                          std::vector<ShapeSample> samples) {
  const ContourBody mean_body(prior.shape_statistics.meanShape(prior.stature));
  if (varietyOf(samples, mean_body) < kMinVariety)
    prior.shape_statistics.deviation *= kStiffDeviation;
  ShapeParameters shape = prior.shape_statistics.meanShape(prior.stature);
  for (int round = 0; round < kRounds; ++round) {
    const ShapeEstimate estimate = estimateShape(rig, contour, prior, shape, samples);
    shape = estimate.shape;
    for (size_t i = 0; i < samples.size(); ++i) samples[i].start = estimate.poses[i];
  }
  return shape;
}

}  // namespace

OnlineShapeEstimator::OnlineShapeEstimator(const CameraRig& rig, const ContourOptions& contour,
                                           const ShapePrior& prior, int poses, bool in_background)
    : rig_(rig),
      contour_(contour),
      prior_(prior),
      poses_(size_t(poses)),
      in_background_(in_background) {}

void OnlineShapeEstimator::add(int64_t stamp_ns, const ContourObservation& seen,
                               const ContourBody& body, const ContourFit& fit) {
  if (isEstimating() || fit.overlap < kMinOverlap) return;
  const Eigen::Matrix3Xd points = body.points(fit.pose);
  if (!samples_.empty()) {
    if (stamp_ns < last_stamp_ns_) {  // the clock was set back
      first_stamp_ns_ += stamp_ns - last_stamp_ns_;
      last_stamp_ns_ = stamp_ns;
    }
    const int64_t passed = stamp_ns - last_stamp_ns_;
    const double moved = (points - last_points_).colwise().norm().mean();
    if (passed < kSoonest_ns || (passed < kLatest_ns && moved < kMinPoseChange)) return;
  }
  samples_.push_back({seen, fit.pose, {}});
  last_points_ = points;
  last_stamp_ns_ = stamp_ns;
  if (samples_.size() == 1) first_stamp_ns_ = stamp_ns;
  if (samples_.size() >= poses_) estimateNow();
  skip(stamp_ns);
}

void OnlineShapeEstimator::skip(int64_t stamp_ns) {
  if (samples_.size() >= kMinPoses && stamp_ns - first_stamp_ns_ >= kMaxWait_ns) estimateNow();
}

void OnlineShapeEstimator::estimateNow() {
  if (isEstimating() || samples_.empty()) return;
  const auto estimate = [rig = rig_, contour = contour_, prior = prior_, samples = samples_] {
    return estimated(rig, contour, prior, samples);
  };
  estimate_ = in_background_
                  ? std::async(std::launch::async, [estimate] { return unobtrusively(estimate); })
                  : std::async(std::launch::deferred, estimate);
}

std::optional<ShapeParameters> OnlineShapeEstimator::shape() {
  if (!estimate_.valid()) return std::nullopt;
  if (in_background_ && estimate_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  return estimate_.get();
}

}  // namespace markerless_mocap
