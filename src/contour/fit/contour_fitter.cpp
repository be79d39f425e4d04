#include "contour/fit/contour_fitter.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contour/fit/body_overlap.h"
#include "contour/fit/limb_evidence.h"
#include "contour/fit/pose_priors.h"
#include "contour/fit/pose_problem.h"
#include "contour/model/pose_step.h"

namespace markerless_mocap {
namespace {

// Damping of the Gauss-Newton steps, besides that of dampPose(): a fraction of the diagonal.
constexpr double kRelativeDamping = 1e-3;

// The longer ago the last pose, the farther off is its prediction, and the more steps are needed.
constexpr double kAllIterations_s = 1.0 / 15;

using Cholesky = Eigen::LLT<Eigen::Matrix<double, kContourDof, kContourDof>>;

void addPriors(const ContourPose& pose, const std::optional<ContourPrediction>& prediction,
               const ContourOptions& options, PoseNormalEquations& equations) {
  addPosturePriors(pose, equations);
  addArmRestPrior(pose, equations);
  if (prediction)
    addMotionPrior(pose, prediction->pose, options.joint_velocity_sigma * prediction->seconds,
                   options.root_velocity_sigma * prediction->seconds, equations);
}

ContourPose nextPose(const ContourPose& pose, const PoseNormalEquations& equations) {
  auto H = equations.H;
  H.diagonal() *= 1.0 + kRelativeDamping;
  dampPose(H);
  return stepped(pose, -Cholesky(H).solve(equations.g));
}

/// Fraction of each view's rays that are nearer to the body than kRayExplained; 1 without rays.
std::vector<double> viewRaysExplained(const ContourObservation& seen, const PoseProblem& problem) {
  std::vector<double> explained(seen.views.size(), 0.0), all(seen.views.size(), 0.0);
  for (size_t i = 0; i < seen.rays.size(); ++i) {
    const size_t view = size_t(seen.rays[i].camera);
    ++all[view];
    if (std::abs(double(problem.matches()[i].residual)) < kRayExplained) ++explained[view];
  }
  for (size_t v = 0; v < all.size(); ++v) explained[v] = all[v] > 0.0 ? explained[v] / all[v] : 1.0;
  return explained;
}

void judgeViews(const ContourObservation& seen, const CameraRig& rig, const PoseProblem& problem,
                ContourFit& fit) {
  const std::vector<double> overlaps = viewOverlaps(seen, rig, problem.cones());
  const std::vector<double> explained = viewRaysExplained(seen, problem);
  double sum = 0.0;
  std::vector<double> qualities;
  for (size_t v = 0; v < seen.views.size(); ++v) {
    if (seen.views[v].status != ViewStatus::kUsable) continue;
    sum += overlaps[v];
    qualities.push_back(0.5 * (overlaps[v] + explained[v]));
  }
  fit.overlap = sum / double(qualities.size());
  fit.worst_quality = *std::min_element(qualities.begin(), qualities.end());
  fit.majority_quality = reachedByMost(std::move(qualities));
}

void check(const ContourObservation& seen, const CameraRig& rig, const ContourPose& start,
           const std::optional<ContourPrediction>& prediction) {
  if (seen.views.size() != rig.size())
    throw std::invalid_argument("contour: the observation has " +
                                std::to_string(seen.views.size()) + " views, the rig has " +
                                std::to_string(rig.size()) + " cameras");
  if (!start.isFinite() || (prediction && !prediction->pose.isFinite()))
    throw std::invalid_argument("contour: the start pose or the predicted pose is not finite");
  if (prediction && !(prediction->seconds > 0))
    throw std::invalid_argument("contour: the time of a prediction must be positive");
}

}  // namespace

ContourPose predictConstantVelocity(const ContourPose& before, const ContourPose& last,
                                    double fraction) {
  return boxPlus(last, fraction * boxMinus(last, before));
}

double qualityOf(const ContourFit& fit) {
  return 0.5 * (fit.overlap + fit.rays_explained);
}

const char* toString(ContourFitStatus status) {
  constexpr const char* kNames[] = {"fitted", "too few views", "diverged"};
  return kNames[size_t(status)];
}

ContourFitter::ContourFitter(const CameraRig& rig, const ContourOptions& options)
    : rig_(rig), options_(options) {
  options.validate();
}

RobustSchedule ContourFitter::schedule(double seconds) const {
  const int all = options_.iterations, fewest = (all + 1) / 2;
  const int iterations = int(std::lround(all * std::min(1.0, seconds / kAllIterations_s)));
  return {std::max(fewest, iterations), options_.robust_scale_initial, options_.robust_scale_final};
}

ContourFit ContourFitter::fit(const ContourObservation& seen, const ContourBody& body,
                              const ContourPose& start,
                              const std::optional<ContourPrediction>& prediction,
                              const RobustSchedule& schedule) const {
  check(seen, rig_, start, prediction);
  ContourFit fit;
  fit.pose = start;
  if (seen.usableViews() < 2) return fit;
  PoseProblem problem(seen, rig_, options_);
  PoseNormalEquations equations;
  // The last iteration only evaluates the final pose.
  for (int i = 0; i <= schedule.iterations; ++i) {
    problem.evaluate(body, fit.pose, robustScaleAt(schedule, std::min(i, schedule.iterations - 1)));
    equations.clear();
    accumulatePoseEquations(problem.sums(), problem.frames(), problem.cones(), equations);
    addPriors(fit.pose, prediction, options_, equations);
    if (i < schedule.iterations) fit.pose = nextPose(fit.pose, equations);
    if (!fit.pose.isFinite()) break;
  }
  const bool solved = fit.pose.isFinite() && Cholesky(equations.H).info() == Eigen::Success;
  fit.status = solved ? ContourFitStatus::kFitted : ContourFitStatus::kDiverged;
  if (!solved) return fit;
  gatherEvidence(seen, options_, body, problem, fit);
  judgeViews(seen, rig_, problem, fit);
  return fit;
}

}  // namespace markerless_mocap
