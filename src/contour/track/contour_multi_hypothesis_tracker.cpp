#include "contour/track/contour_multi_hypothesis_tracker.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;
using S = ContourSegment;

constexpr double kKneeKept = 0.3;  // of the bend, when front becomes back

// One of two hypotheses is dropped when the other's quality, summed over instants, is ahead by
// this.
constexpr double kDecided = 0.15;
constexpr double kAhead = 0.05;
constexpr double kAtOnce = 0.03;  // in one instant

// Of more poses than the first, those are fitted to the end that a short look likes best.
constexpr size_t kFinalists = 4;
constexpr RobustSchedule kFirstLook{6, 0.3, 0.1};

constexpr double kElsewhere = 0.15;  // metres, of a limb's end
constexpr double kSameBody = 0.08;   // metres, mean over the joints: an arm may be elsewhere

bool isLost(const ContourTrackingResult& track) {
  return track.status == ContourTrackingStatus::kLost;
}

bool isSameBody(const ContourBody& body, const ContourPose& pose, const ContourPose& other) {
  return (body.points(pose) - body.points(other)).colwise().norm().mean() < kSameBody;
}

}  // namespace

ContourHypotheses::ContourHypotheses(const CameraRig& rig, const ContourOptions& options)
    : active_(rig, options) {}

bool ContourHypotheses::isUnambiguous() const {
  return active_.tracking() && (!alternative_ || alternative_gain_ < -kAhead);
}

void ContourHypotheses::lose() {
  active_.lose();
  alternative_.reset();
  confirmed_ = false;
}

std::vector<ContourFit> ContourHypotheses::fitsFrom(const ContourObservation& seen,
                                                    const ContourBody& body,
                                                    const std::vector<ContourPose>& poses,
                                                    const RobustSchedule& schedule) const {
  std::vector<ContourFit> fits(poses.size());
  tbb::parallel_for(size_t(0), poses.size(), [&](size_t i) {
    fits[i] = active_.fitter().fit(seen, body, poses[i], std::nullopt, schedule);
  });
  const auto failed = [](const ContourFit& fit) { return fit.status != ContourFitStatus::kFitted; };
  fits.erase(std::remove_if(fits.begin(), fits.end(), failed), fits.end());
  std::stable_sort(fits.begin(), fits.end(), [](const ContourFit& one, const ContourFit& other) {
    return qualityOf(one) > qualityOf(other);
  });
  return fits;
}

ContourFit ContourHypotheses::bestFit(const ContourObservation& seen, const ContourBody& body,
                                      std::vector<ContourPose> poses) const {
  if (poses.size() > kFinalists) {
    const std::vector<ContourFit> first = fitsFrom(seen, body, poses, kFirstLook);
    poses.clear();
    for (size_t i = 0; i < std::min(kFinalists, first.size()); ++i) poses.push_back(first[i].pose);
  }
  const std::vector<ContourFit> fits = fitsFrom(seen, body, poses, RobustSchedule::wide());
  return fits.empty() ? ContourFit{} : fits.front();
}

void ContourHypotheses::letRival(int64_t stamp_ns, const ContourFit& fit) {
  alternative_.emplace(active_);
  alternative_gain_ = 0.0;
  if (isLost(alternative_->startFrom(stamp_ns, fit))) alternative_.reset();
}

ActiveTrack ContourHypotheses::start(int64_t stamp_ns, const ContourObservation& seen,
                                     const ContourBody& body,
                                     const std::vector<ContourPose>& poses) {
  lose();
  const ContourFit best = bestFit(seen, body, poses);
  if (best.status != ContourFitStatus::kFitted) return {};
  ActiveTrack held{active_.start(stamp_ns, seen, body, best.pose), true};
  if (isLost(held.track)) return held;
  const ContourFit other = bestFit(seen, body, {mirrored(body, held.track.fit.pose)});
  if (qualityOf(other) > qualityOf(held.track.fit) - kAtOnce) letRival(stamp_ns, other);
  return held;
}

