#include "capture/scene/furniture.h"

namespace markerless_mocap {
namespace {

/// The six sides have separate corners, so that edges look sharp.
void addBox(const Eigen::Vector3f& low, const Eigen::Vector3f& high, const Eigen::Vector3f& color,
            ColoredMesh& mesh) {
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const int first = int(mesh.vertices.size()), u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (int corner = 0; corner < 4; ++corner) {
        Eigen::Vector3f vertex = upper ? high : low;
        vertex[u] = corner == 1 || corner == 2 ? high[u] : low[u];
        vertex[v] = corner >= 2 ? high[v] : low[v];
        mesh.vertices.push_back(vertex);
        mesh.colors.push_back(color);
      }
      const int second = upper ? first + 1 : first + 3, fourth = upper ? first + 3 : first + 1;
      mesh.triangles.push_back({first, second, first + 2});
      mesh.triangles.push_back({first, first + 2, fourth});
    }
}

}  // namespace

ColoredMesh chairMesh() {
  constexpr float kHalf = 0.21f, kLeg = 0.04f, kSeat = 0.45f, kThickness = 0.03f, kTop = 0.9f;
  const Eigen::Vector3f wood(0.45f, 0.30f, 0.18f);
  ColoredMesh mesh;
  addBox({-kHalf, -kHalf, kSeat - kThickness}, {kHalf, kHalf, kSeat}, wood * 1.15f, mesh);
  for (const float y : {-kHalf, kHalf - kLeg}) {
    addBox({kHalf - kLeg, y, 0.0f}, {kHalf, y + kLeg, kSeat - kThickness}, wood, mesh);
    addBox({-kHalf, y, 0.0f}, {-kHalf + kLeg, y + kLeg, kSeat - kThickness}, wood, mesh);
    addBox({-kHalf, y, kSeat}, {-kHalf + kThickness, y + kLeg, kTop}, wood, mesh);
  }
  for (const float z : {0.58f, 0.70f, 0.82f})
    addBox({-kHalf + 0.005f, -kHalf + kLeg, z},
           {-kHalf + kThickness - 0.005f, kHalf - kLeg, z + 0.06f}, wood * 1.1f, mesh);
  return mesh;
}

}  // namespace markerless_mocap
