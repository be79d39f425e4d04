/// A thousand fitness evaluations of the body in four views of 644 x 484, from 31 parameters to
/// f_s + f_e, against the same with OpenCV's fillConvexPoly and countNonZero, in one run over the
/// same candidates. OpenCV rounds corners to pixels and paints the border, so its f_s is near ours,
/// not equal: `mean_fitness` shows it. Arguments: reduction of the images, threads.

#include <benchmark/benchmark.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <numeric>
#include <opencv2/imgproc.hpp>
#include <random>

#include "fleischmann/appearance_scene.h"
#include "fleischmann/fitness/edge_samples.h"
#include "fleischmann/fitness/fleischmann_cone_outlines.h"
#include "fleischmann/fleischmann_fitness.h"

namespace markerless_mocap {
namespace {

constexpr int kCandidates = 1000;

FleischmannImageOptions optionsOf(int downsampling) {
  FleischmannImageOptions options;
  options.downsampling = downsampling;
  return options;
}

/// A person in mid-step, seen by four cameras, and candidates about the pose.
struct Scene {
  CameraRig rig = ringOfFour({-0.08, 0.01, 0.0, 0.0, 0.0});
  FleischmannBodyModel profile{sampleBody()};
  FleischmannBodyShape body{sampleBody(), profile};
  int downsampling;
  FleischmannFitness fitness;
  std::vector<FleischmannView> views;
  std::vector<FleischmannVector> candidates;
  tbb::global_control threads;

  explicit Scene(const benchmark::State& state)
      : downsampling(int(state.range(0))),
        fitness(rig, profile, body, optionsOf(downsampling)),
        threads(tbb::global_control::max_allowed_parallelism, size_t(state.range(1))) {
    const FleischmannVector pose = stride();
    FleischmannFitness painter(rig, profile, body, FleischmannImageOptions());
    for (int i = 0; i < 4; ++i) {
      const cv::Mat mask = painter.drawing(pose.data(), i);
      cv::Mat image(mask.size(), CV_8UC1, cv::Scalar(150));
      image.setTo(60, mask);
      views.push_back({mask, image});
    }
    fitness.observe(views);
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int i = 0; i < kCandidates; ++i) {
      candidates.push_back(pose);
      for (int d = 0; d < kFleischmannParameterCount; ++d)
        candidates.back()[d] += (d >= 3 && d < 6 ? 0.04 : 0.15) * normal(random);
    }
  }
};

void observe(benchmark::State& state) {
  Scene scene(state);
  for (auto _ : state) benchmark::DoNotOptimize(scene.fitness.observe(scene.views));
}

void evaluate(benchmark::State& state) {
  const Scene scene(state);
  std::vector<double> totals(kCandidates);
  for (auto _ : state)
    tbb::parallel_for(tbb::blocked_range<int>(0, kCandidates, 10), [&](const auto& range) {
      for (int i = range.begin(); i < range.end(); ++i)
        totals[i] = scene.fitness.fitness(scene.candidates[i].data(), EdgeSelection()).total();
    });
  state.counters["mean_fitness"] = std::accumulate(totals.begin(), totals.end(), 0.0) / kCandidates;
}

/// The same cones and corners; what differs is drawing and counting.
double fitnessWithOpenCv(const Scene& scene, const std::vector<ViewCamera>& cameras,
                         const std::vector<cv::Mat>& silhouettes, const ConePlacer& placer,
                         const FleischmannVector& candidate) {
  FleischmannFrames frames;
  FleischmannWorldCones cones;
  scene.profile.frames(candidate.data(), frames);
  placer.place(frames, cones);
  double total = 0.0;
  for (size_t view = 0; view < cameras.size(); ++view) {
    ConeCorners corners;
    cameras[view].outlines(cones, corners);
    cv::Mat drawn = cv::Mat::zeros(silhouettes[view].size(), CV_8UC1);
    for (int cone = 0; cone < kFleischmannConeCount; ++cone) {
      cv::Point points[4];
      for (int k = 0; k < 4; ++k)
        points[k] = {cvRound(corners.x[k][cone]), cvRound(corners.y[k][cone])};
      cv::fillConvexPoly(drawn, points, 4, cv::Scalar(255));
    }
    const double count = cv::countNonZero(drawn), area = cv::countNonZero(silhouettes[view]);
    cv::bitwise_and(drawn, silhouettes[view], drawn);
    const double shared = cv::countNonZero(drawn);
    total += 0.5 * shared / count + 0.5 * shared / area;
    const EdgeSum edge = sampleEdges(corners, scene.fitness.edges(int(view)), EdgeSelection(), 10);
    total += double(edge.sum) / (255.0 * edge.points);
  }
  return total / double(cameras.size());
}

void evaluateWithOpenCv(benchmark::State& state) {
  const Scene scene(state);
  const ConePlacer placer(scene.body);
  std::vector<ViewCamera> cameras;
  std::vector<cv::Mat> silhouettes;
  for (size_t i = 0; i < scene.rig.size(); ++i) {
    cameras.emplace_back(scene.rig[i], scene.downsampling);
    cv::Mat small;
    cv::resize(scene.views[i].silhouette, small, cv::Size(cameras[i].width(), cameras[i].height()),
               0, 0, cv::INTER_AREA);
    silhouettes.push_back(small >= 127);
  }
  cv::setNumThreads(1);
  double sum = 0.0;
  for (auto _ : state) {
    sum = 0.0;
    for (const FleischmannVector& candidate : scene.candidates)
      sum += fitnessWithOpenCv(scene, cameras, silhouettes, placer, candidate);
  }
  state.counters["mean_fitness"] = sum / kCandidates;
}

void arguments(benchmark::internal::Benchmark* benchmark) {
  for (const int downsampling : {1, 2})
    for (const int threads : {1, 2}) benchmark->Args({downsampling, threads});
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
}

void oneThread(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({1, 1})->Args({2, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(observe)->Apply(arguments);
BENCHMARK(evaluate)->Apply(arguments);
BENCHMARK(evaluateWithOpenCv)->Apply(oneThread);

}  // namespace
}  // namespace markerless_mocap
