#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace markerless_mocap {

/// The six parts of Hsiao 2008, 3.1.4. Left and right are not told apart here: arm 1 and arm 2
/// (leg 1, leg 2) are numbered by place, which does not tell left from right.
enum class PartLabel : uint8_t { kTorso = 0, kHead, kArm1, kArm2, kLeg1, kLeg2 };
constexpr int kPartCount = 6;
const char* toString(PartLabel label);

/// One extracted part: its voxels' curve and how much of it there is.
struct PartCurve {
  bool seen = false;
  /// Whether it is seen from its tip to where it joins the trunk; else a piece of it may be merged
  /// with another part.
  bool whole = false;
  /// Not seen, but voxels are labelled as it where it was a moment before.
  bool carried = false;
  uint32_t voxel_count = 0;
  /// Points of the least-squares cubic spline h(s) (Eq. 3-16), world metres, evenly spaced along
  /// the curve, from the end at the torso to the tip (torso: from the legs to the head).
  std::vector<Eigen::Vector3d> points;
  std::vector<double> site_values;  ///< s of each point, 0 at the first, 1 at the last
};

enum class SegmentationStatus { kOk, kPartial, kInvalid };
const char* toString(SegmentationStatus status);

/// What `body_segmentation` makes of one hull.
struct BodyParts {
  SegmentationStatus status = SegmentationStatus::kInvalid;
  std::string reason;                       ///< one sentence unless kOk
  std::array<PartCurve, kPartCount> parts;  ///< by PartLabel
  std::vector<uint8_t> labels;              ///< PartLabel of each hull voxel, in the hull's order

  const PartCurve& part(PartLabel label) const { return parts[size_t(label)]; }
};

}  // namespace markerless_mocap
