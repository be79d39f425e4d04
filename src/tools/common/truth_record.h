#pragma once

#include <string>
#include <vector>

#include "evaluation/angle_error.h"
#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// Ground truth of a person in a bag.
struct TruthRecord {
  std::string world_frame;
  JointTrack joints;               ///< /ground_truth/joints
  std::vector<AngleFrame> angles;  ///< /ground_truth/joint_states; may be empty
};

/// Throws std::runtime_error if the bag cannot be read, has no /ground_truth/joints, or has
/// inconsistent messages.
TruthRecord readTruth(const std::string& path);

}  // namespace markerless_mocap
