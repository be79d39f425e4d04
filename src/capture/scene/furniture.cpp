#include "capture/scene/furniture.h"

#include <algorithm>
#include <cmath>

#include "capture/scene/panel.h"
#include "capture/scene/value_noise.h"

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

constexpr float kCell = 0.025f;  // of surfaces with a pattern, metres
constexpr float kDoorWidth = 0.9f, kDoorHeight = 2.05f, kDoorDepth = 0.04f;

Eigen::Vector3f cardboard(float u, float v) {
  const float grain = 1.0f + 0.06f * fractalNoise(21, u, v, 0.2f, 3);
  if (std::abs(u - 0.24f) < 0.035f) return Eigen::Vector3f(0.74f, 0.66f, 0.50f) * grain;  // tape
  const bool print = v > 0.42f && v < 0.56f && u > 0.06f && u < 0.2f;
  return Eigen::Vector3f(0.60f, 0.45f, 0.29f) * (print ? 0.45f : grain);
}

Eigen::Vector3f paintedWood(float u, float v) {
  const Eigen::Vector3f paint(0.42f, 0.50f, 0.56f);
  const float x = std::min(u, kDoorWidth - u);
  const bool groove = (x > 0.12f && x < 0.16f) || (v > 0.98f && v < 1.02f);
  return paint * (groove ? 0.75f : 1.0f + 0.03f * fractalNoise(22, u * 4.0f, v, 0.3f, 3));
}

Eigen::Vector3f darkCorridor(float, float v) {
  return Eigen::Vector3f(0.16f, 0.14f, 0.13f) * (0.6f + 0.4f * v / kDoorHeight);
}

}  // namespace

ColoredMesh boxMesh() {
  ColoredMesh mesh;
  addPanelBox({-0.3f, -0.225f, 0.0f}, {0.3f, 0.225f, 0.7f}, kCell, cardboard, &mesh);
  return mesh;
}

ColoredMesh doorLeafMesh() {
  ColoredMesh mesh;
  addPanelBox({0.0f, -kDoorDepth, 0.0f}, {kDoorWidth, 0.0f, kDoorHeight}, kCell, paintedWood,
              &mesh);
  return mesh;
}

ColoredMesh doorwayMesh() {
  ColoredMesh mesh;
  addPanel({{kDoorWidth, 0.0f, 0.0f}, {-kDoorWidth, 0.0f, 0.0f}, {0.0f, 0.0f, kDoorHeight}}, kCell,
           darkCorridor, &mesh);
  return mesh;
}

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
