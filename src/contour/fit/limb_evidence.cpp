#include "contour/fit/limb_evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "contour/fit/geman_mcclure.h"
#include "contour/fit/pose_priors.h"
#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

using Square = Eigen::Matrix<double, kContourDof, kContourDof>;
using ByLimb = std::array<double, ContourLimb::kCount>;

// Minimum disagreement of rays and masks with a limb, as a fraction of sigma: the shape is not
// exact.
constexpr double kMinDisagreement = 0.75;

// Factor on the variance of rays, which are not independent: learned from the errors on sequences
// of the virtual studio.
constexpr double kCorrelation = 0.7;

constexpr double kUnobservedDeviation = 1.0;  // rad and metres: standard deviation of the prior of
                                              // an unobserved pose

constexpr double kFarAway = 1e4;  // metres: position far from all rays

double square(double value) {
  return value * value;
}

/// Counts rays and spheres. Returns for each limb how far rays and masks disagree with it, square
/// metres: mean robust loss of its rays' distances plus mean square distance of its spheres outside
/// the masks.
ByLimb tally(const ContourObservation& seen, const ContourOptions& options,
             const PoseProblem& problem, ContourFit& fit) {
  std::array<int, ContourLimb::kCount> rays{}, spheres{};
  ByLimb distances{}, outside{};
  int explained = 0;
  for (size_t i = 0; i < seen.rays.size(); ++i) {
    const RayMatch& match = problem.matches()[i];
    const size_t l = limbOfCone(match.cone);
    LimbEvidence& limb = fit.limbs[l];
    const double distance = std::abs(double(match.residual));
    ++rays[l];
    distances[l] += gemanMcClureLoss(distance, options.robust_scale_final);
    if (!(distance < kRayExplained)) continue;
    ++explained;
    ++limb.rays;
    limb.distance += square(distance);
  }
  for (int c = 0; c < kContourCones; ++c) {
    const size_t l = limbOfCone(c);
    double part = 0.0;
    for (const double distance : problem.violation()[size_t(c)]) {
      part += distance;
      outside[l] += square(distance);
    }
    spheres[l] += kSpheresPerCone;
    fit.limbs[l].outside += part;
    fit.limbs[l].part_outside = std::max(fit.limbs[l].part_outside, part / kSpheresPerCone);
  }
  ByLimb disagreement;
  for (size_t l = 0; l < ContourLimb::kCount; ++l) {
    LimbEvidence& limb = fit.limbs[l];
    limb.distance = std::sqrt(limb.distance / std::max(1, limb.rays));
    limb.outside /= spheres[l];
    disagreement[l] = distances[l] / std::max(1, rays[l]) + outside[l] / spheres[l];
  }
  fit.rays_explained = double(explained) / double(std::max<size_t>(1, seen.rays.size()));
  return disagreement;
}

/// The body without the cones of one limb.
ContourWorldCones without(ContourLimb::Id limb, ContourWorldCones cones) {
  for (int c = 0; c < kContourCones; ++c)
    if (limbOfCone(c) == limb) cones[size_t(c)].a = cones[size_t(c)].b.setConstant(kFarAway);
  return cones;
}

/// Weight of each ray, 0 to 1. A ray that touches an arm tells little if the rest of the body would
/// explain it, too. Its weight is the increase of the robust loss without the arm, divided by the
/// maximum of the loss. All other rays have weight 1.
std::vector<double> rayWeights(const ContourObservation& seen, const ContourOptions& options,
                               const PoseProblem& problem) {
  std::vector<double> out(seen.rays.size(), 1.0);
  const double max_loss = square(options.robust_scale_final);
  for (const auto arm : {ContourLimb::kLeftArm, ContourLimb::kRightArm}) {
    std::vector<size_t> touching;
    std::vector<ContourRay> rays;
    for (size_t i = 0; i < seen.rays.size(); ++i)
      if (limbOfCone(problem.matches()[i].cone) == arm) {
        touching.push_back(i);
        rays.push_back(seen.rays[i]);
      }
    std::vector<RayMatch> others;
    matchRays(ConesInViews(seen, without(arm, problem.cones())), rays, others);
    for (size_t i = 0; i < rays.size(); ++i) {
      const double rise =
          gemanMcClureLoss(others[i].residual, options.robust_scale_final) -
          gemanMcClureLoss(problem.matches()[touching[i]].residual, options.robust_scale_final);
      out[touching[i]] = std::max(0.0, rise / max_loss);
    }
  }
  return out;
}

