#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/tracking/filter_options.h"

namespace markerless_mocap {

/// Removes jitter from a sequence of poses: a low-pass filter whose cutoff frequency rises with
/// speed (the 1-euro filter of Casiez, Roussel, Vogel 2012). It filters the root's position, the
/// root's rotation and every joint angle. It differs from the publication in two ways:
/// - The prediction from the low-passed velocity is filtered, not the last output. Motion at
///   constant velocity is therefore not delayed. A change of velocity dv causes an error of at most
///   dv / (2 pi cutoff), which decays.
/// - All coordinates share one cutoff, that of the fastest. Errors of neighbouring joints often
///   compensate each other at hands and feet. They do so only as long as all joints are filtered
///   alike.
/// With velocity v and smoothing factor a(f) = 1 / (1 + 1 / (2 pi f dt)):
///   v += a(velocity cutoff) ((raw - last raw) / dt - v);  cutoff = options.cutoff + beta max |v|
///   filtered = (last + v dt) + a(cutoff) (raw - (last + v dt))
/// The filter never waits for later poses. Not thread-safe.
class PoseFilter {
 public:
  /// \param model body of the poses; its joint limits are respected: angles within them stay within
  ///   them
  /// \param options cutoff and beta are used. Throws std::invalid_argument if one is out of range
  PoseFilter(std::shared_ptr<const BodyModel> model, const FilterOptions& options);

  /// The filtered pose. Only T_world_body and angles differ from the raw pose. The filter restarts
  /// and returns the raw pose unchanged if the raw pose is the first one, is lost or
  /// re-initialised, or follows a lost one. The same holds if its stamp is not later than the last
  /// one or more than 0.5 s later, or if the root or a joint has turned by more than 90 degrees.
  /// \param stamp_ns capture time, nanoseconds
  /// \param raw throws std::invalid_argument if it is not lost and the number of its angles is not
  ///   that of the model
  BodyPose filtered(int64_t stamp_ns, const BodyPose& raw);

 private:
  /// Velocity of each coordinate: root position [m/s], root rotation in the world [rad/s], joint
  /// angles [rad/s].
  struct Speed {
    Eigen::Vector3d position, rotation;
    Eigen::VectorXd angles;
  };
  struct State {
    int64_t stamp_ns;
    Eigen::Vector3d raw_position, position;
    Eigen::Quaterniond raw_rotation, rotation;
    Eigen::VectorXd raw_angles, angles;
    std::optional<Speed> speed;  ///< empty after one frame
  };
  static State stateOf(int64_t stamp_ns, const BodyPose& raw);
  static Speed speedBetween(const State& last, const State& raw, double seconds);
  /// Empty if `raw` does not continue the motion of the last pose.
  std::optional<Speed> speedTo(const State& raw, double seconds) const;
  void follow(const State& raw, const Speed& speed, double seconds);
  Eigen::VectorXd anglesWithinLimits() const;

  std::shared_ptr<const BodyModel> model_;
  double cutoff_hz_, beta_;
  std::optional<State> state_;  ///< empty if the last pose was lost
};

/// Empty if the filter is disabled. Throws std::invalid_argument as PoseFilter.
std::optional<PoseFilter> makePoseFilter(std::shared_ptr<const BodyModel> model,
                                         const FilterOptions& options);

}  // namespace markerless_mocap
