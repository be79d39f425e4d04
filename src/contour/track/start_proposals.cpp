#include "contour/track/start_proposals.h"

#include "contour/track/pose_from_pose_tree.h"

namespace markerless_mocap {

std::vector<ContourPose> StartProposals::of(int64_t stamp_ns, const FrameProducts& made,
                                            const ContourUrdfConverter& converter) {
  std::vector<ContourPose> poses;
  const BodyPose pose = initializer_->update(stamp_ns, made.parts, made.hull);
  initializer_error_ = pose.reason;
  if (pose.status != PoseStatus::kLost)
    poses.push_back(converter.poseOf(pose.T_world_body, pose.angles));
  if (const auto of_tree = poseFromPoseTree(made.tree)) poses.push_back(*of_tree);
  return poses;
}

}  // namespace markerless_mocap
