/// Carving against the straightforward loop over all voxels and all cameras, which reads the same
/// kind of table but asks every camera. Both are told in one run: the ratio is the result.

#include <benchmark/benchmark.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {
namespace {

/// Eight cameras of 640 x 480 in a ring that look at a standing figure of boxes and balls.
struct Scene {
  CameraRig rig;
  std::vector<HullView> views;
  HullOptions options;

  explicit Scene(double pitch) {
    options.pitch = pitch;
    for (int i = 0; i < 8; ++i) {
      rig.emplace_back(calibration(i));
      HullView view;
      view.mask = drawMask(rig.back());
      view.image = cv::Mat(480, 640, CV_8UC3, cv::Scalar(40, 90, 140));
      views.push_back(view);
    }
  }

  static CameraCalibration calibration(int i) {
    const double angle = i * std::acos(-1.0) / 4;
    CameraCalibration c;
    c.name = "cam" + std::to_string(i);
    c.width = 640;
    c.height = 480;
    c.K << 480, 0, 319.5, 0, 480, 239.5, 0, 0, 1;
    c.D = {-0.1, 0.02, 0, 0, 0};
    const Eigen::Vector3d x(std::sin(angle), -std::cos(angle), 0);
    const Eigen::Vector3d z(-std::cos(angle), -std::sin(angle), 0);
    c.T_world_camera.linear() << x, z.cross(x), z;
    c.T_world_camera.translation() << 3.5 * std::cos(angle), 3.5 * std::sin(angle), 1.1;
    return c;
  }

  /// The limbs are thick lines between projected points.
  static cv::Mat drawMask(const Camera& camera) {
    struct Limb {
      Eigen::Vector3d from, to;
      double thickness;
    };
    const Limb limbs[] = {
        {{0, 0, 0.9}, {0, 0, 1.45}, 0.3},    {{0, 0, 1.6}, {0, 0, 1.68}, 0.2},
        {{0, 0.1, 0}, {0, 0.1, 0.9}, 0.14},  {{0, -0.1, 0}, {0, -0.1, 0.9}, 0.14},
        {{0, 0.2, 1.4}, {0, 0.8, 1.4}, 0.1}, {{0, -0.2, 1.4}, {0, -0.8, 1.4}, 0.1}};
    cv::Mat mask = cv::Mat::zeros(480, 640, CV_8UC1);
    for (const Limb& limb : limbs) {
      const auto a = camera.project(limb.from), b = camera.project(limb.to);
      if (!a || !b) throw std::logic_error("the figure must be before every camera");
      cv::line(mask, {int(a->x()), int(a->y())}, {int(b->x()), int(b->y())}, cv::Scalar(255),
               int(limb.thickness * 480 / 3.5));
    }
    return mask;
  }
};

void carve(benchmark::State& state) {
  const Scene scene(double(state.range(0)) / 1000);
  const HullCarver carver(scene.rig, scene.options);
  double litres = 0;
  for (auto _ : state) litres = carver.carve(scene.views).litres();
  state.counters["litres"] = litres;
}

void allVoxelsAllCameras(benchmark::State& state) {
  const Scene scene(double(state.range(0)) / 1000);
  const VoxelLattice lattice = scene.options.lattice();
  std::vector<std::vector<int32_t>> table(scene.rig.size());
  for (size_t c = 0; c < scene.rig.size(); ++c)
    for (uint32_t v = 0; v < lattice.count(); ++v) {
      const auto pixel = scene.rig[c].projectInside(lattice.center(v));
      table[c].push_back(pixel ? int(std::lround(pixel->y())) * 640 + int(std::lround(pixel->x()))
                               : -1);
    }
  size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for (uint32_t v = 0; v < lattice.count(); ++v) {
      int seen = 0, votes = 0;
      for (size_t c = 0; c < table.size(); ++c) {
        if (table[c][v] < 0) continue;
        ++seen;
        votes += scene.views[c].mask.data[table[c][v]] > 0;
      }
      found += seen >= scene.options.min_views && votes == seen;
    }
    benchmark::DoNotOptimize(found);
  }
  state.counters["litres"] = double(found) * std::pow(lattice.pitch * 10, 3);
}

// Argument: pitch in millimetres.
BENCHMARK(carve)->Arg(30)->Arg(20)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(allVoxelsAllCameras)->Arg(30)->Arg(20)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace markerless_mocap
