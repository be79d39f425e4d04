#include "contour/track/limb_search.h"

#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "contour/fit/geman_mcclure.h"
#include "contour/fit/pose_priors.h"
#include "contour/fit/pose_problem.h"
#include "contour/model/angle_ranges.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

constexpr size_t kSamplesNear = 240, kSamplesAnywhere = 160, kBest = 6, kSamplesAround = 10;
constexpr size_t kChosen = 4;
constexpr double kMinDistance = 0.12;  // metres, of the limb's ends

// Standard deviations of the samples, radians: swing of the spherical joint (in turn), its twist,
// and the hinge.
constexpr double kSwingDeviation[] = {0.2, 0.6, 1.5}, kTwistDeviation = 1.0, kHingeDeviation = 0.6;
constexpr double kRefinementFactor = 0.25;  // factor on these for samples around the best ones

// Robust scales of the two costs, metres. The small one distinguishes nearby positions; the large
// one finds far positions whose surroundings are right.
constexpr double kRobustScales[] = {0.1, 0.25};
constexpr size_t kCosts = 2;
constexpr size_t kMaxRays = 120;  // maximum number of rays in the cost

// Samples bend less than the joint's limit by this much, radians; a fit may bend them further.
constexpr double kUnsampledBend = 0.1;

/// The sampled joints of a limb.
struct LimbJoints {
  ContourLimb::Id limb;
  int joint, hinge;
};
LimbJoints jointsOf(ContourLimb::Id limb) {
  constexpr LimbJoints kJoints[] = {
      {ContourLimb::kLeftArm, SphericalJoint::kLeftShoulder, RevoluteJoint::kLeftElbow},
      {ContourLimb::kRightArm, SphericalJoint::kRightShoulder, RevoluteJoint::kRightElbow},
      {ContourLimb::kLeftLeg, SphericalJoint::kLeftHip, RevoluteJoint::kLeftKnee},
      {ContourLimb::kRightLeg, SphericalJoint::kRightHip, RevoluteJoint::kRightKnee}};
  return kJoints[limb - ContourLimb::kLeftArm];
}

/// The sampled angles of a limb's hinge, which is straight at 0.
AngleRange sampledBend(const LimbJoints& joints) {
  AngleRange range = kAngleRanges[size_t(joints.hinge)];
  if (range.lower < 0.0) range.lower += kUnsampledBend;
  if (range.upper > 0.0) range.upper -= kUnsampledBend;
  return range;
}

struct LimbPoseSample {
  ContourPose pose;
  std::array<double, kCosts> energy;  ///< for each of kRobustScales
  Eigen::Vector3d end;
};

/// Energy of a limb: robust losses of selected rays, containment, and priors.
class LimbPoseCost {
 public:
  LimbPoseCost(const ContourObservation& seen, const CameraRig& rig, const ContourOptions& options,
               ContourLimb::Id limb)
      : seen_(seen), rig_(rig), options_(options), limb_(limb) {}

  /// Selects the rays that touch the limb at this pose and those that nothing explains.
  void selectRays(const ContourBody& body, const ContourPose& pose) {
    PoseProblem problem(seen_, rig_, options_);
    problem.evaluate(body, pose, kRobustScales[0]);
    std::vector<size_t> found;
    for (size_t i = 0; i < seen_.rays.size(); ++i)
      if (std::abs(problem.matches()[i].residual) > kRayExplained ||
          limbOfCone(problem.matches()[i].cone) == limb_)
        found.push_back(i);
    const size_t step = found.size() / kMaxRays + 1;
    for (size_t i = 0; i < found.size(); i += step) rays_.push_back(seen_.rays[found[i]]);
    rays_per_selected_ = double(step);
  }

  std::array<double, kCosts> energy(const ContourBody& body, const ContourPose& pose) const {
    ContourFrames frames;
    ContourWorldCones cones;
    body.place(pose, frames);
    body.place(frames, cones);
    std::vector<RayMatch> matches;
    matchRays(ConesInViews(seen_, cones), rays_, matches);
    const double variance = options_.ray_sigma * options_.ray_sigma;
    const double one = rays_per_selected_ * options_.effective_rays /
                       double(std::max<size_t>(1, seen_.rays.size()));
    const double outside =
        options_.containment_weight * containmentEnergy(seen_, rig_, cones, limb_);
    std::array<double, kCosts> energies;
    energies.fill(0.5 * outside / variance + postureEnergy(pose) + armRestEnergy(pose));
    for (size_t cost = 0; cost < kCosts; ++cost)
      for (size_t i = 0; i < rays_.size(); ++i)
        energies[cost] +=
            0.5 * one / variance * gemanMcClureLoss(matches[i].residual, kRobustScales[cost]);
    return energies;
  }

 private:
  const ContourObservation& seen_;
  const CameraRig& rig_;
  const ContourOptions& options_;
  const ContourLimb::Id limb_;
  std::vector<ContourRay> rays_;
  double rays_per_selected_ = 1.0;  ///< number of rays that each selected ray represents
};

