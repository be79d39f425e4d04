#include "markerless_mocap/contour/contour_fitter.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contour/body_overlap.h"
#include "contour/pose_priors.h"
#include "contour/pose_problem.h"

namespace markerless_mocap {
namespace {

// Levenberg-Marquardt damping in the units of the Hessian's diagonal: 1/rad^2 and 1/m^2, and a
// share of the diagonal itself.
constexpr double kTurnDamping = 3.0, kMoveDamping = 100.0, kShareDamping = 1e-3;

constexpr double kLongestStep = 0.35;  // rad or metres

// The errors of a body's shape are alike all along a contour, which no ray knows of the next: what
// the normal equations promise is too good by about this factor.
constexpr double kAlike = 2.0;

using Cholesky = Eigen::LLT<Eigen::Matrix<double, kContourDof, kContourDof>>;

void addPriors(const ContourPose& pose, const std::optional<ContourPrediction>& prediction,
               const ContourOptions& options, PoseEquations& equations) {
  addPosturePriors(pose, equations);
  addArmsAtRest(pose, equations);
  if (prediction)
    addPrediction(pose, prediction->pose, options.turn_rate * prediction->seconds,
                  options.move_rate * prediction->seconds, equations);
}

ContourPose stepped(const ContourPose& pose, const PoseEquations& equations) {
  auto H = equations.H;
  H.diagonal() *= 1.0 + kShareDamping;
  H.diagonal().head<3>().array() += kMoveDamping;
  H.diagonal().tail<kContourDof - 3>().array() += kTurnDamping;
  const PoseStep step = -Cholesky(H).solve(equations.g);
  return moved(pose, step.cwiseMax(-kLongestStep).cwiseMin(kLongestStep));
}

/// Standard deviation of where a limb's end is, metres.
double endDeviation(const ContourBody& body, const PoseProblem& problem, const Cholesky& inverse,
                    int limb) {
  // By ContourLimb: neck's base, head, wrists, ankles among contourPointNames().
  constexpr int kEnds[ContourLimb::kCount] = {1, 2, 5, 8, 11, 14};
  const RiddenPoint& end = contourTree().points[size_t(kEnds[limb])];
  const ContourFrames& frames = problem.frames();
  Eigen::Matrix<double, 3, kContourDof> J;
  poseJacobian(frames, end.segment,
               frames.t[end.segment] + frames.R[end.segment] * end.local.at(body.sizes()), J);
  return kAlike * std::sqrt((J * inverse.solve(J.transpose())).trace());
}

void gatherEvidence(const ContourBody& body, const PoseProblem& problem, const Cholesky& inverse,
                    ContourFit& fit) {
  std::array<int, ContourLimb::kCount> balls{};
  size_t explained = 0;
  for (const RayMatch& match : problem.matches()) {
    const double distance = std::abs(double(match.residual));
    if (!(distance < kRayExplained)) continue;
    LimbEvidence& limb = fit.limbs[limbOfCone(match.cone)];
    ++explained;
    ++limb.rays;
    limb.distance += distance * distance;
  }
  for (int c = 0; c < kContourCones; ++c)
    for (const double excess : problem.excess()[size_t(c)]) {
      ++balls[limbOfCone(c)];
      fit.limbs[limbOfCone(c)].outside += excess;
    }
  for (size_t i = 0; i < ContourLimb::kCount; ++i) {
    LimbEvidence& limb = fit.limbs[i];
    limb.distance = std::sqrt(limb.distance / std::max(1, limb.rays));
    limb.outside /= balls[i];
    limb.deviation = endDeviation(body, problem, inverse, int(i));
  }
  fit.rays_explained = double(explained) / double(std::max<size_t>(1, problem.matches().size()));
}

void check(const ContourObservation& seen, const CameraRig& rig, const ContourPose& start,
           const std::optional<ContourPrediction>& prediction) {
  if (seen.views.size() != rig.size())
    throw std::invalid_argument("contour: an observation of " + std::to_string(seen.views.size()) +
                                " views was given to a rig of " + std::to_string(rig.size()));
  if (!start.isFinite() || (prediction && !prediction->pose.isFinite()))
    throw std::invalid_argument("contour: the pose to start from or to expect is not finite");
  if (prediction && !(prediction->seconds > 0))
    throw std::invalid_argument("contour: a prediction must be of a later instant");
}

}  // namespace

ContourPose goneOn(const ContourPose& before, const ContourPose& last, double share) {
  return moved(last, share * stepBetween(before, last));
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

FitSchedule ContourFitter::schedule() const {
  return {options_.iterations, options_.outlier_first, options_.outlier_last};
}

ContourFit ContourFitter::fit(const ContourObservation& seen, const ContourBody& body,
                              const ContourPose& start,
                              const std::optional<ContourPrediction>& prediction,
                              const FitSchedule& schedule) const {
  check(seen, rig_, start, prediction);
  ContourFit fit;
  fit.pose = start;
  if (seen.usableViews() < 2) return fit;
  PoseProblem problem(seen, rig_, options_);
  PoseEquations equations;
  // One evaluation more than steps: the last one is of the pose that is handed out.
  for (int i = 0; i <= schedule.iterations; ++i) {
    problem.evaluate(body, fit.pose, outlierAt(schedule, std::min(i, schedule.iterations - 1)));
    equations.clear();
    addToPose(problem.sums(), problem.frames(), problem.cones(), equations);
    addPriors(fit.pose, prediction, options_, equations);
    if (i < schedule.iterations) fit.pose = stepped(fit.pose, equations);
    if (!fit.pose.isFinite()) break;
  }
  const Cholesky inverse(equations.H);
  const bool solved = fit.pose.isFinite() && inverse.info() == Eigen::Success;
  fit.status = solved ? ContourFitStatus::kFitted : ContourFitStatus::kDiverged;
  if (!solved) return fit;
  gatherEvidence(body, problem, inverse, fit);
  fit.overlap = bodyOverlap(seen, rig_, problem.cones());
  return fit;
}

}  // namespace markerless_mocap
