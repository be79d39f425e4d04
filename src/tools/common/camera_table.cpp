#include "tools/common/camera_table.h"

#include <iomanip>

namespace markerless_mocap {

void printCameras(const std::vector<CameraCalibration>& cameras, std::ostream& out) {
  out << std::fixed << std::setprecision(2);
  for (const CameraCalibration& camera : cameras) {
    const Eigen::Vector3d position = camera.T_world_camera.translation();
    const Eigen::Vector3d forward = camera.T_world_camera.linear().col(2);
    out << "  " << std::left << std::setw(10) << camera.name << std::right;
    if (camera.width > 0)
      out << camera.width << " x " << camera.height;
    else
      out << "size not known";
    out << "  at " << std::setw(6) << position.x() << ' ' << std::setw(6) << position.y() << ' '
        << std::setw(6) << position.z() << " m, direction " << std::setw(5) << forward.x() << ' '
        << std::setw(5) << forward.y() << ' ' << std::setw(5) << forward.z() << '\n';
  }
  out << std::defaultfloat << std::setprecision(6);
}

}  // namespace markerless_mocap
