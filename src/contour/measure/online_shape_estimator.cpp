#include "contour/measure/online_shape_estimator.h"

#include <sys/resource.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <utility>

namespace markerless_mocap {
namespace {

// Another pose: the joints have moved by this on average; one who stands still is taken in more
// rarely.
constexpr double kOtherPose = 0.04;  // metres
constexpr int64_t kSoonest_ns = 60000000, kLatest_ns = 300000000;

constexpr double kLeastOverlap = 0.7;  // with sizes that are not this person's

// One who hardly moves is measured from fewer poses after this time.
constexpr int64_t kPatience_ns = 5000000000;
constexpr size_t kFewestPoses = 8;

// The second estimate starts with correspondences that the first has put right.
constexpr int kRounds = 2;

ShapeParameters estimated(const CameraRig& rig, const ContourOptions& contour,
                          const ShapePrior& prior, std::vector<ShapeSample> instants) {
  ShapeParameters sizes = prior.people.sizes(prior.stature);
  for (int round = 0; round < kRounds; ++round) {
    const ShapeEstimate estimate = estimateShape(rig, contour, prior, sizes, instants, {});
    sizes = estimate.sizes;
    for (size_t i = 0; i < instants.size(); ++i) instants[i].start = estimate.poses[i];
  }
  return sizes;
}

constexpr int kNiceness = 10;  // what goes on meanwhile comes first

/// Takes what is left over of one core.
template <class Function>
auto unobtrusively(const Function& function) {
  setpriority(PRIO_PROCESS, 0, kNiceness);  // of this thread alone
  return tbb::task_arena(1).execute(function);
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
  if (isEstimating() || fit.overlap < kLeastOverlap) return;
  const Eigen::Matrix3Xd points = body.points(fit.pose);
  if (!instants_.empty()) {
    if (stamp_ns < last_stamp_ns_) {  // time goes on from elsewhere
      first_stamp_ns_ += stamp_ns - last_stamp_ns_;
      last_stamp_ns_ = stamp_ns;
    }
    const int64_t passed = stamp_ns - last_stamp_ns_;
    const double moved = (points - last_points_).colwise().norm().mean();
    if (passed < kSoonest_ns || (passed < kLatest_ns && moved < kOtherPose)) return;
  }
  instants_.push_back({seen, fit.pose, {}});
  last_points_ = points;
  last_stamp_ns_ = stamp_ns;
  if (instants_.size() == 1) first_stamp_ns_ = stamp_ns;
  const bool patient = stamp_ns - first_stamp_ns_ < kPatience_ns || instants_.size() < kFewestPoses;
  if (instants_.size() >= poses_ || !patient) estimateNow();
}

void OnlineShapeEstimator::estimateNow() {
  if (isEstimating() || instants_.empty()) return;
  const auto estimate = [rig = rig_, contour = contour_, prior = prior_, instants = instants_] {
    return estimated(rig, contour, prior, instants);
  };
  estimate_ = in_background_
                  ? std::async(std::launch::async, [estimate] { return unobtrusively(estimate); })
                  : std::async(std::launch::deferred, estimate);
}

std::optional<ShapeParameters> OnlineShapeEstimator::sizes() {
  if (!estimate_.valid()) return std::nullopt;
  if (in_background_ && estimate_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  return estimate_.get();
}

}  // namespace markerless_mocap
