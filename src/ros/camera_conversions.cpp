#include "ros/camera_conversions.h"

#include <sensor_msgs/distortion_models.h>
#include <tf2_eigen/tf2_eigen.h>

#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using Matrix3RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw std::invalid_argument("camera_info of " + name + " " + what);
}

void checkModel(const std::string& name, const sensor_msgs::CameraInfo& info) {
  namespace models = sensor_msgs::distortion_models;
  const std::string& model = info.distortion_model;
  if (!model.empty() && model != models::PLUMB_BOB && model != models::RATIONAL_POLYNOMIAL &&
      lensTypeOf(model) != LensType::kFisheye)
    refuse(name, "has the distortion model \"" + model +
                     "\", allowed are plumb_bob, rational_polynomial and equidistant");
  if (info.binning_x > 1 || info.binning_y > 1) refuse(name, "has binning, allowed is none");
  const auto& roi = info.roi;
  const bool whole = (roi.width == 0 || roi.width == info.width) &&
                     (roi.height == 0 || roi.height == info.height) && roi.x_offset == 0 &&
                     roi.y_offset == 0;
  if (!whole) refuse(name, "has a region of interest, allowed is the whole image");
}

Eigen::Isometry3d poseOf(const std::string& name, const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const auto& t = transform.translation;
  if (!(std::abs(norm - 1.0) < 1e-3) || !std::isfinite(t.x + t.y + t.z))
    throw std::invalid_argument("transform of " + name +
                                " is not a rigid one: its quaternion has length " +
                                std::to_string(norm) + ", allowed is 1, and finite translation");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation() = Eigen::Vector3d(t.x, t.y, t.z);
  return pose;
}

}  // namespace

int64_t nanosecondsOf(const ros::Time& stamp) {
  return static_cast<int64_t>(stamp.toNSec());
}

ros::Time rosTime(int64_t nanoseconds) {
  return ros::Time().fromNSec(static_cast<uint64_t>(nanoseconds));
}

LensType lensTypeOf(const std::string& distortion_model) {
  const bool fisheye = distortion_model == sensor_msgs::distortion_models::EQUIDISTANT ||
                       distortion_model == "fisheye";  // of older drivers
  return fisheye ? LensType::kFisheye : LensType::kPolynomial;
}

CameraCalibration calibrationFromMessage(const std::string& name,
                                         const sensor_msgs::CameraInfo& info,
                                         const geometry_msgs::Transform& T_world_camera) {
  checkModel(name, info);
  CameraCalibration calibration;
  calibration.name = name;
  calibration.width = static_cast<int>(info.width);
  calibration.height = static_cast<int>(info.height);
  calibration.K = Eigen::Map<const Matrix3RowMajor>(info.K.data());
  calibration.D = info.D;
  calibration.lens = lensTypeOf(info.distortion_model);
  calibration.T_world_camera = poseOf(name, T_world_camera);
  calibration.validate();
  return calibration;
}

sensor_msgs::CameraInfo messageFromCalibration(const CameraCalibration& calibration) {
  namespace models = sensor_msgs::distortion_models;
  sensor_msgs::CameraInfo info;
  info.width = static_cast<uint32_t>(calibration.width);
  info.height = static_cast<uint32_t>(calibration.height);
  const bool fisheye = calibration.lens == LensType::kFisheye;
  info.distortion_model = fisheye                    ? models::EQUIDISTANT
                          : calibration.D.size() > 5 ? models::RATIONAL_POLYNOMIAL
                                                     : models::PLUMB_BOB;
  info.D = calibration.D;
  if (info.D.empty()) info.D.assign(fisheye ? 4 : 5, 0.0);
  Eigen::Map<Matrix3RowMajor>(info.K.data()) = calibration.K;
  Eigen::Map<Matrix3RowMajor>(info.R.data()).setIdentity();
  Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> P(info.P.data());
  P << calibration.K, Eigen::Vector3d::Zero();
  return info;
}

std::string opticalFrame(const std::string& camera) {
  return camera + "_optical";
}

tf2_msgs::TFMessage transformsOf(const std::vector<CameraCalibration>& cameras,
                                 const ros::Time& stamp, const std::string& world_frame) {
  tf2_msgs::TFMessage message;
  for (const CameraCalibration& camera : cameras) {
    message.transforms.push_back(tf2::eigenToTransform(camera.T_world_camera));
    message.transforms.back().header.stamp = stamp;
    message.transforms.back().header.frame_id = world_frame;
    message.transforms.back().child_frame_id = opticalFrame(camera.name);
  }
  return message;
}

}  // namespace markerless_mocap
