/// The contour body before eight views of a drawn person of 640 x 480 pixels: masks to rays, rays
/// to a pose, and thirty instants to a body's sizes. Which ray touches which cone is told twice:
/// `matchRaysPlainly` in Eigen, one cone after another, and `matchRaysInVectors`. The ratio of the
/// two in one run is the result. Arguments: threads; the others run on one.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "contour/fit/pose_problem.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {
namespace {

CameraRig ring() {
  CameraRig rig;
  for (int i = 0; i < 8; ++i) {
    CameraCalibration c;
    c.name = "cam" + std::to_string(i);
    c.width = 640;
    c.height = 480;
    c.K << 600, 0, 319.5, 0, 600, 239.5, 0, 0, 1;
    const double turn = 2 * M_PI * i / 8;
    const Eigen::Vector3d at(4 * std::cos(turn), 4 * std::sin(turn), 1.9);
    const Eigen::Vector3d z = (Eigen::Vector3d(0, 0, 0.95) - at).normalized();
    const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
    c.T_world_camera.linear() << x, z.cross(x), z;
    c.T_world_camera.translation() = at;
    rig.emplace_back(c);
  }
  return rig;
}

/// Balls along every cone, drawn as disks.
cv::Mat maskOf(const Camera& camera, const ContourWorldCones& cones) {
  cv::Mat mask = cv::Mat::zeros(camera.height(), camera.width(), CV_8UC1);
  for (const ContourWorldCone& cone : cones)
    for (int i = 0; i <= 40; ++i) {
      const double s = i / 40.0;
      const Eigen::Vector3d middle = cone.a + s * (cone.b - cone.a);
      const Eigen::Vector2d pixel = *camera.project(middle);
      const double depth =
          camera.calibration().T_world_camera.linear().col(2).dot(middle - camera.position());
      const double radius = 600 * (cone.radius_a + s * (cone.radius_b - cone.radius_a)) / depth;
      cv::circle(mask, {int(std::lround(pixel.x() * 16)), int(std::lround(pixel.y() * 16))},
                 int(std::lround(radius * 16)), 255, cv::FILLED, cv::LINE_8, 4);
    }
  return mask;
}

/// A person with one arm up, seen by all cameras.
struct Scene {
  CameraRig rig = ring();
  ContourOptions options;
  ShapeStatistics people = ShapeStatistics::handMade();
  ContourBody body{people.meanShape(1.75)};
  ContourPose pose;
  std::vector<cv::Mat> masks;
  ContourObserver observer{rig, options};
  ContourObservation seen;
  ContourWorldCones cones;

  Scene() {
    pose.position.z() = 0.95;
    pose.rotations[SphericalJoint::kLeftShoulder] = expSO3({2.0, 0, 0});
    pose.rotations[SphericalJoint::kRightShoulder] = expSO3({-0.5, 0, 0});
    pose.rotations[SphericalJoint::kLeftHip] = expSO3({0, -0.4, 0});
    pose.angles[RevoluteJoint::kRightElbow] = 1.0;
    ContourFrames frames;
    body.place(pose, frames);
    body.place(frames, cones);
    for (const Camera& camera : rig) masks.push_back(maskOf(camera, cones));
    seen = observer.observe(masks);
  }
};

const Scene& scene() {
  static const Scene scene;
  return scene;
}

void observe(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  size_t(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(scene().observer.observe(scene().masks));
}
BENCHMARK(observe)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void fit(benchmark::State& state) {
  const ContourFitter fitter(scene().rig, scene().options);
  PoseIncrement step;
  step.setConstant(0.03);
  const ContourPose start = boxPlus(scene().pose, step);
  for (auto _ : state)
    benchmark::DoNotOptimize(fitter.fit(scene().seen, scene().body, start,
                                        ContourPrediction{start, 1.0 / 30},
                                        fitter.schedule(1.0 / 30)));
}
BENCHMARK(fit)->Unit(benchmark::kMillisecond);

void estimateShapeOfThirty(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  size_t(state.range(0)));
  ShapePrior prior;
  prior.shape_statistics = scene().people;
  const std::vector<ShapeSample> instants(30, {scene().seen, scene().pose, {}});
  for (auto _ : state)
    benchmark::DoNotOptimize(estimateShape(scene().rig, scene().options, prior,
                                           prior.shape_statistics.meanShape(1.7), instants));
}
BENCHMARK(estimateShapeOfThirty)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void matchRaysInVectors(benchmark::State& state) {
  std::vector<RayMatch> matches;
  for (auto _ : state) {
    matchRays(ConesInViews(scene().seen, scene().cones), scene().seen.rays, matches);
    benchmark::DoNotOptimize(matches.data());
  }
}
BENCHMARK(matchRaysInVectors)->Unit(benchmark::kMillisecond);

/// Distance from a ray to a cone's surface by the formula of ray_match.cpp, and its penalty.
double plainScore(const ContourRay& ray, const ContourWorldCone& cone) {
  Eigen::Matrix<double, 2, 3> across;
  across << ray.normal.cast<double>().transpose(), ray.side.cast<double>().transpose();
  const Eigen::Vector2d eye(ray.normal_of_ray, ray.side_of_ray);
  const Eigen::Vector2d a = across * cone.a - eye, way = across * cone.b - eye - a;
  const double taper = cone.radius_b - cone.radius_a, length2 = way.squaredNorm() + 1e-12;
  const double beside = std::abs(a.x() * way.y() - a.y() * way.x());
  const double rest = std::sqrt(std::max(1e-12, length2 - taper * taper));
  const double s = std::clamp((beside * taper / rest - a.dot(way)) / length2, 0.0, 1.0);
  const Eigen::Vector2d c = a + s * way;
  const double distance = c.norm(), cosine = -c.x() / distance;
  const double residual = (cosine >= 0.3 ? distance : -c.x()) - cone.radius_a - s * taper;
  return std::abs(residual) + 0.06 * (1 - cosine);
}

void matchRaysPlainly(benchmark::State& state) {
  std::vector<int> nearest(scene().seen.rays.size());
  for (auto _ : state) {
    for (size_t r = 0; r < nearest.size(); ++r) {
      double least = HUGE_VAL;
      for (int c = 0; c < kContourCones; ++c) {
        const double score = plainScore(scene().seen.rays[r], scene().cones[size_t(c)]);
        if (score < least) least = score, nearest[r] = c;
      }
    }
    benchmark::DoNotOptimize(nearest.data());
  }
}
BENCHMARK(matchRaysPlainly)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace markerless_mocap
