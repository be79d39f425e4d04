#include "contour/track/limb_search.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "contour/fit/geman_mcclure.h"
#include "contour/fit/pose_priors.h"
#include "contour/fit/pose_problem.h"

namespace markerless_mocap {
namespace {

constexpr size_t kTriesNear = 240, kTriesAnywhere = 160, kBest = 6, kTriesAround = 10;
constexpr size_t kPlaces = 4;
constexpr double kFarApart = 0.12;  // metres, of the limb's ends

// Standard deviations of tries: balls in turn by these, twists about the limb, hinges; radians.
constexpr double kBallSpread[] = {0.2, 0.6, 1.5}, kTwistSpread = 1.0, kHingeSpread = 0.6;
constexpr double kCloser = 0.25;  // of these, around the best of the first tries

// Places are judged sharply, which tells near ones apart, and bluntly, which tells far ones whose
// surroundings are right: distance from which on a ray is mostly ignored, metres.
constexpr double kOutliers[] = {0.1, 0.25};
constexpr size_t kJudges = 2;
constexpr size_t kRays = 120;  // that places are judged by at most

/// The joints of a limb that are tried, and its end among contourPointNames().
struct LimbJoints {
  int ball, hinge, end;
  double hinge_lower, hinge_upper;
};
LimbJoints jointsOf(ContourLimb::Id limb) {
  constexpr LimbJoints kJoints[] = {
      {SphericalJoint::kLeftShoulder, RevoluteJoint::kLeftElbow, 5, 0.0, 2.6},
      {SphericalJoint::kRightShoulder, RevoluteJoint::kRightElbow, 8, 0.0, 2.6},
      {SphericalJoint::kLeftHip, RevoluteJoint::kLeftKnee, 11, -2.6, 0.0},
      {SphericalJoint::kRightHip, RevoluteJoint::kRightKnee, 14, -2.6, 0.0}};
  return kJoints[limb - ContourLimb::kLeftArm];
}

struct LimbPoseSample {
  ContourPose pose;
  std::array<double, kJudges> energy;  ///< by each of kOutliers
  Eigen::Vector3d end;
};

/// Half the weighted robust squares of the rays given and of what sticks out of masks.
class LimbPoseCost {
 public:
  LimbPoseCost(const ContourObservation& seen, const CameraRig& rig, const ContourOptions& options,
               ContourLimb::Id limb)
      : seen_(seen), rig_(rig), options_(options), limb_(limb) {}

  /// Takes the rays that touch the limb at this pose or that nothing explains.
  void lookFor(const ContourBody& body, const ContourPose& pose) {
    PoseProblem problem(seen_, rig_, options_);
    problem.evaluate(body, pose, kOutliers[0]);
    std::vector<size_t> found;
    for (size_t i = 0; i < seen_.rays.size(); ++i)
      if (std::abs(problem.matches()[i].residual) > kRayExplained ||
          limbOfCone(problem.matches()[i].cone) == limb_)
        found.push_back(i);
    const size_t step = found.size() / kRays + 1;
    for (size_t i = 0; i < found.size(); i += step) rays_.push_back(seen_.rays[found[i]]);
    rays_per_ray_ = double(step);
  }

  std::array<double, kJudges> energy(const ContourBody& body, const ContourPose& pose) const {
    ContourFrames frames;
    ContourWorldCones cones;
    body.place(pose, frames);
    body.place(frames, cones);
    std::vector<RayMatch> matches;
    matchRays(PackedContourCones(cones), rays_, matches);
    const double variance = options_.ray_sigma * options_.ray_sigma;
    const double one =
        rays_per_ray_ * options_.effective_rays / double(std::max<size_t>(1, seen_.rays.size()));
    const double outside =
        options_.containment_weight * containmentEnergy(seen_, rig_, cones, limb_);
    std::array<double, kJudges> energies;
    energies.fill(0.5 * outside / variance + postureEnergy(pose) + armRestEnergy(pose));
    for (size_t judge = 0; judge < kJudges; ++judge)
      for (const RayMatch& match : matches)
        energies[judge] +=
            0.5 * one / variance * gemanMcClureLoss(match.residual, kOutliers[judge]);
    return energies;
  }

 private:
  const ContourObservation& seen_;
  const CameraRig& rig_;
  const ContourOptions& options_;
  const ContourLimb::Id limb_;
  std::vector<ContourRay> rays_;
  double rays_per_ray_ = 1.0;  ///< for how many each stands
};

/// Directions spread evenly over the sphere, neighbours in turn far apart (Fibonacci lattice).
Eigen::Vector3d direction(size_t i, size_t count) {
  const size_t shuffled = i * 37 % count;  // 37 shares no factor with the count
  const double z = 1.0 - (2.0 * double(shuffled) + 1.0) / double(count);
  const double turn = double(shuffled) * M_PI * (3.0 - std::sqrt(5.0)), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// The rotation R, turned the shortest way so that its z becomes `z`.
Eigen::Matrix3d turnTo(const Eigen::Vector3d& z, const Eigen::Matrix3d& R) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d(R.col(2)), z).toRotationMatrix() * R;
}

/// Adds the first few whose ends are not near to one another.
void choose(const std::vector<LimbPoseSample>& places, std::vector<LimbPoseSample>& chosen) {
  const size_t enough = chosen.size() + kPlaces;
  for (const LimbPoseSample& place : places) {
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const LimbPoseSample& other) {
      return (place.end - other.end).norm() < kFarApart;
    });
    if (!near) chosen.push_back(place);
    if (chosen.size() == enough) return;
  }
}

