// OpenCV XML and YAML, one file per camera, or one with the lens and one with the pose. Rotation
// and translation take world points to camera points, as in calibrateCamera() and solvePnP().
#include <algorithm>
#include <map>

#include "formats/parts/camera_parts.h"
#include "formats/parts/opencv_storage.h"

namespace markerless_mocap {
namespace {

using Keys = std::vector<std::string>;
const Keys kCameraMatrix = {"CameraMatrix",    "camera_matrix", "cameraMatrix", "K", "M",
                            "intrinsic_matrix"};
const Keys kDistortion = {"DistortionCoeffs",
                          "distortion_coefficients",
                          "distCoeffs",
                          "dist_coeffs",
                          "distortion",
                          "dist",
                          "D"};
const Keys kFisheye = {"fisheye_model", "fisheye"};
const Keys kRotation = {"Rotation", "rotation", "rotation_matrix", "R", "rvec", "Rvec"};
const Keys kTranslation = {"Translation", "translation", "translation_vector", "T", "t",
                           "tvec",        "Tvec"};
const Keys kWidth = {"image_width", "image_Width", "width"};
const Keys kHeight = {"image_height", "image_Height", "height"};

/// What one file says about a camera.
struct Content {
  bool lens = false, pose = false;
};

Content contentOf(const std::string& text) {
  const Keys keys = storageKeys(text);
  const auto has = [&](const Keys& wanted) {
    for (const std::string& key : keys)
      if (std::find(wanted.begin(), wanted.end(), key) != wanted.end()) return true;
    return false;
  };
  return {has(kCameraMatrix), has(kRotation) && has(kTranslation)};
}

std::vector<double> required(const cv::FileStorage& storage, const Keys& keys,
                             const std::string& where) {
  const std::string key = storageKeyAmong(storage, keys);
  if (key.empty()) throwFormatError(where, "there is no matrix '" + keys.front() + "'");
  return storageNumbers(storage, key, where);
}

/// 0 if the file leaves it open.
int pixelsIn(const cv::FileStorage& storage, const Keys& keys, const std::string& where) {
  const std::string key = storageKeyAmong(storage, keys);
  return key.empty() ? 0 : pixelsFrom(storageNumber(storage, key, where), key, where);
}

void readLens(const TextFile& file, CameraCalibration* camera) {
  const cv::FileStorage storage = openStorage(file);
  camera->K = cameraMatrixFrom(required(storage, kCameraMatrix, file.path), file.path);
  const std::string lens = storageKeyAmong(storage, kDistortion);
  if (!lens.empty()) camera->D = storageNumbers(storage, lens, file.path);
  const std::string fisheye = storageKeyAmong(storage, kFisheye);
  if (!fisheye.empty() && storageNumber(storage, fisheye, file.path) != 0)
    camera->lens = LensType::kFisheye;
  camera->width = pixelsIn(storage, kWidth, file.path);
  camera->height = pixelsIn(storage, kHeight, file.path);
}

void readPose(const TextFile& file, CameraCalibration* camera) {
  const cv::FileStorage storage = openStorage(file);
  const auto t = required(storage, kTranslation, file.path);
  checkNumbers(t, 3, "the translation", file.path);
  camera->T_world_camera = poseFromWorldToCamera(
      rotationFrom(required(storage, kRotation, file.path), file.path), {t[0], t[1], t[2]});
}

/// The files of one camera.
struct CameraFiles {
  std::vector<const TextFile*> whole, lens, pose;
};

CameraCalibration cameraFrom(const CameraFiles& files, const std::string& name) {
  const TextFile* any = !files.whole.empty()  ? files.whole[0]
                        : !files.lens.empty() ? files.lens[0]
                                              : files.pose[0];
  if (files.whole.size() > 1)
    throwFormatError(any->path, "camera '" + name + "' has another calibration, too: " +
                                    files.whole[1]->path + "; name the one to read");
  CameraCalibration camera;
  camera.name = name;
  if (files.whole.size() == 1) {
    readLens(*any, &camera);
    readPose(*any, &camera);
    return camera;
  }
  if (files.lens.size() != 1 || files.pose.size() != 1)
    throwFormatError(any->path, "camera '" + name + "' has " + std::to_string(files.lens.size()) +
                                    " camera matrices and " + std::to_string(files.pose.size()) +
                                    " poses (Rotation and Translation), allowed is one of each");
  readLens(*files.lens[0], &camera);
  readPose(*files.pose[0], &camera);
  return camera;
}

/// A file with the pose, too, is that of the rig; one without is another calibration of the lens.
CameraCalibration lensFrom(const CameraFiles& files, const std::string& name) {
  const auto& lenses = files.whole.empty() ? files.lens : files.whole;
  if (lenses.size() != 1)
    throwFormatError((lenses.empty() ? files.pose : lenses)[0]->path,
                     "camera '" + name + "' has " + std::to_string(lenses.size()) +
                         " camera matrices, allowed is one: name the file to read");
  CameraCalibration camera;
  camera.name = name;
  readLens(*lenses[0], &camera);
  return camera;
}

/// Files by cameras, in their order. \param camera reads those of one
CalibrationSet camerasIn(const std::vector<TextFile>& files,
                         CameraCalibration (*camera)(const CameraFiles&, const std::string&)) {
  const std::vector<std::string> names = cameraNamesOf(files);
  std::vector<std::string> order;
  std::map<std::string, CameraFiles> by_name;
  for (size_t i = 0; i < files.size(); ++i) {
    const Content content = contentOf(files[i].text);
    if (by_name.count(names[i]) == 0) order.push_back(names[i]);
    CameraFiles& of_camera = by_name[names[i]];
    (content.lens && content.pose ? of_camera.whole
     : content.lens               ? of_camera.lens
                                  : of_camera.pose)
        .push_back(&files[i]);
  }
  CalibrationSet set;
  for (const std::string& name : order) set.cameras.push_back(camera(by_name[name], name));
  return set;
}

std::string storageText(const CameraCalibration& camera) {
  const Eigen::Isometry3d T = camera.T_world_camera.inverse();
  cv::FileStorage out("camera.xml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  out << "image_width" << camera.width << "image_height" << camera.height << "CameraMatrix"
      << storageMatrix(rowsOf(camera.K), 3);
  if (camera.lens == LensType::kFisheye) out << "fisheye_model" << 1;
  if (!camera.D.empty()) out << "DistortionCoeffs" << storageMatrix(camera.D, 1);
  out << "Rotation" << storageMatrix(rowsOf(T.linear()), 3) << "Translation"
      << storageMatrix(rowsOf(T.translation()), 3);
  return out.releaseAndGetString();
}

}  // namespace

bool isOpenCvText(const std::string& text) {
  if (!isStorageText(text)) return false;
  const Content content = contentOf(text);
  return content.lens || content.pose;
}

CalibrationSet readOpenCvFiles(const std::vector<TextFile>& files) {
  return camerasIn(files, cameraFrom);
}

CalibrationSet readOpenCvLenses(const std::vector<TextFile>& files) {
  return camerasIn(files, lensFrom);
}

std::vector<TextFile> writeOpenCvFiles(const std::vector<CameraCalibration>& rig) {
  std::vector<TextFile> files;
  for (const CameraCalibration& camera : rig)
    files.push_back({fileNameOf(camera) + ".xml", storageText(camera)});
  return files;
}

}  // namespace markerless_mocap
