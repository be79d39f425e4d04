#include "tools/calibrate_rig/calibration_files.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "files/whole_file.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"
#include "tools/calibrate_rig/calibration_page.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

std::string matrixText(const std::string& key, int rows, const std::vector<double>& values) {
  std::ostringstream out;
  out.precision(12);
  out << key << ":\n  rows: " << rows << "\n  cols: " << values.size() / size_t(rows)
      << "\n  data: [";
  for (size_t i = 0; i < values.size(); ++i) out << (i ? ", " : "") << values[i];
  out << "]\n";
  return out.str();
}

std::vector<double> rowsOf(const Eigen::Matrix3d& m, bool with_fourth_column) {
  std::vector<double> values;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) values.push_back(m(row, column));
    if (with_fourth_column) values.push_back(0.0);
  }
  return values;
}

void writeFile(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  writeWholeFile(path.string(), text);
}

std::vector<CameraCalibration> rigOf(const RigCalibration& result) {
  std::vector<CameraCalibration> rig;
  for (const CalibratedCamera& camera : result.cameras) rig.push_back(camera.calibration);
  return rig;
}

}  // namespace

std::string cameraInfoText(const CameraCalibration& camera) {
  std::vector<double> D = camera.D;
  const bool fisheye = camera.lens == LensType::kFisheye;
  if (!fisheye && D.size() < 5) D.resize(5, 0.0);
  if (fisheye) D.resize(4, 0.0);
  std::ostringstream out;
  out << "image_width: " << camera.width << "\nimage_height: " << camera.height
      << "\ncamera_name: " << camera.name << '\n'
      << matrixText("camera_matrix", 3, rowsOf(camera.K, false)) << "distortion_model: "
      << (fisheye         ? "equidistant"
          : D.size() == 8 ? "rational_polynomial"
                          : "plumb_bob")
      << '\n'
      << matrixText("distortion_coefficients", 1, D)
      << matrixText("rectification_matrix", 3, rowsOf(Eigen::Matrix3d::Identity(), false))
      << matrixText("projection_matrix", 3, rowsOf(camera.K, true));
  return out.str();
}

std::string transformsLaunchText(const std::vector<CameraCalibration>& cameras,
                                 const std::string& world_frame) {
  std::ostringstream out;
  out.precision(12);
  out << "<!-- Where the cameras stand: world to optical frame; x y z (m), quaternion x y z w. "
         "-->\n"
         "<launch>\n";
  for (const CameraCalibration& camera : cameras) {
    const Eigen::Vector3d t = camera.T_world_camera.translation();
    const Eigen::Quaterniond q(camera.T_world_camera.linear());
    out << "  <node pkg=\"tf2_ros\" type=\"static_transform_publisher\" name=\"" << camera.name
        << "_transform\"\n        args=\"" << t.x() << ' ' << t.y() << ' ' << t.z() << ' ' << q.x()
        << ' ' << q.y() << ' ' << q.z() << ' ' << q.w() << ' ' << world_frame << ' '
        << opticalFrame(camera.name) << "\"/>\n";
  }
  out << "</launch>\n";
  return out.str();
}

void writeLenses(const std::string& folder, const RigCalibration& result) {
  for (const CalibratedCamera& camera : result.cameras)
    writeFile(fs::path(folder) / "camera_info" / (camera.calibration.name + ".yaml"),
              cameraInfoText(camera.calibration));
  writeFile(fs::path(folder) / "report.html", calibrationPage(result));
}

void writeCalibration(const std::string& folder, const RigCalibration& result,
                      const std::string& world_frame) {
  writeLenses(folder, result);
  writeFile(fs::path(folder) / "rig.yaml", rigText(rigOf(result)));
  writeFile(fs::path(folder) / "cameras.launch", transformsLaunchText(rigOf(result), world_frame));
}

}  // namespace markerless_mocap
