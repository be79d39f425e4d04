#pragma once

#include <string>
#include <vector>

#include "evaluation/angle_error.h"
#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// What a bag says is true about a person.
struct TruthRecord {
  std::string world_frame;
  JointTrack joints;               ///< /ground_truth/joints
  std::vector<AngleFrame> angles;  ///< /ground_truth/joint_states; may be empty
};

/// Throws std::runtime_error with one sentence: the bag cannot be read, has no
/// /ground_truth/joints, or messages that contradict each other.
TruthRecord readTruth(const std::string& path);

/// A joint's name without the id that REP-155 appends: "l_elbow_person1" is "l_elbow".
std::string withoutId(const std::string& name);

}  // namespace markerless_mocap
