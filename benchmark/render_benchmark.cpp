/// Eight views of a person of 40 000 triangles in a textured room, with shadows and noise, against
/// the straightforward caster that tests every ray against every triangle. Both are told in one
/// run: the ratio of their rays per second is the result.

#include <benchmark/benchmark.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

#include "capture/degradations/sensor.h"
#include "capture/render/mesh_renderer.h"

namespace markerless_mocap {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kCameras = 8, kWidth = 640, kHeight = 480;

/// A round rod with half balls at its ends, of 3000 triangles.
void addCapsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                ColoredMesh& mesh) {
  constexpr int kAround = 36, kAlong = 42;
  const Eigen::Vector3d axis = (to - from).normalized(), u = axis.unitOrthogonal();
  const Eigen::Vector3d v = axis.cross(u);
  const int first = int(mesh.vertices.size());
  for (int i = 0; i <= kAlong; ++i)
    for (int j = 0; j < kAround; ++j) {
      const double up = kPi * (double(i) / kAlong - 0.5), turn = 2 * kPi * j / kAround;
      const Eigen::Vector3d out = std::cos(turn) * u + std::sin(turn) * v;
      const Eigen::Vector3d middle = i * 2 < kAlong ? from : to;
      mesh.vertices.push_back(
          (middle + radius * (std::cos(up) * out + std::sin(up) * axis)).cast<float>());
      mesh.colors.emplace_back(0.6f, 0.4f, 0.3f);
    }
  for (int i = 0; i < kAlong; ++i)
    for (int j = 0; j < kAround; ++j) {
      const int a = first + i * kAround + j, b = first + i * kAround + (j + 1) % kAround;
      mesh.triangles.push_back({a, b, b + kAround});
      mesh.triangles.push_back({a, b + kAround, a + kAround});
    }
}

ColoredMesh person() {
  ColoredMesh mesh;
  addCapsule({0, 0, 1.62}, {0, 0, 1.67}, 0.1, mesh);
  addCapsule({0, 0, 0.95}, {0, 0, 1.4}, 0.16, mesh);
  for (const double side : {-1.0, 1.0}) {
    addCapsule({0, side * 0.2, 1.42}, {0, side * 0.45, 1.3}, 0.055, mesh);
    addCapsule({0, side * 0.45, 1.3}, {0.1, side * 0.65, 1.45}, 0.04, mesh);
    addCapsule({0.1, side * 0.65, 1.45}, {0.12, side * 0.7, 1.55}, 0.03, mesh);
    addCapsule({0, side * 0.1, 0.9}, {0.05, side * 0.12, 0.5}, 0.08, mesh);
    addCapsule({0.05, side * 0.12, 0.5}, {0, side * 0.12, 0.1}, 0.055, mesh);
    addCapsule({0, side * 0.12, 0.04}, {0.18, side * 0.13, 0.04}, 0.04, mesh);
  }
  return mesh;
}

CameraRig ring() {
  CameraRig rig;
  for (int i = 0; i < kCameras; ++i) {
    const double angle = 2 * kPi * i / kCameras;
    CameraCalibration c;
    c.name = "cam" + std::to_string(i);
    c.width = kWidth;
    c.height = kHeight;
    c.K << 480, 0, 319.5, 0, 480, 239.5, 0, 0, 1;
    c.D = {-0.1, 0.02, 0, 0, 0};
    const Eigen::Vector3d x(-std::sin(angle), std::cos(angle), 0);
    const Eigen::Vector3d z(-std::cos(angle), -std::sin(angle), 0);
    c.T_world_camera.linear() << x, z.cross(x), z;
    c.T_world_camera.translation() = Eigen::Vector3d(0, 0, 1.1) - 3.5 * z;
    rig.emplace_back(c);
  }
  return rig;
}

/// One instant of the studio, from the posed mesh to the cameras' pictures.
void meshRenderer(benchmark::State& state) {
  const CameraRig rig = ring();
  const TexturedRoom room = TexturedRoom::around(1, rig);
  const std::vector<MeshRenderer> renderers = makeRenderers(rig, room);
  const ColoredMesh mesh = person();
  std::vector<RenderedView> views(rig.size());
  for (auto _ : state) {
    const LitScene scene(room, {{mesh.vertices, &mesh, true}}, 0.5);
    tbb::parallel_for(size_t(0), rig.size(), [&](size_t i) {
      views[i] = renderers[i].render(scene);
      applySensor(3.0, 1.0, i, views[i].image);
    });
  }
  state.counters["triangles"] = double(mesh.triangles.size());
  state.counters["rays"] =
      benchmark::Counter(double(rig.size()) * (2 * kWidth + 1) * (2 * kHeight + 1),
                         benchmark::Counter::kIsIterationInvariantRate);
}

/// Distance to the nearest triangle (Moeller and Trumbore), infinity for none.
double cast(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray,
            const std::vector<Eigen::Vector3d>& vertices, const ColoredMesh& mesh) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k] : mesh.triangles) {
    const Eigen::Vector3d &a = vertices[i], ab = vertices[j] - a, ac = vertices[k] - a;
    const Eigen::Vector3d p = ray.cross(ac), q = (eye - a).cross(ab);
    const double scale = 1.0 / ab.dot(p), u = (eye - a).dot(p) * scale, v = ray.dot(q) * scale;
    const double distance = ac.dot(q) * scale;
    if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest) nearest = distance;
  }
  return nearest;
}

/// Depth alone, every 20th pixel of one view, on all cores.
void everyRayEveryTriangle(benchmark::State& state) {
  constexpr int kStep = 20;
  const Camera camera = ring().front();
  const ColoredMesh mesh = person();
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3f& vertex : mesh.vertices) vertices.push_back(vertex.cast<double>());
  std::vector<double> depths((kHeight / kStep) * (kWidth / kStep));
  for (auto _ : state)
    tbb::parallel_for(0, kHeight / kStep, [&](int y) {
      for (int x = 0; x < kWidth / kStep; ++x)
        depths[y * (kWidth / kStep) + x] =
            cast(camera.position(), camera.rayDirection({double(kStep * x), double(kStep * y)}),
                 vertices, mesh);
    });
  benchmark::DoNotOptimize(depths);
  state.counters["rays"] =
      benchmark::Counter(double(depths.size()), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(meshRenderer)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(everyRayEveryTriangle)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace markerless_mocap
