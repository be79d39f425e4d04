#include "capture/scene/panel.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {

void addPanel(const Panel& panel, float cell, const PanelColor& color, ColoredMesh* mesh) {
  const float width = panel.along_u.norm(), height = panel.along_v.norm();
  const int columns = std::max(1, int(std::lround(width / cell)));
  const int rows = std::max(1, int(std::lround(height / cell)));
  const int first = int(mesh->vertices.size()), step = columns + 1;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const float u = float(i) / float(columns), v = float(j) / float(rows);
      mesh->vertices.push_back(panel.corner + u * panel.along_u + v * panel.along_v);
      mesh->colors.push_back(color(u * width, v * height));
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = first + j * step + i;
      mesh->triangles.push_back({a, a + 1, a + 1 + step});
      mesh->triangles.push_back({a, a + 1 + step, a + step});
    }
}

void addPanelBox(const Eigen::Vector3f& low, const Eigen::Vector3f& high, float cell,
                 const PanelColor& color, ColoredMesh* mesh) {
  const Eigen::Vector3f size = high - low;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Eigen::Vector3f along_u = size[u] * Eigen::Vector3f::Unit(u);
    const Eigen::Vector3f along_v = size[v] * Eigen::Vector3f::Unit(v);
    // The second side runs upwards on all four walls.
    const bool turned = v != 2 && u == 2;
    const Eigen::Vector3f upper = low + size[axis] * Eigen::Vector3f::Unit(axis);
    if (turned) {
      addPanel({upper + along_v, -along_v, along_u}, cell, color, mesh);
      addPanel({low, along_v, along_u}, cell, color, mesh);
    } else {
      addPanel({upper, along_u, along_v}, cell, color, mesh);
      addPanel({low + along_u, -along_u, along_v}, cell, color, mesh);
    }
  }
}

}  // namespace markerless_mocap
