#include "markerless_mocap/fitting/sppso_tracker.h"

namespace markerless_mocap {
namespace {

// Best f_s + f_e; costs are what is missing from it.
constexpr double kPerfect = 2.0;
// Beyond this, motion statistics say nothing about where a person can be.
constexpr double kLongestStep = 0.5;  // seconds

double secondsBetween(int64_t from_ns, int64_t to_ns) {
  return double(to_ns - from_ns) * 1e-9;
}

}  // namespace

SppsoTracker::SppsoTracker(const CameraRig& rig, const FleischmannProfile& profile,
                           const ConeBody& body, const MotionStatistics& statistics,
                           const SppsoOptions& options)
    : fitness_(rig, profile, body, options.appearance),
      collision_(body, options.collision),
      statistics_(statistics),
      options_(options),
      plan_(planOf(options)) {}

void SppsoTracker::start(int64_t stamp_ns, const FleischmannVector& v) {
  last_ = Known{stamp_ns, v.cwiseMax(limits_.lower).cwiseMin(limits_.upper)};
  before_.reset();
}

FleischmannVector SppsoTracker::predicted(int64_t stamp_ns) const {
  if (!before_ || options_.prediction == 0.0) return last_->v;
  const double steps = secondsBetween(last_->stamp_ns, stamp_ns) /
                       secondsBetween(before_->stamp_ns, last_->stamp_ns);
  const FleischmannVector v = last_->v + options_.prediction * steps * (last_->v - before_->v);
  return v.cwiseMax(limits_.lower).cwiseMin(limits_.upper);
}

SearchProblem SppsoTracker::problem() const {
  SearchProblem problem;
  problem.lower = limits_.lower;
  problem.upper = limits_.upper;
  problem.cost = [this](int stage, const double* candidates, int count, double* costs) {
    for (int i = 0; i < count; ++i)
      costs[i] =
          kPerfect -
          fitness_.fitness(candidates + i * kFleischmannParameters, plan_.edges[size_t(stage)])
              .total();
  };
  problem.forbidden = [this](const double* candidate) {
    FleischmannFrames frames;
    fitness_.profile().frames(candidate, frames);
    return collision_(frames);
  };
  return problem;
}

void SppsoTracker::search(int64_t stamp_ns, SppsoPose& pose) const {
  const double seconds = secondsBetween(last_->stamp_ns, stamp_ns);
  const SearchStart start = {predicted(stamp_ns),
                             options_.sigma_factor * statistics_.over(seconds)};
  const uint64_t seed = uint64_t(options_.seed) * 0x9e3779b97f4a7c15u + uint64_t(stamp_ns);
  const SearchOutcome found = plan_.optimiser->minimise(problem(), start, seed);
  pose.v = found.best;
  pose.evaluations = found.evaluations;
  pose.fitness = fitness_.fitness(pose.v.data(), plan_.edges.back());
  if (found.found && pose.fitness.silhouette >= options_.least_fitness)
    pose.status = PoseStatus::kTracked;
  else
    pose.reason = "no pose near the last one looks like the silhouettes";
}

SppsoPose SppsoTracker::update(int64_t stamp_ns, const std::vector<AppearanceView>& views) {
  SppsoPose pose;
  pose.views = fitness_.observe(views);
  if (!last_) {
    pose.reason = "no pose is known to start from";
  } else if (stamp_ns <= last_->stamp_ns) {
    pose.reason = "the instant is not after the last one";
  } else if (secondsBetween(last_->stamp_ns, stamp_ns) > kLongestStep) {
    pose.reason = "the last pose is too old to start from";
  } else if (pose.views == 0) {
    pose.reason = "no camera shows a person";
  } else {
    search(stamp_ns, pose);
  }
  if (pose.status != PoseStatus::kTracked) return pose;
  before_ = last_;
  last_ = Known{stamp_ns, pose.v};
  return pose;
}

}  // namespace markerless_mocap
