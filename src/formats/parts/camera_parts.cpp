#include "formats/parts/camera_parts.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "text/number_text.h"

namespace markerless_mocap {

void throwFormatError(const std::string& where, const std::string& what) {
  throw std::invalid_argument(where + ": " + what);
}

void checkNumbers(const std::vector<double>& values, size_t wanted, const std::string& what,
                  const std::string& where) {
  if (values.size() != wanted)
    throwFormatError(where, what + " has " + std::to_string(values.size()) +
                                " numbers, allowed are " + std::to_string(wanted));
  for (const double value : values)
    if (!std::isfinite(value)) throwFormatError(where, what + " has a value that is not finite");
}

int pixelsFrom(double value, const std::string& key, const std::string& where) {
  if (!(value >= 1.0 && value <= 65536.0 && value == std::floor(value)))
    throwFormatError(where, "'" + key + "' is " + numberText(value) +
                                ", allowed are whole numbers from 1 to 65536");
  return int(value);
}

Eigen::Matrix3d cameraMatrixFrom(const std::vector<double>& values, const std::string& where) {
  checkNumbers(values, 9, "the camera matrix", where);
  Eigen::Matrix3d K = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
  if (!(K(0, 0) > 0.0 && K(1, 1) > 0.0) || K(1, 0) != 0.0 ||
      K.row(2) != Eigen::RowVector3d(0, 0, 1))
    throwFormatError(where, "the camera matrix is " + numbersText(values) +
                                ", allowed is fx skew cx 0 fy cy 0 0 1 with fx and fy above 0");
  return K;
}

Eigen::Matrix3d rotationFrom(const std::vector<double>& values, const std::string& where) {
  constexpr double kRounded = 0.01;
  if (values.size() == 3) {
    checkNumbers(values, 3, "the rotation", where);
    const Eigen::Vector3d v(values[0], values[1], values[2]);
    if (v.norm() == 0.0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
  }
  if (values.size() != 9)
    throwFormatError(where, "the rotation has " + std::to_string(values.size()) +
                                " numbers, allowed are 3 (rotation vector) or 9 (matrix)");
  checkNumbers(values, 9, "the rotation", where);
  const Eigen::Matrix3d R =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values.data());
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d nearest = svd.matrixU() * svd.matrixV().transpose();
  if (!((nearest - R).cwiseAbs().maxCoeff() < kRounded) || nearest.determinant() < 0.0)
    throwFormatError(where, "the rotation is no rotation matrix (determinant " +
                                numberText(R.determinant()) + ", allowed is 1)");
  return nearest;
}

Eigen::Vector3d rotationVector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Eigen::Isometry3d poseFromWorldToCamera(const Eigen::Matrix3d& rotation,
                                        const Eigen::Vector3d& translation) {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear() = rotation.transpose();
  T_world_camera.translation() = -(rotation.transpose() * translation);
  return T_world_camera;
}

std::vector<double> distortionOfLength(const CameraCalibration& camera, size_t wanted,
                                       const char* format) {
  checkNoFisheye(camera, format);
  std::vector<double> D = camera.D;
  for (size_t i = wanted; i < D.size(); ++i)
    if (D[i] != 0.0)
      throwFormatError(std::string(format) + ", camera '" + camera.name + "'",
                       "the lens has " + std::to_string(i + 1) +
                           " distortion coefficients, this format holds " + std::to_string(wanted));
  D.resize(wanted, 0.0);
  return D;
}

void checkNoFisheye(const CameraCalibration& camera, const char* format) {
  if (camera.lens == LensType::kFisheye)
    throwFormatError(std::string(format) + ", camera '" + camera.name + "'",
                     "the lens is a fisheye, this format holds none");
}

std::vector<double> fisheyeDistortion(const CameraCalibration& camera) {
  std::vector<double> D = camera.D;
  D.resize(4, 0.0);
  return D;
}

void checkNoSkew(const CameraCalibration& camera, const char* format) {
  if (camera.K(0, 1) != 0.0)
    throwFormatError(
        std::string(format) + ", camera '" + camera.name + "'",
        "the pixels have a skew of " + numberText(camera.K(0, 1)) + ", this format holds none");
}

std::vector<double> numbersIn(const std::string& text) {
  std::string blanks = text;
  for (char& c : blanks)
    if (c == ',' || c == ';') c = ' ';
  std::istringstream words(blanks);
  std::vector<double> numbers;
  for (double number; words >> number;) numbers.push_back(number);
  if (!words.eof()) numbers.clear();
  return numbers;
}

std::vector<std::string> cameraNamesOf(const std::vector<TextFile>& files) {
  std::set<std::string> stems, folders;
  std::vector<std::string> by_stem, by_folder;
  for (const TextFile& file : files) {
    const std::filesystem::path path = std::filesystem::absolute(file.path);
    by_stem.push_back(path.stem().string());
    by_folder.push_back(path.parent_path().filename().string());
    stems.insert(by_stem.back());
    folders.insert(by_folder.back());
  }
  return stems.size() < files.size() && folders.size() > 1 ? by_folder : by_stem;
}

std::string fileNameOf(const CameraCalibration& camera) {
  std::string name = camera.name;
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

}  // namespace markerless_mocap