/// Variance of the rays of each limb, square metres. It follows from the disagreement of rays and
/// masks with the limb. The part that is common to all limbs comes from calibration and noise. It
/// differs from camera to camera and averages out, so it enters by the geometric mean with the
/// usual variance.
ByLimb varianceOf(const ContourOptions& options, ByLimb disagreement) {
  const double minimum = square(kMinDisagreement * options.ray_sigma);
  for (double& limb : disagreement) limb = std::max(limb, minimum);
  const double shared = *std::min_element(disagreement.begin(), disagreement.end());
  for (double& limb : disagreement) limb *= kCorrelation * options.ray_sigma / std::sqrt(shared);
  return disagreement;
}

/// Information matrix of the pose from rays and posture priors. Motion prior and containment are
/// left out: they constrain a limb without showing where it is.
Square information(const ContourObservation& seen, const ContourOptions& options,
                   const PoseProblem& problem, const ContourPose& pose, const ByLimb& variance) {
  AllConeNormalEquations sums;
  const std::vector<double> ray_weight = rayWeights(seen, options, problem);
  const double one = options.effective_rays / std::max(1.0, double(seen.rays.size()));
  for (size_t i = 0; i < seen.rays.size(); ++i) {
    const RayMatch& match = problem.matches()[i];
    const double weight = ray_weight[i] * one / variance[limbOfCone(match.cone)];
    addRay(seen.rays[i], match,
           weight * gemanMcClureWeight(match.residual, options.robust_scale_final), sums);
  }
  PoseNormalEquations equations;
  equations.clear();
  accumulatePoseEquations(sums, problem.frames(), problem.cones(), equations);
  addPosturePriors(pose, equations);
  addArmRestPrior(pose, equations);
  equations.H.diagonal().array() += 1.0 / square(kUnobservedDeviation);
  return equations.H;
}

/// Standard deviation of the position of a limb's end, metres.
double endDeviation(const ContourBody& body, const ContourFrames& frames,
                    const Eigen::LLT<Square>& inverse, int limb) {
  const AttachedPoint& end = contourKinematicTree().points[endOfLimb(ContourLimb::Id(limb))];
  Eigen::Matrix<double, 3, kContourDof> J;
  poseJacobian(frames, end.segment,
               frames.t[end.segment] + frames.R[end.segment] * end.local.at(body.shape()), J);
  return std::sqrt((J * inverse.solve(J.transpose())).trace());
}

bool isInside(const Eigen::Vector3d& point, const ContourWorldCone& cone) {
  const Eigen::Vector3d axis = cone.b - cone.a;
  const double along = nearestFraction(point, cone.a, axis);
  const double radius = cone.radius_a + along * (cone.radius_b - cone.radius_a);
  return (point - cone.a - along * axis).norm() < radius;
}

/// Fraction of a limb's axis that is inside the trunk.
double insideFraction(const ContourWorldCones& cones, int limb) {
  constexpr std::array<double, 4> kPlaces{0.125, 0.375, 0.625, 0.875};
  int inside = 0, all = 0;
  for (int c = 0; c < kContourCones; ++c) {
    if (limbOfCone(c) != limb) continue;
    for (const double place : kPlaces) {
      const Eigen::Vector3d point =
          cones[size_t(c)].a + place * (cones[size_t(c)].b - cones[size_t(c)].a);
      ++all;
      for (int other = 0; other < kContourCones; ++other)
        if (limbOfCone(other) == ContourLimb::kTrunk && isInside(point, cones[size_t(other)])) {
          ++inside;
          break;
        }
    }
  }
  return double(inside) / all;
}

}  // namespace

void gatherEvidence(const ContourObservation& seen, const ContourOptions& options,
                    const ContourBody& body, const PoseProblem& problem, ContourFit& fit) {
  const ByLimb variance = varianceOf(options, tally(seen, options, problem, fit));
  const Eigen::LLT<Square> inverse(information(seen, options, problem, fit.pose, variance));
  for (int limb = 0; limb < ContourLimb::kCount; ++limb)
    fit.limbs[size_t(limb)].deviation = endDeviation(body, problem.frames(), inverse, limb);
  for (int limb = ContourLimb::kLeftArm; limb < ContourLimb::kCount; ++limb)
    fit.limbs[size_t(limb)].inside = insideFraction(problem.cones(), limb);
}

}  // namespace markerless_mocap
