/// Carving against the loops that one would write first: over all voxels and cameras, and stopping
/// at the first camera that misses, each with a projection by Eigen and with a table of pixels that
/// was made beforehand. All is told in one run, over the same masks: the ratio to packAndVote is
/// the result. `voxels` must be those of the table; Eigen's single matrix may round one of them to
/// the next pixel. Arguments: voxels along an edge of 2 m, threads.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "hull/voting/vote_rule.h"
#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {
namespace {

/// Eight cameras of 640 x 480 in a ring that look at a standing figure of boxes and balls.
struct Scene {
  CameraRig rig;
  std::vector<HullView> views;
  HullOptions options;
  tbb::global_control threads;

  explicit Scene(const benchmark::State& state)
      : threads(tbb::global_control::max_allowed_parallelism, size_t(state.range(1))) {
    options.volume = "explicit";
    options.volume_min = {-1, -1, 0};
    options.volume_max = {1, 1, 2};
    options.pitch = 2.0 / double(state.range(0));
    for (int i = 0; i < 8; ++i) {
      rig.emplace_back(calibration(i));
      HullView view;
      view.mask = drawMask(rig.back());
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

/// From masks to the set of voxels, as the loops below.
void packAndVote(benchmark::State& state) {
  const Scene scene(state);
  const VoxelLattice lattice = scene.options.lattice();
  const ProjectionTable table(scene.rig, lattice);
  std::vector<TileMask> masks(scene.rig.size());
  VoteRule rule;
  for (const TileMask& mask : masks) rule.masks.push_back(&mask);
  rule.weights.assign(masks.size(), 1);
  rule.window.high = lattice.size;
  BrickVolume volume(lattice);
  for (auto _ : state) {
    tbb::parallel_for(size_t(0), masks.size(),
                      [&](size_t c) { masks[c].pack(scene.views[c].mask); });
    vote(table, rule, &volume);
  }
  size_t voxels = 0;
  volume.forEachBrick([&](int, int, int, size_t brick) {
    voxels += size_t(__builtin_popcountll(volume.word(brick)));
  });
  state.counters["voxels"] = double(voxels);
  state.counters["plan_MB"] = double(table.bytes()) / 1e6;
}

/// The whole stage: components, the person, views of each voxel.
void carve(benchmark::State& state) {
  const Scene scene(state);
  HullCarver carver(scene.rig, scene.options);
  size_t voxels = 0;
  for (auto _ : state) voxels = carver.carve(scene.views).voxels.size();
  state.counters["voxels"] = double(voxels);
}

void carveWithColors(benchmark::State& state) {
  Scene scene(state);
  for (HullView& view : scene.views)
    view.image = cv::Mat(480, 640, CV_8UC3, cv::Scalar(40, 90, 140));
  HullCarver carver(scene.rig, scene.options);
  size_t voxels = 0;
  for (auto _ : state) voxels = carver.carve(scene.views).voxels.size();
  state.counters["voxels"] = double(voxels);
}

/// One camera's mask is empty, is found and left out.
void carveWithADeadCamera(benchmark::State& state) {
  Scene scene(state);
  scene.views[3].mask.setTo(0);
  HullCarver carver(scene.rig, scene.options);
  size_t voxels = 0;
  for (auto _ : state) voxels = carver.carve(scene.views).voxels.size();
  state.counters["voxels"] = double(voxels);
}

/// [camera][voxel] pixel offset, or -1 where the camera does not see the voxel.
std::vector<std::vector<int32_t>> pixelTable(const Scene& scene, const VoxelLattice& lattice) {
  std::vector<std::vector<int32_t>> table(scene.rig.size());
  for (size_t c = 0; c < scene.rig.size(); ++c)
    for (uint32_t v = 0; v < lattice.count(); ++v) {
      const auto pixel = scene.rig[c].projectInside(lattice.center(v));
      table[c].push_back(pixel ? int(std::lround(pixel->y())) * 640 + int(std::lround(pixel->x()))
                               : -1);
    }
  return table;
}

template <bool kStop>
void tableLoop(benchmark::State& state) {
  const Scene scene(state);
  const VoxelLattice lattice = scene.options.lattice();
  const auto table = pixelTable(scene, lattice);
  size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for (uint32_t v = 0; v < lattice.count(); ++v) {
      int seen = 0, votes = 0;
      for (size_t c = 0; c < table.size(); ++c) {
        if (table[c][v] < 0) continue;
        ++seen;
        votes += scene.views[c].mask.data[table[c][v]] > 0;
        if (kStop && votes < seen) break;
      }
      found += seen >= scene.options.min_views && votes == seen;
    }
    benchmark::DoNotOptimize(found);
  }
  state.counters["voxels"] = double(found);
}

template <bool kStop>
void eigenLoop(benchmark::State& state) {
  const Scene scene(state);
  const VoxelLattice lattice = scene.options.lattice();
  std::vector<Eigen::Matrix<double, 3, 4>> projections;
  for (const Camera& camera : scene.rig)
    projections.push_back(camera.calibration().K *
                          camera.calibration().T_world_camera.inverse().matrix().topRows<3>());
  size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for (uint32_t v = 0; v < lattice.count(); ++v) {
      const Eigen::Vector4d center = lattice.center(v).homogeneous();
      int seen = 0, votes = 0;
      for (size_t c = 0; c < projections.size(); ++c) {
        const Eigen::Vector3d p = projections[c] * center;
        if (p.z() <= 0) continue;
        const int x = int(std::floor(p.x() / p.z() + 0.5)),
                  y = int(std::floor(p.y() / p.z() + 0.5));
        if (x < 0 || x >= 640 || y < 0 || y >= 480) continue;
        ++seen;
        votes += scene.views[c].mask.data[y * 640 + x] > 0;
        if (kStop && votes < seen) break;
      }
      found += seen >= scene.options.min_views && votes == seen;
    }
    benchmark::DoNotOptimize(found);
  }
  state.counters["voxels"] = double(found);
}

constexpr bool kAllCameras = false, kStopAtFirstMiss = true;

void arguments(benchmark::internal::Benchmark* benchmark) {
  for (const int edge : {64, 128, 256})
    for (const int threads : {1, 2}) benchmark->Args({edge, threads});
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(packAndVote)->Apply(arguments);
BENCHMARK(carve)->Apply(arguments);
BENCHMARK(carveWithColors)->Apply(arguments);
BENCHMARK(carveWithADeadCamera)->Args({128, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
void reference(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({128, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(eigenLoop<kAllCameras>)->Apply(reference);
BENCHMARK(eigenLoop<kStopAtFirstMiss>)->Apply(reference);
BENCHMARK(tableLoop<kAllCameras>)->Apply(reference);
BENCHMARK(tableLoop<kStopAtFirstMiss>)->Apply(reference);

}  // namespace
}  // namespace markerless_mocap
