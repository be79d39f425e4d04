#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace markerless_mocap {

/// The six parts of Hsiao 2008, 3.1.4. Arms and legs are numbered by position; the numbers do not
/// say which is left and which is right.
enum class PartLabel : uint8_t { kTorso = 0, kHead, kArm1, kArm2, kLeg1, kLeg2 };
constexpr int kPartCount = 6;
const char* toString(PartLabel label);

/// The parts that are not seen as words, for example "head, left arm not seen"; empty if all are.
/// \param seen of a pose, by PartLabel; limb 1 is the left one
std::string unseenParts(const std::array<bool, kPartCount>& seen);

/// One segmented part: the curve through its voxels, and how much of the part was found.
struct PartCurve {
  bool seen = false;
  /// Whether it was found from its extremity to the trunk. If not, a section of it may be merged
  /// with another part.
  bool whole = false;
  /// Not seen in this frame; the voxels at its position in an earlier frame have its label.
  bool carried = false;
  uint32_t voxel_count = 0;
  /// Points of the least-squares cubic spline h(s) (Eq. 3-16), world metres, evenly spaced along
  /// the curve, from the trunk to the extremity (torso: from the legs to the head).
  std::vector<Eigen::Vector3d> points;
  std::vector<double> site_values;  ///< s of each point; 0 at the first point, 1 at the last
};

enum class SegmentationStatus { kOk, kPartial, kInvalid };
const char* toString(SegmentationStatus status);

/// Result of `body_segmentation` for one hull.
struct BodyParts {
  SegmentationStatus status = SegmentationStatus::kInvalid;
  std::string reason;                       ///< message for the user unless kOk
  std::array<PartCurve, kPartCount> parts;  ///< by PartLabel
  std::vector<uint8_t> labels;              ///< PartLabel of each hull voxel, in the hull's order

  const PartCurve& part(PartLabel label) const { return parts[size_t(label)]; }
};

}  // namespace markerless_mocap
