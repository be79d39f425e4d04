#include "studies/reproduce/fleischmann/fleischmann_studies.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "fleischmann/fleischmann_motion_statistics.h"
#include "fleischmann/fleischmann_pose_estimator.h"
#include "resources/resources.h"
#include "studies/common/cpu_time.h"

namespace markerless_mocap {
namespace {

constexpr int kSwing = kRightShoulder + 1;  // x24
constexpr double kMoves = 1e-9;             // spread of a parameter that is not held, rad or m
constexpr int kTimedFrame = 3;              // the first one is where the search begins

/// The published system for one capture.
struct System {
  explicit System(const FilmTruth& truth)
      : options(fleischmannOptions(publishedFleischmannYaml(), {}, 1)),
        body_model(*truth.body),
        body(*truth.body, body_model, options.body),
        statistics(FleischmannMotionStatistics::fromYaml(motionStatisticsYaml())) {}

  FleischmannOptions options;
  FleischmannBodyModel body_model;
  FleischmannBodyShape body;
  FleischmannMotionStatistics statistics;
};

std::vector<double> stretched(std::vector<double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = *low, range = *high > *low ? *high - *low : 1.0;
  for (double& value : values) value = (value - from) / range;
  return values;
}

Json listOf(const FleischmannVector& v) {
  return std::vector<double>(v.data(), v.data() + v.size());
}

/// Standard deviations of the swarm's parameters in each iteration, summed over searches.
class Convergence {
 public:
  void begin() { at_ = 0; }
  void add(int stage, const Eigen::MatrixXd& positions) {
    const Eigen::MatrixXd centred = positions.colwise() - positions.rowwise().mean();
    const Eigen::VectorXd spread =
        (centred.rowwise().squaredNorm() / double(positions.cols())).cwiseSqrt();
    if (at_ == sums_.size()) sums_.push_back(Eigen::VectorXd::Zero(spread.size()));
    sums_[at_++] += spread;
    if (stage == 0)
      first_stage = positions.rowwise().mean();
    else if (last_stage_ == 0 || stage != last_stage_)
      scattered = positions;
    last_stage_ = stage;
  }
  /// Of one parameter, relative to the first iteration in which it moves.
  Json relative(int parameter) const {
    Json out = Json::array();
    double first = 0.0;
    for (const Eigen::VectorXd& sum : sums_) {
      if (first == 0.0 && sum[parameter] > kMoves) first = sum[parameter];
      out.push_back(first > 0.0 ? sum[parameter] / first : NAN);
    }
    return out;
  }
  size_t iterations() const { return sums_.size(); }

  Eigen::VectorXd first_stage;  ///< mean of the swarm at the end of the first stage
  Eigen::MatrixXd scattered;    ///< first particles of the second stage

 private:
  std::vector<Eigen::VectorXd> sums_;
  size_t at_ = 0;
  int last_stage_ = 0;
};

/// Duration of `work` in seconds, the minimum of several.
double minSeconds(const std::function<void()>& work) {
  double minimum = HUGE_VAL;
  for (int i = 0; i < 5; ++i) {
    const double start = threadSeconds();
    work();
    minimum = std::min(minimum, threadSeconds() - start);
  }
  return minimum;
}

}  // namespace

Json fitnessCurves(const Capture& capture, const FilmTruth& truth, size_t frame) {
  constexpr int kSteps = 100;
  const System system(truth);
  const double reach = system.statistics.over(1.0 / 20.0)[kSwing];
  FleischmannFitness fitness(FilmReader(capture.bag, false).rig(), system.body_model, system.body,
                             system.options.image);
  fitness.observe(frameOf(capture, frame, false).views);
  std::vector<double> degrees, silhouette, edge, total;
  for (int i = 0; i <= kSteps; ++i) {
    const double offset = reach * (2.0 * i / kSteps - 1.0);
    FleischmannVector v = truth.poses.at(frame);
    v[kSwing] += offset;
    const FitnessTerms there = fitness.fitness(v.data(), EdgeSelection());
    degrees.push_back(offset * 180.0 / M_PI);
    silhouette.push_back(there.silhouette);
    edge.push_back(there.edge);
    total.push_back(there.total());
  }
  return {{"degrees", degrees},
          {"silhouette", stretched(silhouette)},
          {"edge", stretched(edge)},
          {"total", stretched(total)},
          {"frame", frame}};
}

Json swarmConvergence(const Capture& capture, const FilmTruth& truth, int frames) {
  const System system(truth);
  FilmReader film(capture.bag, false);
  Convergence seen;
  FleischmannPoseEstimator tracker(
      film.rig(), system.body_model, system.body, system.statistics, system.options,
      [&](int stage, const Eigen::MatrixXd& positions) { seen.add(stage, positions); });
  tracker.start(film.next()->stamp_ns, truth.poses.front());
  FleischmannVector before = truth.poses.front(), after = before;
  int done = 0;
  for (; done < frames; ++done) {
    const std::optional<FilmFrame> frame = film.next();
    if (!frame) break;
    seen.begin();
    before = after;
    after = tracker.update(frame->stamp_ns, frame->views).v;
  }
  Json out{{"frame", done}, {"before", listOf(before)}, {"after", listOf(after)}};
  out["first_stage"] = listOf(seen.first_stage);
  for (Eigen::Index i = 0; i < seen.scattered.cols(); ++i)
    out["scattered"].push_back(listOf(seen.scattered.col(i)));
  for (int d = 0; d < kFleischmannParameterCount; ++d)
    if (d != kHeadTwist) out["spread"][fleischmannParameterNames()[size_t(d)]] = seen.relative(d);
  out["iterations"] = seen.iterations();
  return out;
}

Json timeByPart(const Capture& capture, const FilmTruth& truth) {
  constexpr int kEvaluations = 1000;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const System system(truth);
  const FilmFrame frame = frameOf(capture, kTimedFrame, false);
  const double* pose = truth.poses[kTimedFrame].data();
  const CameraRig rig = FilmReader(capture.bag, false).rig();
  FleischmannFitness fitness(rig, system.body_model, system.body, system.options.image);
  const double observing = minSeconds([&] { fitness.observe(frame.views); });
  FleischmannFrames frames;
  const double kinematics = minSeconds([&] {
    for (int i = 0; i < kEvaluations; ++i) system.body_model.frames(pose, frames);
  });
  const auto evaluate = [&](ConeSet cones) {
    return minSeconds([&] {
      for (int i = 0; i < kEvaluations; ++i) fitness.fitness(pose, {cones, true});
    });
  };
  const double without = evaluate(0), with = evaluate(kAllButHead);
  const double whole = minSeconds([&] {
    FleischmannPoseEstimator tracker(rig, system.body_model, system.body, system.statistics,
                                     system.options);
    tracker.start(truth.joints.stamps_ns.front(), truth.poses.front());
    tracker.update(frame.stamp_ns, frame.views);
  });
  return {{"observing", observing},
          {"kinematics", kinematics},
          {"drawing_and_silhouette", std::max(0.0, without - kinematics)},
          {"edges", std::max(0.0, with - without)},
          {"rest", std::max(0.0, whole - observing - with)}};
}

}  // namespace markerless_mocap
