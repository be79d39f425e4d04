#include "contour/fit/limb_evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "contour/fit/geman_mcclure.h"
#include "contour/fit/pose_priors.h"

namespace markerless_mocap {
namespace {

using Square = Eigen::Matrix<double, kContourDof, kContourDof>;
using ByLimb = std::array<double, ContourLimb::kCount>;

// Rays and masks agree with no limb better than to this share of sigma: sizes are not exact.
constexpr double kBestAgreement = 0.75;

// How rays count for independent ones: learned from errors made on films of the virtual studio.
constexpr double kAlike = 0.7;

constexpr double kAnything = 1.0;  // rad and metres: the deviation of what nothing is known of

constexpr double kNowhere = 1e4;  // metres: where no ray is near

double square(double value) {
  return value * value;
}

/// Counts rays and balls. Returns how far rays and masks disagree with each limb: mean robust
/// square of its rays' distances plus mean square by which its balls stick out, square metres.
ByLimb tally(const ContourOptions& options, const PoseProblem& problem, ContourFit& fit) {
  std::array<int, ContourLimb::kCount> rays{}, balls{};
  ByLimb distances{}, excesses{};
  size_t explained = 0;
  for (const RayMatch& match : problem.matches()) {
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
  for (int c = 0; c < kContourCones; ++c)
    for (const double excess : problem.excess()[size_t(c)]) {
      ++balls[limbOfCone(c)];
      fit.limbs[limbOfCone(c)].outside += excess;
      excesses[limbOfCone(c)] += square(excess);
    }
  ByLimb disagreement;
  for (size_t l = 0; l < ContourLimb::kCount; ++l) {
    LimbEvidence& limb = fit.limbs[l];
    limb.distance = std::sqrt(limb.distance / std::max(1, limb.rays));
    limb.outside /= balls[l];
    disagreement[l] = distances[l] / std::max(1, rays[l]) + excesses[l] / balls[l];
  }
  fit.rays_explained = double(explained) / double(std::max<size_t>(1, problem.matches().size()));
  return disagreement;
}

/// The body's cones but for those of one limb.
ContourWorldCones without(ContourLimb::Id limb, ContourWorldCones cones) {
  for (int c = 0; c < kContourCones; ++c)
    if (limbOfCone(c) == limb) cones[size_t(c)].a = cones[size_t(c)].b.setConstant(kNowhere);
  return cones;
}

/// Of each ray the share that speaks for the limb it touches: a ray that another limb would explain
/// as well, were this one not there, tells nothing of it. It is the rise of the robust error over
/// its largest. Of other limbs than arms all rays speak.
std::vector<double> shares(const ContourObservation& seen, const ContourOptions& options,
                           const PoseProblem& problem) {
  std::vector<double> out(seen.rays.size(), 1.0);
  const double largest = square(options.robust_scale_final);
  for (const auto arm : {ContourLimb::kLeftArm, ContourLimb::kRightArm}) {
    std::vector<size_t> touching;
    std::vector<ContourRay> rays;
    for (size_t i = 0; i < seen.rays.size(); ++i)
      if (limbOfCone(problem.matches()[i].cone) == arm) {
        touching.push_back(i);
        rays.push_back(seen.rays[i]);
      }
    std::vector<RayMatch> others;
    matchRays(PackedContourCones(without(arm, problem.cones())), rays, others);
    for (size_t i = 0; i < rays.size(); ++i) {
      const double rise =
          gemanMcClureLoss(others[i].residual, options.robust_scale_final) -
          gemanMcClureLoss(problem.matches()[touching[i]].residual, options.robust_scale_final);
      out[touching[i]] = std::max(0.0, rise / largest);
    }
  }
  return out;
}

/// Variance that a limb's rays are taken to have, square metres: that with which rays and masks
/// disagree with it. What all limbs share comes from calibration and noise, which differ from
/// camera to camera and average out; it counts by the geometric mean with what is usual.
ByLimb varianceOf(const ContourOptions& options, ByLimb disagreement) {
  const double least = square(kBestAgreement * options.ray_sigma);
  for (double& limb : disagreement) limb = std::max(limb, least);
  const double shared = *std::min_element(disagreement.begin(), disagreement.end());
  for (double& limb : disagreement) limb *= kAlike * options.ray_sigma / std::sqrt(shared);
  return disagreement;
}

/// What rays and the posture alone know of the pose. What was predicted, and masks that a limb does
/// not leave, hold a limb but do not show where it is.
Square knowledge(const ContourObservation& seen, const ContourOptions& options,
                 const PoseProblem& problem, const ContourPose& pose, const ByLimb& variance) {
  AllConeNormalEquations sums;
  const std::vector<double> share = shares(seen, options, problem);
  const double one = options.effective_rays / std::max(1.0, double(seen.rays.size()));
  for (size_t i = 0; i < seen.rays.size(); ++i) {
    const RayMatch& match = problem.matches()[i];
    const double weight = share[i] * one / variance[limbOfCone(match.cone)];
    addRay(seen.rays[i], match,
           weight * gemanMcClureWeight(match.residual, options.robust_scale_final), sums);
  }
  PoseNormalEquations equations;
  equations.clear();
  accumulatePoseEquations(sums, problem.frames(), problem.cones(), equations);
  addPosturePriors(pose, equations);
  addArmRestPrior(pose, equations);
  equations.H.diagonal().array() += 1.0 / square(kAnything);
  return equations.H;
}

/// Standard deviation of where a limb's end is, metres.
double endDeviation(const ContourBody& body, const ContourFrames& frames,
                    const Eigen::LLT<Square>& inverse, int limb) {
  // By ContourLimb: neck's base, head, wrists, ankles among contourPointNames().
  constexpr int kEnds[ContourLimb::kCount] = {1, 2, 5, 8, 11, 14};
  const AttachedPoint& end = contourKinematicTree().points[size_t(kEnds[limb])];
  Eigen::Matrix<double, 3, kContourDof> J;
  poseJacobian(frames, end.segment,
               frames.t[end.segment] + frames.R[end.segment] * end.local.at(body.sizes()), J);
  return std::sqrt((J * inverse.solve(J.transpose())).trace());
}

}  // namespace

void gatherEvidence(const ContourObservation& seen, const ContourOptions& options,
                    const ContourBody& body, const PoseProblem& problem, ContourFit& fit) {
  const ByLimb variance = varianceOf(options, tally(options, problem, fit));
  const Eigen::LLT<Square> inverse(knowledge(seen, options, problem, fit.pose, variance));
  for (int limb = 0; limb < ContourLimb::kCount; ++limb)
    fit.limbs[size_t(limb)].deviation = endDeviation(body, problem.frames(), inverse, limb);
}

}  // namespace markerless_mocap
