#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "evaluation/joint_track.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

constexpr int64_t kFrame = 40000000;  // 25 frames per second, ns

/// The fifteen markers of somebody who walks in a circle of 1 m, 1 m in 1 s, and swings his arms.
inline JointTrack walkingTrack(int frames, double late_seconds = 0.0) {
  const std::vector<Eigen::Vector3d> rest{
      {0, 0, 1.0},    {0, 0, 1.5},     {0, 0, 1.65},      {0, 0.2, 1.45},  {0.1, 0.25, 1.2},
      {0.3, 0.25, 1}, {0, -0.2, 1.45}, {0.1, -0.25, 1.2}, {0.3, -0.25, 1}, {0, 0.1, 0.95},
      {0, 0.1, 0.5},  {0, 0.1, 0.1},   {0, -0.1, 0.95},   {0, -0.1, 0.5},  {0, -0.1, 0.1}};
  JointTrack track;
  track.names = markerNames();
  for (int f = 0; f < frames; ++f) {
    const double t = f * double(kFrame) * 1e-9 - late_seconds;
    const Eigen::AngleAxisd turn(t, Eigen::Vector3d::UnitZ());
    Eigen::Matrix3Xd points(3, rest.size());
    for (size_t i = 0; i < rest.size(); ++i) {
      const bool wrist = markerNames()[i].find("wrist") != std::string::npos;
      const Eigen::Vector3d swing(wrist ? 0.2 * std::sin(3 * t) * rest[i].y() / 0.25 : 0.0, 0, 0);
      points.col(i) = turn * (rest[i] + swing + Eigen::Vector3d(0, -1, 0));
    }
    track.add(1000000000 + f * kFrame, points);
  }
  return track;
}

/// Left and right exchanged in one frame.
inline void swapSides(JointTrack* track, size_t frame) {
  for (size_t i = 0; i < track->names.size(); ++i)
    if (track->names[i].rfind("l_", 0) == 0)
      track->positions[frame].col(i).swap(
          track->positions[frame].col(track->indexOf("r_" + track->names[i].substr(2))));
}

inline void lose(JointTrack* track, size_t frame) {
  track->positions[frame].setConstant(NAN);
}

}  // namespace markerless_mocap
