/// Thinning of a person's visual hull from eight cameras, in a cube of 2 m, to its curve skeleton.
/// Argument: voxels along an edge of the cube. `skeleton_against_skimage.py` compares it with
/// scikit-image; for that, --write_hulls=<folder> writes the hulls as hull_<argument>.vox: size
/// along x, y, z and the number of voxels as int32, then the linear indices as uint32.

#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <map>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/skeleton/pose_tree_options.h"
#include "skeleton/thinner.h"
#include "skeleton/thinning/bit_volume_components.h"
#include "skeleton/thinning/bit_volume_window.h"
#include "skeleton/thinning/cavity_filling.h"
#include "skeleton/thinning/thinning_scheme.h"

namespace markerless_mocap {
namespace {

/// Of the product at both resolutions: 0.02 m are about one voxel.
constexpr int kPeelingRounds = 1;

Camera cameraAt(double angle, double height) {
  CameraCalibration c;
  c.name = "cam" + std::to_string(int(angle * 100));
  c.width = 800;
  c.height = 600;
  c.K << 700, 0, 399.5, 0, 700, 299.5, 0, 0, 1;
  const Eigen::Vector3d position(3 * std::cos(angle), 3 * std::sin(angle), height);
  const Eigen::Vector3d z = (Eigen::Vector3d(0, 0, 1) - position).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  c.T_world_camera.linear() << x, z.cross(x), z;
  c.T_world_camera.translation() = position;
  return Camera(c);
}

/// A walking person's limbs as chains of discs.
cv::Mat drawMask(const Camera& camera) {
  struct Limb {
    Eigen::Vector3d from, to;
    double from_radius, to_radius;
  };
  static const Limb kLimbs[] = {{{0, 0, 1.66}, {0, 0, 1.60}, 0.10, 0.09},
                                {{0, 0, 1.55}, {0, 0, 1.45}, 0.06, 0.06},
                                {{0, 0.06, 1.36}, {0, 0.05, 1.0}, 0.12, 0.12},
                                {{0, -0.06, 1.36}, {0, -0.05, 1.0}, 0.12, 0.12},
                                {{0, 0.2, 1.4}, {-0.1, 0.33, 1.15}, 0.06, 0.05},
                                {{-0.1, 0.33, 1.15}, {0.1, 0.4, 1.0}, 0.045, 0.035},
                                {{0, -0.2, 1.4}, {0.12, -0.33, 1.18}, 0.06, 0.05},
                                {{0.12, -0.33, 1.18}, {0.34, -0.36, 1.1}, 0.045, 0.035},
                                {{0, 0.1, 0.9}, {0.18, 0.12, 0.5}, 0.09, 0.06},
                                {{0.18, 0.12, 0.5}, {0.16, 0.12, 0.1}, 0.06, 0.045},
                                {{0.16, 0.12, 0.06}, {0.32, 0.14, 0.05}, 0.05, 0.035},
                                {{0, -0.1, 0.9}, {-0.12, -0.12, 0.5}, 0.09, 0.06},
                                {{-0.12, -0.12, 0.5}, {-0.35, -0.12, 0.16}, 0.06, 0.045},
                                {{-0.36, -0.12, 0.12}, {-0.24, -0.13, 0.05}, 0.05, 0.035}};
  cv::Mat mask = cv::Mat::zeros(camera.height(), camera.width(), CV_8UC1);
  for (const Limb& limb : kLimbs) {
    for (double t = 0; t <= 1; t += 0.02) {
      const Eigen::Vector3d at = limb.from + t * (limb.to - limb.from);
      const auto pixel = camera.project(at);
      if (!pixel) throw std::logic_error("a limb is behind a camera");
      const double radius = limb.from_radius + t * (limb.to_radius - limb.from_radius);
      const double focal = 700 / (at - camera.position()).norm();
      cv::circle(mask, {int(std::lround(pixel->x())), int(std::lround(pixel->y()))},
                 int(std::lround(radius * focal)), 255, cv::FILLED);
    }
  }
  return mask;
}

const VisualHull& personHull(int voxels) {
  static std::map<int, VisualHull> hulls;
  if (const auto known = hulls.find(voxels); known != hulls.end()) return known->second;
  CameraRig rig;
  std::vector<HullView> views;
  for (int i = 0; i < 8; ++i) {
    rig.push_back(cameraAt(i * std::acos(-1.0) / 4 + 0.1, i % 2 == 0 ? 1.3 : 2.3));
    views.push_back({drawMask(rig.back()), {}});
  }
  HullOptions options;
  options.volume = "explicit";
  options.volume_min = {-1, -1, 0};
  options.volume_max = {1, 1, 2};
  options.pitch = 2.0 / voxels;
  return hulls[voxels] = HullCarver(rig, options).carve(views);
}

void thinHull(benchmark::State& state) {
  const VisualHull& hull = personHull(int(state.range(0)));
  Thinner thinner(PoseTreeOptions().persistence);
  size_t voxels = 0;
  for (auto _ : state) voxels = thinner.thin(hull).voxels.size();
  state.counters["voxels"] = double(hull.voxels.size());
  state.counters["skeleton"] = double(voxels);
}

struct Prepared {
  BitVolumeWindow window;
  BitWords bits;
  explicit Prepared(const benchmark::State& state) {
    const VisualHull& hull = personHull(int(state.range(0)));
    std::vector<uint32_t> voxels;
    for (const HullVoxel& voxel : hull.voxels) voxels.push_back(voxel.index);
    window.load(hull.lattice, voxels, &bits);
  }
};

void largestComponent(benchmark::State& state) {
  Prepared prepared(state);
  LargestComponent components;
  for (auto _ : state) components.keep(prepared.window.box(), &prepared.bits);
}

void fillCavities(benchmark::State& state) {
  Prepared prepared(state);
  CavityFiller cavities;
  for (auto _ : state) cavities.fill(prepared.window.box(), &prepared.bits);
}

void peel(benchmark::State& state) {
  const Prepared prepared(state);
  SymmetricThinning thinning;
  BitWords bits;
  for (auto _ : state) {
    bits = prepared.bits;
    thinning.thin(prepared.window.box(), kPeelingRounds, &bits);
  }
}

void writeHulls(const std::string& folder) {
  for (int voxels : {64, 128}) {
    const VisualHull& hull = personHull(voxels);
    std::ofstream file(folder + "/hull_" + std::to_string(voxels) + ".vox", std::ios::binary);
    const Eigen::Vector4i head(hull.lattice.size.x(), hull.lattice.size.y(), hull.lattice.size.z(),
                               int(hull.voxels.size()));
    file.write(reinterpret_cast<const char*>(head.data()), 16);
    for (const HullVoxel& voxel : hull.voxels)
      file.write(reinterpret_cast<const char*>(&voxel.index), 4);
    if (!file) throw std::runtime_error("cannot write hulls to " + folder);
  }
}

BENCHMARK(thinHull)->Arg(64)->Arg(128)->Unit(benchmark::kMicrosecond);
BENCHMARK(largestComponent)->Arg(64)->Arg(128)->Unit(benchmark::kMicrosecond);
BENCHMARK(fillCavities)->Arg(64)->Arg(128)->Unit(benchmark::kMicrosecond);
BENCHMARK(peel)->Arg(64)->Arg(128)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace markerless_mocap

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const std::string flag = "--write_hulls=";
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]).rfind(flag, 0) != 0) return 1;
    markerless_mocap::writeHulls(std::string(argv[i]).substr(flag.size()));
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
