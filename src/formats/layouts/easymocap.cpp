// EasyMocap's intri.yml (K_<name>, dist_<name>, W_<name>, H_<name>) and extri.yml (R_<name>:
// rotation vector, Rot_<name>: matrix, T_<name>), world to camera, in OpenCV's YAML.
#include <algorithm>
#include <sstream>

#include "formats/parts/camera_parts.h"
#include "formats/parts/opencv_storage.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

constexpr const char* kFormat = "EasyMocap intri.yml and extri.yml";

/// Names behind a prefix, in the order of the file. The list 'names' is not used: an unquoted 01
/// in it is the number 1.
std::vector<std::string> namesBehind(const std::string& prefix, const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& key : storageKeys(text))
    if (key.rfind(prefix, 0) == 0) names.push_back(key.substr(prefix.size()));
  return names;
}

bool isIntrinsic(const std::string& text) {
  return !namesBehind("K_", text).empty();
}

bool isExtrinsic(const std::string& text) {
  return !namesBehind("T_", text).empty() &&
         (!namesBehind("R_", text).empty() || !namesBehind("Rot_", text).empty());
}

void readIntrinsics(const TextFile& file, CameraCalibration* camera) {
  const cv::FileStorage storage = openStorage(file);
  const std::string where = file.path + ", camera '" + camera->name + "'";
  camera->K = cameraMatrixFrom(storageNumbers(storage, "K_" + camera->name, where), where);
  const std::string lens = storageKeyAmong(storage, {"dist_" + camera->name, "D_" + camera->name});
  if (!lens.empty()) camera->D = storageNumbers(storage, lens, where);
  if (!storage["W_" + camera->name].empty() && !storage["H_" + camera->name].empty()) {
    const auto pixels = [&](const std::string& key) {
      return pixelsFrom(storageNumber(storage, key, where), key, where);
    };
    camera->width = pixels("W_" + camera->name);
    camera->height = pixels("H_" + camera->name);
  }
}

void readExtrinsics(const TextFile& file, CameraCalibration* camera) {
  const cv::FileStorage storage = openStorage(file);
  const std::string where = file.path + ", camera '" + camera->name + "'";
  const std::string rotation =
      storageKeyAmong(storage, {"Rot_" + camera->name, "R_" + camera->name});
  if (rotation.empty()) throwFormatError(where, "there is no 'R_" + camera->name + "'");
  const auto t = storageNumbers(storage, "T_" + camera->name, where);
  checkNumbers(t, 3, "'T_" + camera->name + "'", where);
  camera->T_world_camera = poseFromWorldToCamera(
      rotationFrom(storageNumbers(storage, rotation, where), where), {t[0], t[1], t[2]});
}

void writeMatrix(std::ostream& out, const std::string& key, const std::vector<double>& values,
                 size_t rows) {
  out << key << ": !!opencv-matrix\n  rows: " << rows << "\n  cols: " << values.size() / rows
      << "\n  dt: d\n  data: [" << numbersText(values) << "]\n";
}

std::string headText(const std::vector<CameraCalibration>& rig) {
  std::string out = "%YAML:1.0\n---\nnames:\n";
  for (const CameraCalibration& camera : rig) out += "  - \"" + camera.name + "\"\n";
  return out;
}

/// Names are parts of keys here.
void checkName(const CameraCalibration& camera) {
  for (const unsigned char c : camera.name)
    if (!std::isalnum(c) && c != '_' && c != '-')
      throwFormatError(kFormat, "camera '" + camera.name +
                                    "' has a name with other signs than letters, digits, _ and -");
}

}  // namespace

bool isEasyMocapText(const std::string& text) {
  return isStorageText(text) && (isIntrinsic(text) || isExtrinsic(text));
}

CalibrationSet readEasyMocapFiles(const std::vector<TextFile>& files) {
  const TextFile *intri = nullptr, *extri = nullptr;
  for (const TextFile& file : files) {
    const TextFile*& role = isIntrinsic(file.text) ? intri : extri;
    if (role)
      throwFormatError(file.path, "this is a second file like " + role->path + ", allowed is one");
    role = &file;
  }
  if (!intri || !extri)
    throwFormatError(files[0].path, std::string("this is only half of a calibration, ") +
                                        (intri ? "extri.yml" : "intri.yml") + " is missing");
  CalibrationSet set;
  for (const std::string& name : namesBehind("K_", intri->text)) {
    set.cameras.emplace_back();
    set.cameras.back().name = name;
    readIntrinsics(*intri, &set.cameras.back());
    readExtrinsics(*extri, &set.cameras.back());
  }
  return set;
}

std::vector<TextFile> writeEasyMocapFiles(const std::vector<CameraCalibration>& rig) {
  std::ostringstream intri, extri;
  intri << headText(rig);
  extri << headText(rig);
  for (const CameraCalibration& camera : rig) {
    checkName(camera);
    const Eigen::Isometry3d T = camera.T_world_camera.inverse();
    writeMatrix(intri, "K_" + camera.name, rowsOf(camera.K), 3);
    writeMatrix(intri, "dist_" + camera.name, distortionOfLength(camera, 5, kFormat), 1);
    intri << "H_" << camera.name << ": " << camera.height << "\nW_" << camera.name << ": "
          << camera.width << '\n';
    writeMatrix(extri, "R_" + camera.name, rowsOf(rotationVector(T.linear())), 3);
    writeMatrix(extri, "Rot_" + camera.name, rowsOf(T.linear()), 3);
    writeMatrix(extri, "T_" + camera.name, rowsOf(T.translation()), 3);
  }
  return {{"intri.yml", intri.str()}, {"extri.yml", extri.str()}};
}

}  // namespace markerless_mocap
