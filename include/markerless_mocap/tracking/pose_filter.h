#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/tracking/filter_options.h"

namespace markerless_mocap {

/// Takes the jitter out of a sequence of poses: a low-pass whose cutoff rises with speed (the one
/// Euro filter of Casiez, Roussel, Vogel 2012), on the root's position, the root's rotation and
/// every joint angle. It departs from the publication in two ways:
/// - What is smoothed is the departure from the motion so far (the low-passed speed that the filter
///   knows anyhow), not from the last output. Steady motion is not late at all; a change of
///   velocity dv leaves an error of no more than dv / (2 pi cutoff), which fades away.
/// - All of the body has one cutoff, that of its fastest coordinate. Errors of neighbouring joints
///   make up for each other in hands and feet and only do so while all are filtered alike.
/// With trend rate v and share a = 1 / (1 + 1 / (2 pi cutoff dt)):
///   v += a(trend cutoff) ((raw - last raw) / dt - v);  cutoff = lowest + beta max |v|
///   filtered = (last + v dt) + a(cutoff) (raw - (last + v dt))
/// Adds no waiting: a pose goes out with the instant that it came for. Not thread-safe.
class PoseFilter {
 public:
  /// \param model its joint limits are kept: angles within them stay within them
  /// \param options cutoff and beta are used; throws std::invalid_argument unless
  ///   they are in range
  PoseFilter(std::shared_ptr<const BodyModel> model, const FilterOptions& options);

  /// The pose with the jitter taken out; all but T_world_body and angles are the raw pose's. Equals
  /// the raw pose, and begins anew with it, where that does not follow the last one: it is the
  /// first, lost or re-initialised, or comes after a lost one, more than half a second later or not
  /// later at all, or a quarter turn of the root or of a joint away, which one instant's motion is
  /// not.
  /// \param stamp_ns capture time, nanoseconds
  /// \param raw throws std::invalid_argument if it is not lost and has not the model's angles
  BodyPose filtered(int64_t stamp_ns, const BodyPose& raw);

 private:
  /// Speed of each coordinate: m/s, then rad/s of the root in the world, then of each joint.
  struct Speed {
    Eigen::Vector3d position, rotation;
    Eigen::VectorXd angles;
  };
  struct State {
    int64_t stamp_ns;
    Eigen::Vector3d raw_position, position;
    Eigen::Quaterniond raw_rotation, rotation;
    Eigen::VectorXd raw_angles, angles;
    std::optional<Speed> speed;  ///< none after one instant
  };
  static State stateOf(int64_t stamp_ns, const BodyPose& raw);
  static Speed speedBetween(const State& last, const State& raw, double seconds);
  /// Nothing if `raw` does not follow the last pose.
  std::optional<Speed> speedTo(const State& raw, double seconds) const;
  void follow(const State& raw, const Speed& speed, double seconds);
  Eigen::VectorXd anglesWithinLimits() const;

  std::shared_ptr<const BodyModel> model_;
  double cutoff_hz_, beta_;
  std::optional<State> state_;  ///< none when there is no pose to follow
};

/// None if the options say that poses go out raw. Throws std::invalid_argument as PoseFilter.
std::optional<PoseFilter> makePoseFilter(std::shared_ptr<const BodyModel> model,
                                         const FilterOptions& options);

}  // namespace markerless_mocap
