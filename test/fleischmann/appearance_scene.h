#pragma once

#include <cmath>
#include <string>

#include "body/body_fixture.h"
#include "fleischmann/fleischmann_body_model.h"
#include "fleischmann/model/fleischmann_body_shape.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

inline const BodyModel& sampleBody() {
  static const BodyModel body = human();
  return body;
}

/// A camera at `angle` on a ring of 4.2 m, 1.9 m high, that looks at the middle of the room.
inline Camera ringCamera(double angle, int width = 644, int height = 484,
                         std::vector<double> D = {}) {
  CameraCalibration c;
  c.name = "cam";
  c.width = width;
  c.height = height;
  const double focal = 0.9 * width;
  c.K << focal, 0, (width - 1) / 2.0, 0, focal, (height - 1) / 2.0, 0, 0, 1;
  c.D = std::move(D);
  const Eigen::Vector3d position(4.2 * std::cos(angle), 4.2 * std::sin(angle), 1.9);
  const Eigen::Vector3d z = (Eigen::Vector3d(0, 0, 1) - position).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  c.T_world_camera.linear() << x, z.cross(x), z;
  c.T_world_camera.translation() = position;
  return Camera(c);
}

inline CameraRig ringOfFour(std::vector<double> D = {}) {
  CameraRig rig;
  for (int i = 0; i < 4; ++i) rig.push_back(ringCamera((i + 0.5) * M_PI / 2, 644, 484, D));
  return rig;
}

/// Mid-step in the middle of the room, facing `yaw`.
inline FleischmannVector stride(double yaw = 0.4) {
  FleischmannVector v = FleischmannVector::Zero();
  v.segment<3>(kPelvisOrientation) << 0.02, 0.05, yaw;
  v.segment<3>(kPelvisPosition) << 0.1, -0.2, 0.93;
  v.segment<3>(kLeftHip) << 0.05, 0.5, 0.1;
  v[kLeftKnee] = 0.3;
  v.segment<3>(kRightHip) << 0.08, -0.3, -0.1;
  v[kRightKnee] = 0.6;
  v.segment<2>(kLeftClavicle) << 0.05, 0.1;
  v.segment<3>(kLeftShoulder) << 0.3, -0.4, 0.2;
  v[kLeftElbow] = 0.5;
  v.segment<2>(kRightClavicle) << -0.05, 0.05;
  v.segment<3>(kRightShoulder) << 0.4, 0.6, -0.3;
  v[kRightElbow] = 0.7;
  v.segment<2>(kSpine) << 0.1, -0.05;
  v.segment<3>(kHeadTurn) << 0.05, 0.1, 0.3;
  return v;
}

}  // namespace markerless_mocap
