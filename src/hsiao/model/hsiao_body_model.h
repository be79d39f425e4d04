#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// Hsiao's parameters (Hsiao 2008, Table 3-2): centre of the torso (m, world), neck joint (m,
/// world; only its direction from the centre is used), spin about that direction (rad), then
/// theta_1 to theta_16 (rad).
constexpr int kHsiaoParameterCount = 23;
using HsiaoVector = Eigen::Matrix<double, kHsiaoParameterCount, 1>;
constexpr int kHsiaoCenter = 0, kHsiaoNeck = 3, kHsiaoSpin = 6;
/// Index of theta_k, k from 1 to 16.
constexpr int hsiaoTheta(int k) {
  return kHsiaoSpin + k;
}

/// Rigid segments. From the upper arms on, left ones are even and right ones odd.
enum HsiaoSegment {
  kTorsoSegment = 0,
  kHeadSegment,
  kUpperArmSegment,
  kForearmSegment = kUpperArmSegment + 2,
  kThighSegment = kForearmSegment + 2,
  kShankSegment = kThighSegment + 2,
  kHsiaoSegments = kShankSegment + 2
};

/// Frames of the segments in the world. The origin of a segment is its upper joint (of the torso:
/// its centre). At angle zero all axes are those of the torso, with hanging arms and legs.
struct HsiaoFrames {
  std::array<Eigen::Matrix3d, kHsiaoSegments> R;
  std::array<Eigen::Vector3d, kHsiaoSegments> p;
};

/// A point fixed to a segment.
struct HsiaoSegmentPoint {
  int segment;
  Eigen::Vector3d offset;  ///< metres, in the segment's frame
  Eigen::Vector3d inWorld(const HsiaoFrames& frames) const {
    return frames.p[segment] + frames.R[segment] * offset;
  }
};

/// Hsiao's human model with 23 parameters (Hsiao 2008, 3.2.1.2): waist, clavicles, wrists and
/// ankles are fixed. Immutable.
class HsiaoBodyModel {
 public:
  /// Takes all lengths from the zero pose of the model. Throws std::invalid_argument if a link is
  /// rotated in that pose, or if a hand, foot or head has no geometry.
  explicit HsiaoBodyModel(const BodyModel& model);

  /// Frames of all segments (Eq. 3-22 to 3-26). \param v kHsiaoParameterCount values
  void frames(const double* v, HsiaoFrames& out) const;

  /// Bones of each part by PartLabel (left limb 1, right limb 2), from the torso outward: torso
  /// from between the hips to the neck, head to its top, arms to the finger tips, legs to the toes.
  const std::vector<HsiaoSegmentPoint>& bones(PartLabel part) const { return bones_[size_t(part)]; }

  /// Origin of the model's root link in the frame of the torso, metres.
  const Eigen::Vector3d& root() const { return root_; }
  /// Distance from the centre of the torso to the neck, metres: half of L0.
  double halfTorso() const { return half_torso_; }
  /// For each link of the model: its segment, and its position in the segment's frame in the zero
  /// pose.
  const std::vector<HsiaoSegmentPoint>& links() const { return links_; }

 private:
  void addLimb(const BodyModel& model, const LinkPoses& zero, int side);
  void assignLinks(const BodyModel& model, const LinkPoses& zero);

  std::array<std::vector<HsiaoSegmentPoint>, kPartCount> bones_;
  std::vector<HsiaoSegmentPoint> links_;
  Eigen::Vector3d root_, axis_;
  double half_torso_ = 0.0;
  std::array<Eigen::Vector3d, kHsiaoSegments> joint_;  // in the parent segment's frame
};

}  // namespace markerless_mocap
