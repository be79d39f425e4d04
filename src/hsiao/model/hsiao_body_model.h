#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/hsiao/hsiao_options.h"
#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

/// H's parameters: torso centre (m, world), neck joint (m, world; only its direction from the
/// centre counts), spin about that direction (rad), then theta_1 to theta_16 (rad; Hsiao 2008,
/// Table 3-2).
constexpr int kHsiaoParameterCount = 23;
using HsiaoVector = Eigen::Matrix<double, kHsiaoParameterCount, 1>;
constexpr int kHsiaoCenter = 0, kHsiaoNeck = 3, kHsiaoSpin = 6;
/// Position of theta_k, k from 1 to 16, in the vector.
constexpr int hsiaoTheta(int k) {
  return kHsiaoSpin + k;
}

/// What moves rigidly. Left is even, right odd from the upper arms on.
enum HsiaoSegment {
  kTorsoSegment = 0,
  kHeadSegment,
  kUpperArmSegment,
  kForearmSegment = kUpperArmSegment + 2,
  kThighSegment = kForearmSegment + 2,
  kShankSegment = kThighSegment + 2,
  kHsiaoSegments = kShankSegment + 2
};

/// Frames of the segments in the world. A segment's origin is its upper joint (the torso's: its
/// centre); at angle zero its axes are the torso's, arms and legs hanging.
struct HsiaoFrames {
  std::array<Eigen::Matrix3d, kHsiaoSegments> R;
  std::array<Eigen::Vector3d, kHsiaoSegments> p;
};

/// A point that moves with a segment.
struct HsiaoSegmentPoint {
  int segment;
  Eigen::Vector3d offset;  ///< metres, in the segment's frame
  Eigen::Vector3d inWorld(const HsiaoFrames& frames) const {
    return frames.p[segment] + frames.R[segment] * offset;
  }
};

/// The 23-parameter profile of the body model (Hsiao 2008, 3.2.1.2): waist, clavicles, wrists and
/// ankles stay straight. Immutable.
class HsiaoBodyModel {
 public:
  /// Measures all lengths in the model's zero pose. Throws std::invalid_argument if that pose has
  /// a rotated link, or a hand, foot or head without shape.
  explicit HsiaoBodyModel(const BodyModel& model);

  /// Frames of all segments (Eq. 3-22 to 3-26). \param v kHsiaoParameterCount values
  void frames(const double* v, HsiaoFrames& out) const;

  /// Bones of each part by PartLabel (left limb 1, right 2), from the torso to the tip: torso from
  /// between the hips to the neck, head to its top, arms to the finger tips, legs to the toes.
  const std::vector<HsiaoSegmentPoint>& bones(PartLabel part) const { return bones_[size_t(part)]; }

  /// The model's root link seen from the torso's frame, metres.
  const Eigen::Vector3d& root() const { return root_; }
  /// Distance from torso centre to neck, metres: half of L0.
  double halfTorso() const { return half_torso_; }
  /// Segment that carries each link of the model, and the link's zero position in it.
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
