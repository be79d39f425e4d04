#include "fleischmann/fleischmann_pose_estimator.h"

namespace markerless_mocap {
namespace {

// Maximum of f_s + f_e; the cost is the difference from it.
constexpr double kPerfect = 2.0;
constexpr int kMinViews = 2;  // depth is unknown in a single view

// Standard deviations of the error of a proposed pose; the search range decreases from round to
// round.
constexpr double kProposedTurn = 0.15, kProposedPlace = 0.05;  // rad, m; standard deviations
constexpr int kStartRounds = 8;

double secondsBetween(int64_t from_ns, int64_t to_ns) {
  return double(to_ns - from_ns) * 1e-9;
}

std::string viewError(int views) {
  if (views == 0) return "no camera shows a person";
  return views < kMinViews ? "only one camera shows a person, at least two are needed" : "";
}

}  // namespace

FleischmannPoseEstimator::FleischmannPoseEstimator(const CameraRig& rig,
                                                   const FleischmannBodyModel& body_model,
                                                   const FleischmannBodyShape& body,
                                                   const FleischmannMotionStatistics& statistics,
                                                   const FleischmannOptions& options,
                                                   const SwarmWatch& watch)
    : fitness_(rig, body_model, body, options.image),
      collision_(body, options.body),
      statistics_(statistics),
      options_(options),
      plan_(makeSearchPlan(options, watch)),
      limits_(options.body.joint_limits == "full" ? FleischmannLimits::full()
                                                  : FleischmannLimits::walking()) {}

FleischmannVector FleischmannPoseEstimator::withinLimits(const FleischmannVector& v) const {
  return v.cwiseMax(limits_.lower).cwiseMin(limits_.upper);
}

void FleischmannPoseEstimator::start(int64_t stamp_ns, const FleischmannVector& v) {
  last_ = Known{stamp_ns, withinLimits(v)};
  before_.reset();
  particles_.resize(0, 0);
}

void FleischmannPoseEstimator::reset() {
  last_.reset();
  before_.reset();
  particles_.resize(0, 0);
}

FleischmannVector FleischmannPoseEstimator::predicted(int64_t stamp_ns) const {
  if (!before_ || options_.prediction_fraction == 0.0) return last_->v;
  const double steps = secondsBetween(last_->stamp_ns, stamp_ns) /
                       secondsBetween(before_->stamp_ns, last_->stamp_ns);
  return withinLimits(last_->v + options_.prediction_fraction * steps * (last_->v - before_->v));
}

SearchProblem FleischmannPoseEstimator::problem() const {
  SearchProblem problem;
  problem.lower = limits_.lower;
  problem.upper = limits_.upper;
  problem.attempts = options_.swarm.draw_attempts;
  problem.cost = [this](int stage, const double* candidates, int count, double* costs) {
    for (int i = 0; i < count; ++i, candidates += kFleischmannParameterCount)
      costs[i] = kPerfect - fitness_.fitness(candidates, plan_.edges[size_t(stage)]).total();
  };
  problem.infeasible = [this](const double* candidate) {
    FleischmannFrames frames;
    fitness_.bodyModel().frames(candidate, frames);
    return collision_(frames);
  };
  return problem;
}

Eigen::MatrixXd FleischmannPoseEstimator::search(SearchStart start, uint64_t seed,
                                                 FleischmannEstimate& pose) const {
  start.sigma[kHeadTwist] = 0.0;  // the model's head does not show it (Fleischmann 2012, 6.1)
  const SearchOutcome found = plan_.optimiser->minimise(
      problem(), start, uint64_t(options_.seed) * 0x9e3779b97f4a7c15u + seed);
  pose.v = found.best;
  pose.evaluations += found.evaluations;
  pose.fitness = fitness_.fitness(pose.v.data(), plan_.edges.back());
  return found.particles;
}

void FleischmannPoseEstimator::accept(int64_t stamp_ns, FleischmannEstimate& pose) {
  if (pose.fitness.silhouette < options_.min_silhouette_fitness) {
    pose.reason = "no pose near the start pose agrees with the silhouettes";
    return;
  }
  pose.status = PoseStatus::kTracked;
  before_ = last_;
  last_ = Known{stamp_ns, pose.v};
}

std::string FleischmannPoseEstimator::updateError(int64_t stamp_ns, int views) const {
  if (!last_) return "there is no pose to start from";
  if (stamp_ns <= last_->stamp_ns) return "the time stamp is not later than the last one";
  if (secondsBetween(last_->stamp_ns, stamp_ns) > options_.max_pose_age)
    return "the last pose is too old to start from";
  return viewError(views);
}

FleischmannEstimate FleischmannPoseEstimator::update(int64_t stamp_ns,
                                                     const std::vector<FleischmannView>& views) {
  FleischmannEstimate pose;
  pose.views = fitness_.observe(views);
  pose.reason = updateError(stamp_ns, pose.views);
  if (!pose.reason.empty()) return pose;
  const double seconds = secondsBetween(last_->stamp_ns, stamp_ns);
  Eigen::MatrixXd found =
      search({predicted(stamp_ns), options_.sigma_factor * statistics_.over(seconds), particles_},
             uint64_t(stamp_ns), pose);
  accept(stamp_ns, pose);
  if (options_.swarm.carry_particles && pose.status == PoseStatus::kTracked)
    particles_ = std::move(found);
  return pose;
}

FleischmannEstimate FleischmannPoseEstimator::reinitializeNear(
    int64_t stamp_ns, const FleischmannVector& v, const std::vector<FleischmannView>& views,
    double better_than) {
  FleischmannEstimate best;
  best.views = fitness_.observe(views);
  best.reason = viewError(best.views);
  if (!best.reason.empty()) return best;
  best.v = withinLimits(v);
  best.fitness = fitness_.fitness(best.v.data(), plan_.edges.back());
  Eigen::VectorXd sigma = Eigen::VectorXd::Constant(kFleischmannParameterCount, kProposedTurn);
  sigma.segment<3>(kPelvisPosition).setConstant(kProposedPlace);
  for (int round = 0; round < kStartRounds; ++round, sigma *= 0.7) {
    FleischmannEstimate found = best;
    search({best.v, sigma}, uint64_t(stamp_ns) + uint64_t(round), found);
    best.evaluations = found.evaluations;
    if (found.fitness.total() > best.fitness.total()) best = found;
  }
  if (best.fitness.total() <= better_than) {
    best.reason = "the new pose is not better than the current one";
    return best;
  }
  accept(stamp_ns, best);
  if (best.status == PoseStatus::kTracked) {
    before_.reset();
    particles_.resize(0, 0);
  }
  return best;
}

}  // namespace markerless_mocap
