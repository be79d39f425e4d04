#include "tools/import/import_recording.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace markerless_mocap {
namespace {

void checkRange(const char* option, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return;  // false for NaN
  std::ostringstream message;
  message << option << " is " << value << ", allowed is " << lowest << " to " << highest;
  throw std::invalid_argument(message.str());
}

}  // namespace

void ImportOptions::validate() const {
  world.validate();
  checkRange("fps", fps, 0.0, 1000.0);
  checkRange("start-stamp", start_stamp, 1e-3, 4e9);  // 0 is not a valid time in a bag
  checkRange("jpeg", jpeg_quality, 0, 100);
}

int64_t ImportOptions::stampOf(int frame_set, double frame_sets_per_second) const {
  return std::llround(1e9 * (start_stamp + frame_set / frame_sets_per_second));
}

void print(const ImportResult& result, std::ostream& out) {
  out << result.cameras.size() << " cameras, " << result.frame_sets << " frame sets at "
      << result.fps << " per second\n"
      << std::fixed << std::setprecision(2);
  for (const CameraCalibration& camera : result.cameras) {
    const Eigen::Vector3d position = camera.T_world_camera.translation();
    const Eigen::Vector3d forward = camera.T_world_camera.linear().col(2);
    out << "  " << std::left << std::setw(10) << camera.name << std::right << camera.width << " x "
        << camera.height << "  at " << std::setw(6) << position.x() << ' ' << std::setw(6)
        << position.y() << ' ' << std::setw(6) << position.z() << " m, direction " << std::setw(5)
        << forward.x() << ' ' << std::setw(5) << forward.y() << ' ' << std::setw(5) << forward.z()
        << '\n';
  }
  out << std::defaultfloat << std::setprecision(6);
  for (const std::string& remark : result.warnings) out << "note: " << remark << '\n';
}

}  // namespace markerless_mocap
