#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Parts of a segmented body: torso, head, left_arm, right_arm, left_leg, right_leg.
constexpr int kTruePartCount = 6;
const std::array<const char*, kTruePartCount>& truePartNames();

/// Names of the points that the true parts are made of: the joints of the measure, hand_tip and
/// foot_tip of either side, head_top.
const std::vector<std::string>& partTruthNames();

/// Where the parts of one person are at one instant, by the person's own joints. A point belongs to
/// the part whose bone's flesh is nearest: bones are lines of a thickness that goes with the leg's
/// length, and where exactly a shoulder ends is a convention.
class PartTruth {
 public:
  /// \param points columns by partTruthNames(), metres. Throws std::invalid_argument if one is not
  ///   finite or the count is another.
  explicit PartTruth(const Eigen::Matrix3Xd& points);

  /// Index into truePartNames().
  uint8_t partAt(const Eigen::Vector3d& point) const;
  /// Whether a point lies in a forearm, hand, shank or foot.
  bool isDistal(const Eigen::Vector3d& point) const;
  /// Metres from a point to the bones that are a part's axis: the spine from the pelvis to the
  /// thorax, thorax to the top of the head, shoulder to hand, hip to foot.
  double toAxis(const Eigen::Vector3d& point, int part) const;

 private:
  struct Bone {
    Eigen::Vector3d a, b;
    double radius;  ///< metres
    uint8_t part;
    bool distal, axis;
  };
  const Bone& nearestBone(const Eigen::Vector3d& point) const;

  std::vector<Bone> bones_;
};

}  // namespace markerless_mocap