/// Tries in batches: drawn one after another, judged at once.
class LimbPoseSampler {
 public:
  LimbPoseSampler(const ContourBody& body, const LimbPoseCost& judge, const ContourPose& fitted,
                  const LimbJoints& joints)
      : body_(body), judge_(judge), fitted_(fitted), joints_(joints) {}

  /// Draws a pose whose limb is near to that of `middle` but for the hinge, which is near to
  /// `bend`. \param share of the spreads
  void draw(const ContourPose& middle, double bend, double share) {
    const double spread = share * kBallSpread[places_.size() % std::size(kBallSpread)];
    const double x = normal_(random_), y = normal_(random_), twist = normal_(random_);
    const Eigen::Vector3d turn(spread * x, spread * y, share * kTwistSpread * twist);
    LimbPoseSample place{fitted_, {}, {}};
    place.pose.rotations[size_t(joints_.ball)] =
        middle.rotations[size_t(joints_.ball)] * expSO3(turn);
    place.pose.angles[size_t(joints_.hinge)] = std::clamp(
        bend + share * kHingeSpread * normal_(random_), joints_.hinge_lower, joints_.hinge_upper);
    places_.push_back(place);
  }

  /// All places so far, the one that judge likes best first.
  const std::vector<LimbPoseSample>& judged(size_t judge) {
    tbb::parallel_for(tbb::blocked_range<size_t>(judged_, places_.size(), 16),
                      [&](const auto& some) {
                        for (size_t i = some.begin(); i < some.end(); ++i) {
                          LimbPoseSample& place = places_[i];
                          place.energy = judge_.energy(body_, place.pose);
                          place.end = body_.points(place.pose).col(joints_.end);
                        }
                      });
    std::stable_sort(places_.begin(), places_.end(),
                     [&](const LimbPoseSample& a, const LimbPoseSample& b) {
                       return a.energy[judge] < b.energy[judge];
                     });
    judged_ = places_.size();
    return places_;
  }

 private:
  const ContourBody& body_;
  const LimbPoseCost& judge_;
  const ContourPose& fitted_;
  const LimbJoints joints_;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
  std::vector<LimbPoseSample> places_;
  size_t judged_ = 0;
};

/// Half of them bend as expected, half anyhow.
void drawFirst(const ContourPose& expected, const LimbJoints& joints, LimbPoseSampler& tries) {
  const auto bendOf = [&](size_t i, size_t count) {
    const double range = joints.hinge_upper - joints.hinge_lower;
    return i % 2 ? joints.hinge_lower + range * double(i) / double(count)
                 : expected.angles[size_t(joints.hinge)];
  };
  for (size_t i = 0; i < kTriesNear; ++i) tries.draw(expected, bendOf(i, kTriesNear), 1.0);
  for (size_t i = 0; i < kTriesAnywhere; ++i) {
    ContourPose turned = expected;
    Eigen::Matrix3d& R = turned.rotations[size_t(joints.ball)];
    R = turnTo(direction(i, kTriesAnywhere), R);
    tries.draw(turned, bendOf(i, kTriesAnywhere), kCloser);
  }
}

}  // namespace

std::vector<ContourPose> alternativeLimbPoses(const ContourObservation& seen, const CameraRig& rig,
                                              const ContourOptions& options,
                                              const ContourBody& body, const ContourPose& fitted,
                                              const ContourPose& expected, ContourLimb::Id limb) {
  const LimbJoints joints = jointsOf(limb);
  LimbPoseCost judge(seen, rig, options, limb);
  judge.lookFor(body, fitted);
  LimbPoseSampler tries(body, judge, fitted, joints);
  drawFirst(expected, joints, tries);
  std::vector<LimbPoseSample> chosen;
  for (size_t j = 0; j < kJudges; ++j) {
    const std::vector<LimbPoseSample>& first = tries.judged(j);
    const std::vector<LimbPoseSample> best(first.begin(), first.begin() + kBest);
    for (const LimbPoseSample& place : best)
      for (size_t i = 0; i < kTriesAround; ++i)
        tries.draw(place.pose, place.pose.angles[size_t(joints.hinge)], kCloser);
    choose(tries.judged(j), chosen);
  }
  std::vector<ContourPose> poses;
  for (const LimbPoseSample& place : chosen) poses.push_back(place.pose);
  return poses;
}

}  // namespace markerless_mocap
