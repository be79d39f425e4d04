#include "contour/track/contour_hypotheses.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace markerless_mocap {
namespace {

using A = ContourAngle;
using B = ContourBall;
using S = ContourSegment;

constexpr double kKneeKept = 0.3;  // of the bend, when front becomes back

// One of two hypotheses is dropped when the other's quality, summed over instants, is ahead by
// this.
constexpr double kDecided = 0.15;
constexpr double kAhead = 0.05;
constexpr double kAtOnce = 0.03;  // in one instant

// Of more poses than the first, those are fitted to the end that a short look likes best.
constexpr size_t kFinalists = 4;
constexpr FitSchedule kFirstLook{6, 0.3, 0.1};

constexpr double kElsewhere = 0.15;  // metres, of a limb's end
constexpr double kSameBody = 0.08;   // metres, mean over the joints: an arm may be elsewhere

bool isLost(const ContourTrack& track) {
  return track.status == ContourTrackStatus::kLost;
}

bool isSameBody(const ContourBody& body, const ContourPose& pose, const ContourPose& other) {
  return (body.points(pose) - body.points(other)).colwise().norm().mean() < kSameBody;
}

}  // namespace

ContourHypotheses::ContourHypotheses(const CameraRig& rig, const ContourOptions& options)
    : held_(rig, options) {}

bool ContourHypotheses::isAhead() const {
  return held_.tracking() && (!rival_ || rival_gain_ < -kAhead);
}

void ContourHypotheses::lose() {
  held_.lose();
  rival_.reset();
  confirmed_ = false;
}

std::vector<ContourFit> ContourHypotheses::fitsFrom(const ContourObservation& seen,
                                                    const ContourBody& body,
                                                    const std::vector<ContourPose>& poses,
                                                    const FitSchedule& schedule) const {
  std::vector<ContourFit> fits(poses.size());
  tbb::parallel_for(size_t(0), poses.size(), [&](size_t i) {
    fits[i] = held_.fitter().fit(seen, body, poses[i], std::nullopt, schedule);
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
  const std::vector<ContourFit> fits = fitsFrom(seen, body, poses, FitSchedule::wide());
  return fits.empty() ? ContourFit{} : fits.front();
}

void ContourHypotheses::letRival(int64_t stamp_ns, const ContourFit& fit) {
  rival_.emplace(held_);
  rival_gain_ = 0.0;
  if (isLost(rival_->startFrom(stamp_ns, fit))) rival_.reset();
}

HeldTrack ContourHypotheses::start(int64_t stamp_ns, const ContourObservation& seen,
                                   const ContourBody& body, const std::vector<ContourPose>& poses) {
  lose();
  const ContourFit best = bestFit(seen, body, poses);
  if (best.status != ContourFitStatus::kFitted) return {};
  HeldTrack held{held_.start(stamp_ns, seen, body, best.pose), true};
  if (isLost(held.track)) return held;
  const ContourFit other = bestFit(seen, body, {mirrored(body, held.track.fit.pose)});
  if (qualityOf(other) > qualityOf(held.track.fit) - kAtOnce) letRival(stamp_ns, other);
  return held;
}

HeldTrack ContourHypotheses::update(int64_t stamp_ns, const ContourObservation& seen,
                                    const ContourBody& body) {
  HeldTrack held{held_.update(stamp_ns, seen, body), false};
  if (!rival_) return held;
  const ContourTrack other = rival_->update(stamp_ns, seen, body);
  const bool both = !isLost(held.track) && !isLost(other);
  if (both) rival_gain_ += qualityOf(other.fit) - qualityOf(held.track.fit);
  held.jumped = !isLost(other) && (isLost(held.track) || rival_gain_ > kDecided);
  if (held.jumped) {
    held.track = other;
    held_ = *rival_;
    confirmed_ = false;
  }
  // Hypotheses often grow together.
  const bool same = both && !isElsewhere(body, held.track.fit.pose, other.fit.pose);
  if (held.jumped || isLost(other) || same || rival_gain_ < -kDecided) rival_.reset();
  return held;
}

HeldTrack ContourHypotheses::startAgain(int64_t stamp_ns, const ContourObservation& seen,
                                        const ContourBody& body,
                                        const std::vector<ContourPose>& poses,
                                        const HeldTrack& held) {
  ContourHypotheses fresh = *this;
  const HeldTrack other = fresh.start(stamp_ns, seen, body, poses);
  if (isLost(other.track)) return held;
  const double gain = qualityOf(other.track.fit) - qualityOf(held.track.fit);
  const bool same = isSameBody(body, held.track.fit.pose, other.track.fit.pose);
  const bool confirmed = same || (confirmed_ && gain < kAtOnce);
  HeldTrack now = held;
  if (gain >= kAtOnce) {
    *this = fresh;
    now = {other.track, !same};
  }
  confirmed_ = confirmed;
  return now;
}

void ContourHypotheses::challenge(int64_t stamp_ns, const ContourObservation& seen,
                                  const ContourBody& body, const std::vector<ContourPose>& poses) {
  if (rival_ || !held_.tracking()) return;
  const ContourFit best = bestFit(seen, body, poses);
  if (best.status == ContourFitStatus::kFitted && qualityOf(best) > held_.quality() - kAtOnce &&
      isElsewhere(body, best.pose, held_.pose()))
    letRival(stamp_ns, best);
}

bool isElsewhere(const ContourBody& body, const ContourPose& pose, const ContourPose& other) {
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
  out.balls[B::kRoot] = pose.balls[B::kRoot] * about;
  out.angles[A::kSpinePitch] = -pose.angles[A::kSpinePitch];
  out.angles[A::kSpineRoll] = -pose.angles[A::kSpineRoll];
  out.balls[B::kNeck] = about * pose.balls[B::kNeck] * about;
  const Eigen::Matrix3d pelvis = frames.R[S::kPelvis] * about, chest = frames.R[S::kChest] * about;
  for (const size_t side : {0, 1}) {
    const size_t other = 1 - side;
    out.angles[A::kLeftClavicleYaw + 2 * side] = 0.0;
    out.angles[A::kLeftClavicleRoll + 2 * side] = 0.0;
    out.balls[B::kLeftShoulder + side] = chest.transpose() * frames.R[S::kLeftUpperArm + other];
    out.angles[A::kLeftElbow + side] = pose.angles[A::kLeftElbow + other];
    out.balls[B::kLeftHip + side] = pelvis.transpose() * frames.R[S::kLeftThigh + other] * about;
    out.angles[A::kLeftKnee + side] = kKneeKept * pose.angles[A::kLeftKnee + other];
    out.angles[A::kLeftAnkle + side] = 0.0;
  }
  return out;
}

ContourPose withLegsExchanged(const ContourBody& body, const ContourPose& pose) {
  ContourFrames frames;
  body.place(pose, frames);
  ContourPose out = pose;
  for (const size_t side : {0, 1}) {
    const size_t other = 1 - side;
    out.balls[B::kLeftHip + side] =
        frames.R[S::kPelvis].transpose() * frames.R[S::kLeftThigh + other];
    out.angles[A::kLeftKnee + side] = pose.angles[A::kLeftKnee + other];
    out.angles[A::kLeftAnkle + side] = pose.angles[A::kLeftAnkle + other];
  }
  return out;
}

}  // namespace markerless_mocap
