#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/capture/body_state.h"

namespace markerless_mocap {

/// A person who walks in a circle about the world's origin and meanwhile swings the arms, waves,
/// spreads the arms and raises them, over and over. The lowest point of the body touches z = 0.
/// Smooth in time, within the joint limits, immutable.
class WalkAndWave {
 public:
  /// \param walk_radius metres, above 0 \param walk_speed metres per second
  WalkAndWave(std::shared_ptr<const BodyModel> model, double walk_radius, double walk_speed);
  /// \param seconds since the start of the motion
  BodyState at(double seconds) const;
  /// Length of one round of gestures, seconds.
  static double period();

 private:
  void setLegs(double stride_phase, Eigen::VectorXd& angles) const;
  void setArms(double seconds, double stride_phase, Eigen::VectorXd& angles) const;
  void setTrunk(double seconds, double stride_phase, Eigen::VectorXd& angles) const;
  void set(const std::string& joint, double angle, Eigen::VectorXd& angles) const;

  std::shared_ptr<const BodyModel> model_;
  double walk_radius_;
  double yaw_rate_;       ///< radians per second
  double hip_amplitude_;  ///< radians
};

}  // namespace markerless_mocap