ActiveTrack ContourHypotheses::update(int64_t stamp_ns, const ContourObservation& seen,
                                      const ContourBody& body) {
  ActiveTrack held{active_.update(stamp_ns, seen, body), false};
  if (!alternative_) return held;
  const ContourTrackingResult other = alternative_->update(stamp_ns, seen, body);
  const bool both = !isLost(held.track) && !isLost(other);
  if (both) alternative_gain_ += qualityOf(other.fit) - qualityOf(held.track.fit);
  held.switched = !isLost(other) && (isLost(held.track) || alternative_gain_ > kDecided);
  if (held.switched) {
    held.track = other;
    active_ = *alternative_;
    confirmed_ = false;
  }
  // Hypotheses often grow together.
  const bool same = both && !limbsDiffer(body, held.track.fit.pose, other.fit.pose);
  if (held.switched || isLost(other) || same || alternative_gain_ < -kDecided) alternative_.reset();
  return held;
}

ActiveTrack ContourHypotheses::reinitialize(int64_t stamp_ns, const ContourObservation& seen,
                                            const ContourBody& body,
                                            const std::vector<ContourPose>& poses,
                                            const ActiveTrack& held) {
  ContourHypotheses fresh = *this;
  const ActiveTrack other = fresh.start(stamp_ns, seen, body, poses);
  if (isLost(other.track)) return held;
  const double gain = qualityOf(other.track.fit) - qualityOf(held.track.fit);
  const bool same = isSameBody(body, held.track.fit.pose, other.track.fit.pose);
  const bool confirmed = same || (confirmed_ && gain < kAtOnce);
  ActiveTrack now = held;
  if (gain >= kAtOnce) {
    *this = fresh;
    now = {other.track, !same};
  }
  confirmed_ = confirmed;
  return now;
}

void ContourHypotheses::proposeAlternative(int64_t stamp_ns, const ContourObservation& seen,
                                           const ContourBody& body,
                                           const std::vector<ContourPose>& poses) {
  if (alternative_ || !active_.tracking()) return;
  const ContourFit best = bestFit(seen, body, poses);
  if (best.status == ContourFitStatus::kFitted && qualityOf(best) > active_.quality() - kAtOnce &&
      limbsDiffer(body, best.pose, active_.pose()))
    letRival(stamp_ns, best);
}

bool limbsDiffer(const ContourBody& body, const ContourPose& pose, const ContourPose& other) {
  const Eigen::Matrix3Xd points = body.points(pose), others = body.points(other);
  for (const Eigen::Index end : {5, 8, 11, 14})  // wrists and ankles of contourPointNames()
    if ((points.col(end) - others.col(end)).norm() > kElsewhere) return true;
  return false;
}

ContourPose mirrored(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  body.place(pose, frames);
  const Eigen::Matrix3d about = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  ContourPose out = pose;
  out.rotations[B::kRoot] = pose.rotations[B::kRoot] * about;
  out.angles[A::kSpinePitch] = -pose.angles[A::kSpinePitch];
  out.angles[A::kSpineRoll] = -pose.angles[A::kSpineRoll];
  out.rotations[B::kNeck] = about * pose.rotations[B::kNeck] * about;
  const Eigen::Matrix3d pelvis = frames.R[S::kPelvis] * about, chest = frames.R[S::kChest] * about;
  for (const size_t side : {0, 1}) {
    const size_t other = 1 - side;
    out.angles[A::kLeftClavicleYaw + 2 * side] = 0.0;
    out.angles[A::kLeftClavicleRoll + 2 * side] = 0.0;
    out.rotations[B::kLeftShoulder + side] = chest.transpose() * frames.R[S::kLeftUpperArm + other];
    out.angles[A::kLeftElbow + side] = pose.angles[A::kLeftElbow + other];
    out.rotations[B::kLeftHip + side] =
        pelvis.transpose() * frames.R[S::kLeftThigh + other] * about;
    out.angles[A::kLeftKnee + side] = kKneeKept * pose.angles[A::kLeftKnee + other];
    out.angles[A::kLeftAnkle + side] = 0.0;
  }
  return out;
}

ContourPose withLegsSwapped(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  body.place(pose, frames);
  ContourPose out = pose;
  for (const size_t side : {0, 1}) {
    const size_t other = 1 - side;
    out.rotations[B::kLeftHip + side] =
        frames.R[S::kPelvis].transpose() * frames.R[S::kLeftThigh + other];
    out.angles[A::kLeftKnee + side] = pose.angles[A::kLeftKnee + other];
    out.angles[A::kLeftAnkle + side] = pose.angles[A::kLeftAnkle + other];
  }
  return out;
}

}  // namespace markerless_mocap
