#include "contour/orientation_sampler.h"

#include <utility>

namespace markerless_mocap {
namespace {

// A posture differs if the mean displacement of the joints is larger than this. Repeated postures
// would only give more weight to the errors of the body shape.
constexpr double kMinPostureChange = 0.04;  // metres

constexpr double kPoseError = 0.04;  // metres, of the outline of a fitted body, in a wrong rig

}  // namespace

OrientationSampler::OrientationSampler(const CameraRig& rig, const ContourOptions& contour,
                                       const TrackedBody& body, size_t max_samples)
    : observer_(rig, contour),
      converter_(body.model),
      body_(body.shape),
      max_samples_(max_samples) {}

void OrientationSampler::add(const std::vector<cv::Mat>& images, const std::vector<cv::Mat>& masks,
                             const BodyPose& found) {
  if (found.status == PoseStatus::kLost) return;
  const ContourPose pose = converter_.poseOf(found.T_world_body, found.angles);
  if (!isAnotherPosture(pose) || postures_++ % stride_ != 0) return;
  const RegionFrame frame(images, masks);
  observer_.learn(frame, body_, pose);
  samples_.push_back({observer_.observeNear(frame, body_, pose, kPoseError).seen, pose});
  if (samples_.size() > max_samples_) thinOut();
}

bool OrientationSampler::isAnotherPosture(const ContourPose& pose) {
  const Eigen::Matrix3Xd points = body_.points(pose);
  if (postures_ > 0 && (points - last_).colwise().norm().mean() < kMinPostureChange) return false;
  last_ = points;
  return true;
}

void OrientationSampler::thinOut() {
  stride_ *= 2;
  std::vector<OrientationSample> kept;
  for (size_t i = 0; i < samples_.size(); i += 2) kept.push_back(std::move(samples_[i]));
  samples_ = std::move(kept);
}

}  // namespace markerless_mocap
