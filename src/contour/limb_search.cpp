#include "contour/limb_search.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "contour/pose_priors.h"
#include "contour/pose_problem.h"
#include "contour/robust.h"

namespace markerless_mocap {
namespace {

constexpr size_t kTries = 120, kBest = 6, kTriesAround = 10;
constexpr size_t kPlaces = 3;
constexpr double kFarApart = 0.12;  // metres, of the limb's ends

// Standard deviations of tries: balls in turn by these, hinges; radians.
constexpr double kBallSpread[] = {0.4, 0.9, 1.5}, kHingeSpread = 0.6;
constexpr double kCloser = 0.25;  // of these, around the best of the first tries

constexpr double kOutlier = 0.1;  // of rays, metres

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
  double energy;
  Eigen::Vector3d end;
};

/// Half the weighted robust squares of the rays given and of what sticks out of masks.
class PlaceJudge {
 public:
  PlaceJudge(const ContourObservation& seen, const CameraRig& rig, const ContourOptions& options)
      : seen_(seen), rig_(rig), options_(options) {}

  /// Rays that the body at this pose leaves unexplained.
  void lookFor(const ContourBody& body, const ContourPose& pose) {
    PoseProblem problem(seen_, rig_, options_);
    problem.evaluate(body, pose, kOutlier);
    for (size_t i = 0; i < seen_.rays.size(); ++i)
      if (std::abs(problem.matches()[i].residual) > kRayExplained) rays_.push_back(seen_.rays[i]);
  }

  double energy(const ContourBody& body, const ContourPose& pose) {
    ContourFrames frames;
    PlacedCones cones;
    body.place(pose, frames);
    body.place(frames, cones);
    matchRays(ConeLanes(cones), rays_, matches_);
    double rays = 0.0;
    for (const RayMatch& match : matches_) {
      const double square = double(match.residual) * double(match.residual);
      rays += square / (1.0 + square / (kOutlier * kOutlier));
    }
    const double one = options_.contour_weight / double(std::max<size_t>(1, seen_.rays.size()));
    const double outside = options_.containment_weight * excessEnergy(seen_, rig_, cones);
    return 0.5 * (one * rays + outside) / (options_.sigma * options_.sigma) + postureEnergy(pose);
  }

 private:
  const ContourObservation& seen_;
  const CameraRig& rig_;
  const ContourOptions& options_;
  std::vector<ContourRay> rays_;
  std::vector<RayMatch> matches_;
};

void sortByEnergy(std::vector<Place>& places) {
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.energy < b.energy; });
}

/// The first few whose ends are not near to one another.
std::vector<ContourPose> farApart(const std::vector<Place>& places) {
  std::vector<Place> chosen;
  for (const Place& place : places) {
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const Place& other) {
      return (place.end - other.end).norm() < kFarApart;
    });
    if (!near) chosen.push_back(place);
    if (chosen.size() == kPlaces) break;
  }
  std::vector<ContourPose> poses;
  for (const Place& place : chosen) poses.push_back(place.pose);
  return poses;
}

}  // namespace

std::vector<ContourPose> otherPlaces(const ContourObservation& seen, const CameraRig& rig,
                                     const ContourOptions& options, const ContourBody& body,
                                     const ContourPose& fitted, const ContourPose& expected,
                                     ContourLimb::Id limb) {
  const LimbJoints joints = jointsOf(limb);
  PlaceJudge judge(seen, rig, options);
  judge.lookFor(body, fitted);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Place> places;
  const auto tryAround = [&](const ContourPose& middle, double share) {
    const double spread = share * kBallSpread[places.size() % std::size(kBallSpread)];
    const double x = normal(random), y = normal(random), z = normal(random);
    const double bend = middle.angles[size_t(joints.hinge)] + share * kHingeSpread * normal(random);
    Place place{fitted, 0.0, {}};
    place.pose.balls[size_t(joints.ball)] =
        middle.balls[size_t(joints.ball)] * rotationOf(spread * Eigen::Vector3d(x, y, z));
    place.pose.angles[size_t(joints.hinge)] =
        std::clamp(bend, joints.hinge_lower, joints.hinge_upper);
    place.energy = judge.energy(body, place.pose);
    place.end = body.points(place.pose).col(joints.end);
    places.push_back(place);
  };
  for (size_t i = 0; i < kTries; ++i) tryAround(expected, 1.0);
  sortByEnergy(places);
  const std::vector<Place> best(places.begin(), places.begin() + kBest);
  for (const Place& place : best)
    for (size_t i = 0; i < kTriesAround; ++i) tryAround(place.pose, kCloser);
  sortByEnergy(places);
  return farApart(places);
}

}  // namespace markerless_mocap
