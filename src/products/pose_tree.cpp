#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

const char* toString(TreePart part) {
  constexpr const char* kNames[] = {"none",      "torso",    "neck",     "left_arm",
                                    "right_arm", "left_leg", "right_leg"};
  return kNames[size_t(part)];
}

const char* toString(Extremity extremity) {
  constexpr const char* kNames[] = {"head", "left_hand", "right_hand", "left_foot", "right_foot"};
  return kNames[size_t(extremity)];
}

const char* toString(TreeJoint joint) {
  constexpr const char* kNames[] = {"neck",    "l_shoulder", "r_shoulder", "l_elbow", "r_elbow",
                                    "l_wrist", "r_wrist",    "l_hip",      "r_hip",   "l_knee",
                                    "r_knee",  "l_ankle",    "r_ankle"};
  return kNames[size_t(joint)];
}

const char* toString(TreeStatus status) {
  constexpr const char* kNames[] = {"ok",       "no_skeleton", "not_a_person",  "too_few_branches",
                                    "no_torso", "low_rank",    "sides_unknown", "uncertain"};
  return kNames[size_t(status)];
}

}  // namespace markerless_mocap
