#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// A person at one time.
struct PersonFrame {
  int64_t stamp_ns = 0;
  LinkPoses T_world_link;    ///< in the order of the body's links; NaN: not seen
  std::vector<bool> filled;  ///< per link: computed by fillGaps()
  /// Expected errors (standard deviations) of the ends of torso, head, left and right arm, left and
  /// right leg, metres; NaN: unknown.
  std::array<double, 6> part_sigma_m{};

  bool hasPose() const { return !T_world_link.empty() && T_world_link[0].matrix().allFinite(); }
  bool isKnown(int link) const { return T_world_link[size_t(link)].matrix().allFinite(); }
};

/// The motion of one person, from the first to the last frame with a pose.
struct PersonMotion {
  std::shared_ptr<const BodyModel> body;
  std::vector<PersonFrame> frames;  ///< ascending stamps; at least one
  double start_s = 0.0;             ///< from the first frame of the recording to frames[0]
  double fill_s = 0.0;              ///< longest gap that was filled; 0: none

  /// Seconds since the first frame.
  double seconds(size_t frame) const {
    return 1e-9 * double(frames[frame].stamp_ns - frames[0].stamp_ns);
  }
  /// Mean time between frames, seconds; 1/30 if there is only one.
  double frameTime() const;
  /// Largest difference of a stamp from equal steps of frameTime(), seconds.
  double irregularity() const;
};

/// Leaves out what comes before the first and after the last pose. Frames that are missing from
/// the recording, by the median time between frames, are added without a pose.
/// \param frames ascending stamps; frames without a pose may have no links
/// Throws std::runtime_error if no frame has a pose, std::invalid_argument if stamps do not ascend
/// or a frame with a pose has another number of links than the body.
PersonMotion personMotion(std::shared_ptr<const BodyModel> body, std::vector<PersonFrame> frames);

/// Fills what is not known between two frames that are at most `seconds` apart: the root's place
/// and rotation and each joint angle by cubic Hermite splines through the frames on both sides.
void fillGaps(double seconds, PersonMotion* motion);

/// Angle of a revolute joint, radians, -pi to pi; NaN: not seen.
double jointAngle(const BodyJoint& joint, const PersonFrame& frame);

/// Largest distance of a joint from where the body's lengths put it, seen from its parent, metres.
/// It is 0 unless the transforms are of another body, or the body was measured anew in between.
double misfit(const PersonMotion& motion);

}  // namespace markerless_mocap
