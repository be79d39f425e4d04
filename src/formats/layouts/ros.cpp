// ROS: one camera_info YAML per camera (camera_calibration_parsers) and the poses as static
// transforms (ros_transforms.h).
#include <algorithm>
#include <set>
#include <sstream>

#include "formats/parts/camera_parts.h"
#include "formats/parts/ros_transforms.h"
#include "formats/parts/yaml_parts.h"
#include "formats/ros_texts.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

constexpr const char* kFormat = "ROS camera_info";

bool isCameraInfo(const std::string& text) {
  const auto root = yamlMap(text);
  return root && (*root)["image_width"] && (*root)["camera_matrix"];
}

std::vector<double> dataIn(const YAML::Node& map, const char* key, const std::string& where) {
  return yamlNumbers(yamlRequired(yamlRequired(map, key, where), "data", where), key, where);
}

CameraCalibration cameraIn(const TextFile& file) {
  const YAML::Node root = *yamlMap(file.text);
  CameraCalibration camera;
  camera.name = root["camera_name"].as<std::string>("");
  camera.width = yamlPixels(root["image_width"], "image_width", file.path);
  camera.height =
      yamlPixels(yamlRequired(root, "image_height", file.path), "image_height", file.path);
  const auto K = dataIn(root, "camera_matrix", file.path);
  if (std::all_of(K.begin(), K.end(), [](double value) { return value == 0.0; }))
    throwFormatError(file.path, "the camera matrix is all zero, so the camera is not calibrated");
  camera.K = cameraMatrixFrom(K, file.path);
  const std::string model = root["distortion_model"].as<std::string>("plumb_bob");
  if (model == "equidistant" || model == "fisheye")
    camera.lens = LensType::kFisheye;
  else if (model != "plumb_bob" && model != "rational_polynomial" && !model.empty())
    throwFormatError(file.path, "'distortion_model' is " + model +
                                    ", allowed are plumb_bob, rational_polynomial and equidistant");
  if (root["distortion_coefficients"])
    camera.D = dataIn(root, "distortion_coefficients", file.path);
  return camera;
}

/// Drivers often leave one camera_name in all files.
void giveNames(const std::vector<TextFile>& files, std::vector<CameraCalibration>* cameras) {
  std::set<std::string> names;
  for (const CameraCalibration& camera : *cameras) names.insert(camera.name);
  if (names.size() == cameras->size() && names.count("") == 0) return;
  const auto from_files = cameraNamesOf(files);
  for (size_t i = 0; i < cameras->size(); ++i) (*cameras)[i].name = from_files[i];
}

std::vector<TextFile> cameraInfosAmong(const std::vector<TextFile>& files) {
  std::vector<TextFile> infos;
  for (const TextFile& file : files)
    if (isCameraInfo(file.text)) infos.push_back(file);
  if (infos.empty())
    throwFormatError(files[0].path, "there are transforms but no camera_info YAML of a camera");
  return infos;
}

std::string matrixText(const char* key, size_t rows, const std::vector<double>& values) {
  std::ostringstream out;
  out << key << ":\n  rows: " << rows << "\n  cols: " << values.size() / rows << "\n  data: ["
      << numbersText(values) << "]\n";
  return out.str();
}

}  // namespace

std::string cameraInfoText(const CameraCalibration& camera) {
  const bool rational = camera.D.size() == 8, fisheye = camera.lens == LensType::kFisheye;
  const char* model = fisheye ? "equidistant" : rational ? "rational_polynomial" : "plumb_bob";
  Eigen::Matrix<double, 3, 4> P = Eigen::Matrix<double, 3, 4>::Zero();
  P.leftCols<3>() = camera.K;
  std::ostringstream out;
  out << "image_width: " << camera.width << "\nimage_height: " << camera.height
      << "\ncamera_name: " << yamlQuoted(camera.name) << '\n'
      << matrixText("camera_matrix", 3, rowsOf(camera.K)) << "distortion_model: " << model << '\n'
      << matrixText("distortion_coefficients", 1,
                    fisheye ? fisheyeDistortion(camera)
                            : distortionOfLength(camera, rational ? 8 : 5, kFormat))
      << matrixText("rectification_matrix", 3, rowsOf(Eigen::Matrix3d::Identity()))
      << matrixText("projection_matrix", 3, rowsOf(P));
  return out.str();
}

bool isRosText(const std::string& text) {
  return isCameraInfo(text) || holdsTransforms(text);
}

CalibrationSet readRosLenses(const std::vector<TextFile>& files) {
  const std::vector<TextFile> infos = cameraInfosAmong(files);
  CalibrationSet set;
  set.metres_per_unit = 1.0;
  for (const TextFile& file : infos) set.cameras.push_back(cameraIn(file));
  giveNames(infos, &set.cameras);
  return set;
}

CalibrationSet readRosFiles(const std::vector<TextFile>& files) {
  StaticTransforms transforms;
  for (const TextFile& file : files)
    if (!isCameraInfo(file.text)) transforms.add(file);
  const std::vector<TextFile> infos = cameraInfosAmong(files);
  CalibrationSet set = readRosLenses(files);
  for (size_t i = 0; i < infos.size(); ++i)
    set.cameras[i].T_world_camera =
        transforms.poseOfCamera(set.cameras[i].name, infos[i].path, &set.remarks);
  return set;
}

std::vector<TextFile> writeRosFiles(const std::vector<CameraCalibration>& rig) {
  std::vector<TextFile> files;
  for (const CameraCalibration& camera : rig)
    files.push_back({fileNameOf(camera) + ".yaml", cameraInfoText(camera)});
  files.push_back({"tf_static.launch", transformsLaunchText(rig, "world")});
  return files;
}

}  // namespace markerless_mocap
