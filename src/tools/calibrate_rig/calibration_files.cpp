#include "tools/calibrate_rig/calibration_files.h"

#include <filesystem>

#include "files/whole_file.h"
#include "formats/ros_texts.h"
#include "markerless_mocap/camera/rig_file.h"
#include "tools/calibrate_rig/calibration_page.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

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
