#include "contour/limb_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "contour/pose_priors.h"
#include "contour/pose_problem.h"
#include "contour/robust.h"

namespace markerless_mocap {
namespace {

constexpr size_t kTriesNear = 240, kTriesAnywhere = 240, kBest = 6, kTriesAround = 10;
constexpr size_t kPlaces = 4;
constexpr double kFarApart = 0.12;  // metres, of the limb's ends

// Standard deviations of tries: balls in turn by these, twists about the limb, hinges; radians.
constexpr double kBallSpread[] = {0.2, 0.6, 1.5}, kTwistSpread = 1.0, kHingeSpread = 0.6;
constexpr double kCloser = 0.25;  // of these, around the best of the first tries

// Places are judged sharply, which tells near ones apart, and bluntly, which tells far ones whose
// surroundings are right: distance from which on a ray is mostly ignored, metres.
constexpr double kOutliers[] = {0.1, 0.25};
constexpr size_t kJudges = 2;

/// The joints of a limb that are tried, and its end among contourPointNames().
struct LimbJoints {
  int ball, hinge, end;
  double hinge_lower, hinge_upper;
};
LimbJoints jointsOf(ContourLimb::Id limb) {
  constexpr LimbJoints kJoints[] = {
      {ContourBall::kLeftShoulder, ContourAngle::kLeftElbow, 5, 0.0, 2.6},
      {ContourBall::kRightShoulder, ContourAngle::kRightElbow, 8, 0.0, 2.6},
      {ContourBall::kLeftHip, ContourAngle::kLeftKnee, 11, -2.6, 0.0},
      {ContourBall::kRightHip, ContourAngle::kRightKnee, 14, -2.6, 0.0}};
  return kJoints[limb - ContourLimb::kLeftArm];
}

struct Place {
  ContourPose pose;
  std::array<double, kJudges> energy;  ///< by each of kOutliers
  Eigen::Vector3d end;
};

/// Half the weighted robust squares of the rays given and of what sticks out of masks.
class PlaceJudge {
 public:
  PlaceJudge(const ContourObservation& seen, const CameraRig& rig, const ContourOptions& options,
             ContourLimb::Id limb)
      : seen_(seen), rig_(rig), options_(options), limb_(limb) {}

  /// Takes the rays that touch the limb at this pose or that nothing explains.
  void lookFor(const ContourBody& body, const ContourPose& pose) {
    PoseProblem problem(seen_, rig_, options_);
    problem.evaluate(body, pose, kOutliers[0]);
    for (size_t i = 0; i < seen_.rays.size(); ++i)
      if (std::abs(problem.matches()[i].residual) > kRayExplained ||
          limbOfCone(problem.matches()[i].cone) == limb_)
        rays_.push_back(seen_.rays[i]);
  }

  std::array<double, kJudges> energy(const ContourBody& body, const ContourPose& pose) {
    ContourFrames frames;
    PlacedCones cones;
    body.place(pose, frames);
    body.place(frames, cones);
    matchRays(ConeLanes(cones), rays_, matches_);
    const double variance = options_.sigma * options_.sigma;
    const double one = options_.contour_weight / double(std::max<size_t>(1, seen_.rays.size()));
    const double outside = options_.containment_weight * excessEnergy(seen_, rig_, cones, limb_);
    std::array<double, kJudges> energies;
    energies.fill(0.5 * outside / variance + postureEnergy(pose));
    for (size_t judge = 0; judge < kJudges; ++judge)
      for (const RayMatch& match : matches_) {
        const double square = double(match.residual) * double(match.residual);
        const double share = square / (kOutliers[judge] * kOutliers[judge]);
        energies[judge] += 0.5 * one / variance * square / (1.0 + share);
      }
    return energies;
  }

 private:
  const ContourObservation& seen_;
  const CameraRig& rig_;
  const ContourOptions& options_;
  const ContourLimb::Id limb_;
  std::vector<ContourRay> rays_;
  std::vector<RayMatch> matches_;
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

void sortByEnergy(size_t judge, std::vector<Place>& places) {
  std::stable_sort(places.begin(), places.end(), [&](const Place& a, const Place& b) {
    return a.energy[judge] < b.energy[judge];
  });
}

/// Adds the first few whose ends are not near to one another.
void choose(const std::vector<Place>& places, std::vector<Place>& chosen) {
  const size_t enough = chosen.size() + kPlaces;
  for (const Place& place : places) {
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const Place& other) {
      return (place.end - other.end).norm() < kFarApart;
    });
    if (!near) chosen.push_back(place);
    if (chosen.size() == enough) return;
  }
}

}  // namespace

std::vector<ContourPose> otherPlaces(const ContourObservation& seen, const CameraRig& rig,
                                     const ContourOptions& options, const ContourBody& body,
                                     const ContourPose& fitted, const ContourPose& expected,
                                     ContourLimb::Id limb) {
  const LimbJoints joints = jointsOf(limb);
  PlaceJudge judge(seen, rig, options, limb);
  judge.lookFor(body, fitted);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Place> places;
  const auto tryAround = [&](const ContourPose& middle, double bend, double share) {
    const double spread = share * kBallSpread[places.size() % std::size(kBallSpread)];
    const double x = normal(random), y = normal(random), twist = normal(random);
    const Eigen::Vector3d turn(spread * x, spread * y, share * kTwistSpread * twist);
    Place place{fitted, {}, {}};
    place.pose.balls[size_t(joints.ball)] = middle.balls[size_t(joints.ball)] * rotationOf(turn);
    place.pose.angles[size_t(joints.hinge)] = std::clamp(
        bend + share * kHingeSpread * normal(random), joints.hinge_lower, joints.hinge_upper);
    place.energy = judge.energy(body, place.pose);
    place.end = body.points(place.pose).col(joints.end);
    places.push_back(place);
  };
  // Half of them bend as expected, half anyhow.
  const auto bendOf = [&](size_t i, size_t count) {
    const double range = joints.hinge_upper - joints.hinge_lower;
    return i % 2 ? joints.hinge_lower + range * double(i) / double(count)
                 : expected.angles[size_t(joints.hinge)];
  };
  for (size_t i = 0; i < kTriesNear; ++i) tryAround(expected, bendOf(i, kTriesNear), 1.0);
  for (size_t i = 0; i < kTriesAnywhere; ++i) {
    ContourPose turned = expected;
    Eigen::Matrix3d& R = turned.balls[size_t(joints.ball)];
    R = turnTo(direction(i, kTriesAnywhere), R);
    tryAround(turned, bendOf(i, kTriesAnywhere), kCloser);
  }
  std::vector<Place> chosen;
  for (size_t j = 0; j < kJudges; ++j) {
    sortByEnergy(j, places);
    const std::vector<Place> best(places.begin(), places.begin() + kBest);
    for (const Place& place : best)
      for (size_t i = 0; i < kTriesAround; ++i)
        tryAround(place.pose, place.pose.angles[size_t(joints.hinge)], kCloser);
    sortByEnergy(j, places);
    choose(places, chosen);
  }
  std::vector<ContourPose> poses;
  for (const Place& place : chosen) poses.push_back(place.pose);
  return poses;
}

}  // namespace markerless_mocap
