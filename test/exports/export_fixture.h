#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "body/body_fixture.h"
#include "exports/export_formats.h"

namespace markerless_mocap {

constexpr int64_t kStart = 1000000000000, kStep = 40000000;  // ns; 25 frames per second

/// Somebody who turns on a circle and moves every joint of the body within its limits, so that each
/// angle has another course.
class MovingPerson : public ::testing::Test {
 protected:
  MovingPerson() : body_(std::make_shared<const BodyModel>(human())) {}

  PersonFrame frameAt(int index) const {
    const double t = 0.04 * index;
    Eigen::Isometry3d T_world_root = Eigen::Isometry3d::Identity();
    T_world_root.translation() << 1.2 * std::cos(t), 1.2 * std::sin(t),
        0.9 + 0.03 * std::sin(5 * t);
    T_world_root.linear() = (Eigen::AngleAxisd(t + M_PI_2, Eigen::Vector3d::UnitZ()) *
                             Eigen::AngleAxisd(0.3 * std::sin(2 * t), Eigen::Vector3d::UnitY()) *
                             Eigen::AngleAxisd(0.2 * std::cos(3 * t), Eigen::Vector3d::UnitX()))
                                .toRotationMatrix();
    Eigen::VectorXd angles(body_->angleCount());
    for (const BodyJoint& joint : body_->joints()) {
      if (joint.angle_index < 0) continue;
      const double lower = std::max(joint.lower, -2.0), upper = std::min(joint.upper, 2.0);
      const double swing = std::sin(t * (1.0 + 0.1 * joint.angle_index) + joint.angle_index);
      angles[joint.angle_index] = 0.5 * (lower + upper) + 0.45 * (upper - lower) * swing;
    }
    PersonFrame frame;
    frame.stamp_ns = kStart + index * kStep;
    body_->forwardKinematics(T_world_root, angles, frame.T_world_link);
    frame.part_sigma_m = {0.002, 0.003, 0.004, 0.005, 0.006, 0.0004};
    return frame;
  }

  std::vector<PersonFrame> frames(int count) const {
    std::vector<PersonFrame> out;
    for (int f = 0; f < count; ++f) out.push_back(frameAt(f));
    return out;
  }
  PersonMotion motion(int count) const { return personMotion(body_, frames(count)); }

  void hide(PersonFrame* frame, const std::string& link) const {
    frame->T_world_link[size_t(body_->linkIndex(link))].matrix().setConstant(NAN);
  }
  void hideLeftArm(PersonFrame* frame) const {
    for (const char* link : {"l_y_clavicle", "l_r_clavicle", "l_y_shoulder", "l_p_shoulder",
                             "l_shoulder", "l_elbow", "l_wrist"})
      hide(frame, link);
  }

  const Eigen::Isometry3d& link(const PersonFrame& frame, const std::string& name) const {
    return frame.T_world_link[size_t(body_->linkIndex(name))];
  }

  std::shared_ptr<const BodyModel> body_;
};

inline std::vector<std::string> fieldsOf(const std::string& line, char separator) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == separator)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

inline std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Angle between two rotations, degrees.
inline double degreesBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::Quaterniond(a).angularDistance(Eigen::Quaterniond(b)) * 180.0 / M_PI;
}

}  // namespace markerless_mocap
