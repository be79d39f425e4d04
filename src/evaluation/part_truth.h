#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Parts of a segmented body.
struct TruePart {
  enum Id : uint8_t { kTorso, kHead, kLeftArm, kRightArm, kLeftLeg, kRightLeg };
};
constexpr int kTruePartCount = 6;

/// Names of the points from which true parts are computed: the joints of the error measure,
/// hand_tip and foot_tip of both sides, head_top.
const std::vector<std::string>& partTruthNames();

/// True parts of one person at one time, from the person's joints. A point belongs to the part with
/// the nearest bone surface. Bones are line segments with a radius proportional to the leg's
/// length. The exact border at a shoulder is a convention.
class PartTruth {
 public:
  /// \param points columns by partTruthNames(), metres. Throws std::invalid_argument if a point is
  ///   not finite or the number of columns is wrong.
  explicit PartTruth(const Eigen::Matrix3Xd& points);

  /// Part at a point (world metres), as a TruePart::Id.
  uint8_t partAt(const Eigen::Vector3d& point) const;
  /// Whether a point lies in a forearm, hand, shank or foot.
  bool isDistal(const Eigen::Vector3d& point) const;
  /// Distance of a point from the axis of a part, metres: the spine from pelvis to thorax, thorax
  /// to the top of the head, shoulder to hand, or hip to foot.
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
