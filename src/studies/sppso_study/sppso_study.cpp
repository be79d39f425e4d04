#include "studies/sppso_study/sppso_study.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double medianOf(std::vector<double> values) {
  return summaryStatistics(values).median;
}

Eigen::Matrix3Xd markersOf(const FleischmannBodyModel& body_model, const FleischmannVector& v) {
  FleischmannFrames frames;
  body_model.frames(v.data(), frames);
  const std::vector<Eigen::Vector3d> positions = body_model.markers(frames);
  Eigen::Matrix3Xd markers(3, Eigen::Index(positions.size()));
  for (Eigen::Index m = 0; m < markers.cols(); ++m) markers.col(m) = positions[size_t(m)];
  return markers;
}

size_t stepOf(const FleischmannSequence& film, double fps) {
  const double step = film.fps / fps;
  if (!(step >= 1.0 && std::abs(step - std::round(step)) < 1e-9))
    throw std::invalid_argument("a sequence of " + std::to_string(film.fps) +
                                " frames per second cannot be downsampled to " +
                                std::to_string(fps));
  return size_t(std::lround(step));
}

StudyRun runOnce(const FleischmannSequence& film, const FleischmannMotionStatistics& statistics,
                 const FleischmannOptions& options, size_t step) {
  const FleischmannBodyModel body_model(*film.body);
  FleischmannPoseEstimator tracker(
      film.rig, body_model, FleischmannBodyShape(*film.body, body_model), statistics, options);
  tracker.start(film.frames.front().stamp_ns, film.frames.front().truth);
  StudyRun run;
  JointTrack truth, found;
  truth.names = found.names = film.joints.names;
  FleischmannVector last = film.frames.front().truth;
  double seconds = 0.0;
  for (size_t f = step; f < film.frames.size(); f += step) {
    const std::vector<FleischmannView> views = wholeViews(film, f);
    const auto start = Clock::now();
    const FleischmannEstimate pose = tracker.update(film.frames[f].stamp_ns, views);
    seconds += secondsSince(start);
    // In a lost frame, the last pose is evaluated.
    if (pose.status == PoseStatus::kTracked)
      last = pose.v;
    else
      ++run.lost;
    truth.add(film.frames[f].stamp_ns, film.joints.positions[f]);
    found.add(film.frames[f].stamp_ns, markersOf(body_model, last));
  }
  run.errors = jointErrors(truth, found);
  run.seconds_per_frame = seconds / double(std::max<size_t>(1, truth.frames()));
  return run;
}

/// Duration of `work` in seconds, the minimum of several runs.
double minSeconds(const std::function<void()>& work) {
  double minimum = HUGE_VAL;
  for (int i = 0; i < 7; ++i) {
    const auto start = Clock::now();
    work();
    minimum = std::min(minimum, secondsSince(start));
  }
  return minimum;
}

void stretch(std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = *low, range = *high > *low ? *high - *low : 1.0;
  for (double& value : values) value = (value - from) / range;
}

}  // namespace

double StudyResult::meanError() const {
  double sum = 0.0;
  for (const StudyRun& run : runs) sum += run.errors.D_spread.mean;
  return sum / double(runs.size());
}

double StudyResult::maxError() const {
  double most = 0.0;
  for (const StudyRun& run : runs) most = std::max(most, run.errors.D_spread.max);
  return most;
}

double StudyResult::medianMean() const {
  std::vector<double> values;
  for (const StudyRun& run : runs) values.push_back(run.errors.D_spread.mean);
  return medianOf(values);
}

double StudyResult::medianMaxError() const {
  std::vector<double> values;
  for (const StudyRun& run : runs) values.push_back(run.errors.D_spread.max);
  return medianOf(values);
}

std::vector<double> StudyResult::meanOverRuns() const {
  std::vector<double> mean(seconds.size(), 0.0);
  for (const StudyRun& run : runs)
    for (size_t f = 0; f < mean.size(); ++f) mean[f] += run.errors.D[f] / double(runs.size());
  return mean;
}

StudyResult runVariant(const FleischmannSequence& film,
                       const FleischmannMotionStatistics& statistics, const StudyVariant& variant) {
  const size_t step = stepOf(film, variant.fps);
  StudyResult result;
  for (size_t f = step; f < film.frames.size(); f += step)
    result.seconds.push_back(1e-9 * double(film.frames[f].stamp_ns - film.frames.front().stamp_ns));
  for (int seed = 1; seed <= variant.runs; ++seed) {
    FleischmannOptions options = variant.options;
    options.seed = seed;
    result.runs.push_back(runOnce(film, statistics, options, step));
  }
  return result;
}

FitnessCurves fitnessCurves(const FleischmannSequence& film, size_t frame, int parameter,
                            double reach, const FleischmannOptions& options) {
  constexpr int kSteps = 100;
  const FleischmannBodyModel body_model(*film.body);
  FleischmannFitness fitness(film.rig, body_model, FleischmannBodyShape(*film.body, body_model),
                             options.image);
  fitness.observe(wholeViews(film, frame));
  FitnessCurves curves;
  for (int i = 0; i <= kSteps; ++i) {
    const double offset = reach * (2.0 * i / kSteps - 1.0);
    FleischmannVector v = film.frames[frame].truth;
    v[parameter] += offset;
    const FitnessTerms there = fitness.fitness(v.data(), EdgeSelection());
    curves.offsets.push_back(offset);
    curves.silhouette.push_back(there.silhouette);
    curves.edge.push_back(there.edge);
    curves.total.push_back(there.total());
  }
  for (auto* values : {&curves.silhouette, &curves.edge, &curves.total}) stretch(*values);
  return curves;
}

TimeByPart timeByPart(const FleischmannSequence& film,
                      const FleischmannMotionStatistics& statistics,
                      const FleischmannOptions& options) {
  constexpr int kEvaluations = 1000;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const FleischmannBodyModel body_model(*film.body);
  const FleischmannBodyShape body(*film.body, body_model);
  const size_t frame = std::min<size_t>(3, film.frames.size() - 1);
  const std::vector<FleischmannView> views = wholeViews(film, frame);
  const FleischmannVector& truth = film.frames[frame].truth;
  FleischmannFitness fitness(film.rig, body_model, body, options.image);
  const auto evaluate = [&](ConeSet cones) {
    return minSeconds([&] {
      for (int i = 0; i < kEvaluations; ++i) fitness.fitness(truth.data(), {cones, true});
    });
  };
  TimeByPart time{};
  time.observing = minSeconds([&] { fitness.observe(views); });
  FleischmannFrames frames;
  time.kinematics = minSeconds([&] {
    for (int i = 0; i < kEvaluations; ++i) body_model.frames(truth.data(), frames);
  });
  const double without = evaluate(0), with = evaluate(kAllButHead);
  time.drawing_and_silhouette = std::max(0.0, without - time.kinematics);
  time.edges = std::max(0.0, with - without);
  const double whole = minSeconds([&] {
    FleischmannPoseEstimator tracker(film.rig, body_model, body, statistics, options);
    tracker.start(film.frames.front().stamp_ns, film.frames.front().truth);
    tracker.update(film.frames[frame].stamp_ns, views);
  });
  time.rest = std::max(0.0, whole - time.observing - with);
  return time;
}

}  // namespace markerless_mocap
