#pragma once

#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Layouts of calibrations; docs/calibration_formats.md describes each.
enum class CalibrationFormat {
  kRig,
  kRos,
  kKalibr,
  kOpenCv,
  kMatrices,
  kQualisys,
  kAnipose,
  kCaliscope,
  kFreeMoCap,
  kPose2Sim,
  kEasyMocap,
  kColmap
};

/// A calibration in the units and axes of its files.
struct CalibrationSet {
  CalibrationFormat format = CalibrationFormat::kRig;
  /// Width and height are 0 where the files do not have them.
  std::vector<CameraCalibration> cameras;
  std::optional<double> metres_per_unit;  ///< empty if the format leaves the unit open
  std::vector<std::string> remarks;       ///< cameras left out, a world that is arbitrary
};

/// Name of a format on a command line, such as "kalibr".
const char* nameOf(CalibrationFormat format);
/// Description of a format for messages, such as "Kalibr camchain".
const char* titleOf(CalibrationFormat format);
/// Throws std::invalid_argument with the names that are allowed.
CalibrationFormat calibrationFormatNamed(const std::string& name);

/// Reads the cameras of a rig from files of any of these formats, which are told by their content.
/// \param paths files, or folders whose files, or the files in whose folders, are the calibration.
/// Files of a folder that are no calibration are skipped.
/// Cameras keep the order of the files. A file of one camera gives it its name, or its folder does
/// if all files have one name. Throws std::runtime_error if a file cannot be read, and
/// std::invalid_argument if the content is of no known format or of several, or is wrong: the
/// message says where and what is allowed.
CalibrationSet readCalibration(const std::vector<std::string>& paths);

/// As readCalibration(), but camera_info YAML and OpenCV's files need not tell the cameras' poses.
CalibrationSet readLenses(const std::vector<std::string>& paths);

/// As readCalibration(), for a file with exactly one camera.
CameraCalibration readCameraCalibration(const std::string& path);

/// Writes a rig in metres. `path` is a file, or a folder for formats with several files.
/// \param overwrite replace files that exist
/// \returns the files written
/// Throws std::invalid_argument if the format cannot hold a camera's lens, naming both, or if the
/// rig is not valid as for rigText(); and std::runtime_error if a file exists or cannot be written.
std::vector<std::string> writeCalibration(const std::string& path, CalibrationFormat format,
                                          const std::vector<CameraCalibration>& rig,
                                          bool overwrite = false);

}  // namespace markerless_mocap