/// Directions evenly distributed over the sphere; consecutive ones are far apart (Fibonacci
/// lattice).
Eigen::Vector3d direction(size_t i, size_t count) {
  const size_t shuffled = i * 37 % count;  // 37 and the count have no common factor
  const double z = 1.0 - (2.0 * double(shuffled) + 1.0) / double(count);
  const double turn = double(shuffled) * M_PI * (3.0 - std::sqrt(5.0)), r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// R after the shortest rotation that turns its z axis to `z`.
Eigen::Matrix3d turnTo(const Eigen::Vector3d& z, const Eigen::Matrix3d& R) {
  return shortestRotation(Eigen::Vector3d(R.col(2)), z).toRotationMatrix() * R;
}

/// Adds the first few samples whose ends are far from those already chosen.
void choose(const std::vector<LimbPoseSample>& samples, std::vector<LimbPoseSample>& chosen) {
  const size_t enough = chosen.size() + kChosen;
  for (const LimbPoseSample& sample : samples) {
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const LimbPoseSample& other) {
      return (sample.end - other.end).norm() < kMinDistance;
    });
    if (!near) chosen.push_back(sample);
    if (chosen.size() == enough) return;
  }
}

/// Draws samples one after another and evaluates them in parallel batches.
class LimbPoseSampler {
 public:
  LimbPoseSampler(const ContourBody& body, const LimbPoseCost& cost, const ContourPose& fitted,
                  const LimbJoints& joints)
      : body_(body), cost_(cost), fitted_(fitted), joints_(joints), bend_(sampledBend(joints)) {}

  /// Draws a pose whose limb is near to that of `middle`, with the hinge near to `bend`. \param
  /// scale factor on the standard deviations
  void draw(const ContourPose& middle, double bend, double scale) {
    const double spread = scale * kSwingDeviation[samples_.size() % std::size(kSwingDeviation)];
    const double x = normal_(random_), y = normal_(random_), twist = normal_(random_);
    const Eigen::Vector3d turn(spread * x, spread * y, scale * kTwistDeviation * twist);
    LimbPoseSample sample{fitted_, {}, {}};
    sample.pose.rotations[size_t(joints_.joint)] =
        middle.rotations[size_t(joints_.joint)] * expSO3(turn);
    sample.pose.angles[size_t(joints_.hinge)] =
        std::clamp(bend + scale * kHingeDeviation * normal_(random_), bend_.lower, bend_.upper);
    samples_.push_back(sample);
  }

  /// All samples so far, sorted by one of the costs.
  const std::vector<LimbPoseSample>& sortedBy(size_t cost) {
    tbb::parallel_for(
        tbb::blocked_range<size_t>(evaluated_, samples_.size(), 16), [&](const auto& some) {
          for (size_t i = some.begin(); i < some.end(); ++i) {
            LimbPoseSample& sample = samples_[i];
            sample.energy = cost_.energy(body_, sample.pose);
            sample.end = body_.points(sample.pose).col(Eigen::Index(endOfLimb(joints_.limb)));
          }
        });
    std::stable_sort(samples_.begin(), samples_.end(),
                     [&](const LimbPoseSample& a, const LimbPoseSample& b) {
                       return a.energy[cost] < b.energy[cost];
                     });
    evaluated_ = samples_.size();
    return samples_;
  }

 private:
  const ContourBody& body_;
  const LimbPoseCost& cost_;
  const ContourPose& fitted_;
  const LimbJoints joints_;
  const AngleRange bend_;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
  std::vector<LimbPoseSample> samples_;
  size_t evaluated_ = 0;
};

/// Half of the samples bend as expected, the other half are evenly distributed over the range.
void drawFirst(const ContourPose& expected, const LimbJoints& joints, LimbPoseSampler& sampler) {
  const AngleRange bend = sampledBend(joints);
  const auto bendOf = [&](size_t i, size_t count) {
    const double range = bend.upper - bend.lower;
    return i % 2 ? bend.lower + range * double(i) / double(count)
                 : expected.angles[size_t(joints.hinge)];
  };
  for (size_t i = 0; i < kSamplesNear; ++i) sampler.draw(expected, bendOf(i, kSamplesNear), 1.0);
  for (size_t i = 0; i < kSamplesAnywhere; ++i) {
    ContourPose turned = expected;
    Eigen::Matrix3d& R = turned.rotations[size_t(joints.joint)];
    R = turnTo(direction(i, kSamplesAnywhere), R);
    sampler.draw(turned, bendOf(i, kSamplesAnywhere), kRefinementFactor);
  }
}

}  // namespace

std::vector<ContourPose> alternativeLimbPoses(const ContourObservation& seen, const CameraRig& rig,
                                              const ContourOptions& options,
                                              const ContourBody& body, const ContourPose& fitted,
                                              const ContourPose& expected, ContourLimb::Id limb) {
  const LimbJoints joints = jointsOf(limb);
  LimbPoseCost cost(seen, rig, options, limb);
  cost.selectRays(body, fitted);
  LimbPoseSampler sampler(body, cost, fitted, joints);
  drawFirst(expected, joints, sampler);
  std::vector<LimbPoseSample> chosen;
  for (size_t j = 0; j < kCosts; ++j) {
    const std::vector<LimbPoseSample>& first = sampler.sortedBy(j);
    const std::vector<LimbPoseSample> best(first.begin(), first.begin() + kBest);
    for (const LimbPoseSample& sample : best)
      for (size_t i = 0; i < kSamplesAround; ++i)
        sampler.draw(sample.pose, sample.pose.angles[size_t(joints.hinge)], kRefinementFactor);
    choose(sampler.sortedBy(j), chosen);
  }
  std::vector<ContourPose> poses;
  for (const LimbPoseSample& sample : chosen) poses.push_back(sample.pose);
  return poses;
}

}  // namespace markerless_mocap
