#include "nodes/pose_fitting/tracker_update.h"

#include <exception>
#include <stdexcept>
#include <utility>

#include "camera/camera_difference.h"
#include "nodes/common/camera_pixels.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

cv::Mat maskOf(const FittingMessages& input, size_t camera, const Camera& seen_by) {
  const bool is_read = camera < input.pixels.size() && !input.pixels[camera].empty();
  return is_read ? maskOfCamera(seen_by, input.pixels[camera])
                 : maskOfCamera(seen_by, *input.masks[camera]);
}

/// A mask that cannot be used is left out; if none can, the first reason is thrown.
std::vector<cv::Mat> masksOf(const FittingMessages& input, const CameraRig& rig) {
  std::vector<cv::Mat> masks(input.masks.size());
  std::string fault;
  bool any = false;
  for (size_t i = 0; i < masks.size(); ++i) {
    if (!input.masks[i]) continue;
    try {
      masks[i] = maskOf(input, i, rig[i]);
      any = true;
    } catch (const std::exception& error) {
      if (fault.empty()) fault = error.what();
    }
  }
  if (!any && !fault.empty()) throw std::invalid_argument(fault);
  return masks;
}

cv::Mat imageOrNothing(const CameraImage& image) {
  try {
    return image.mat();
  } catch (const std::invalid_argument&) {
    return cv::Mat();
  }
}

/// \param required if not, images that cannot be read are left out
std::vector<cv::Mat> imagesOf(const FittingMessages& input, bool required) {
  std::vector<cv::Mat> images(input.masks.size());
  for (size_t i = 0; i < input.images.size(); ++i)
    images[i] = required ? input.images[i].mat() : imageOrNothing(input.images[i]);
  return images;
}

}  // namespace

cv::Mat maskOrNothing(const FittingMessages& input, size_t camera) {
  if (!input.masks[camera]) return cv::Mat();
  try {
    return maskOf(input, camera, (*input.rig)[camera]);
  } catch (const std::exception&) {  // told when it is used
    return cv::Mat();
  }
}

std::vector<Eigen::Vector3d> jointsOf(const BodyModel& model, const BodyPose& pose) {
  LinkPoses T_world_link;
  model.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
  return markerPositions(model, T_world_link);
}

FittingMessages withoutChangedCameras(FittingMessages input, const CameraRig& rig) {
  if (input.rig.get() == &rig) return input;
  for (size_t i = 0; i < input.masks.size(); ++i) {
    if (!seeDifferently((*input.rig)[i], rig[i])) continue;
    input.masks[i].reset();
    if (i < input.images.size()) input.images[i] = {};
  }
  return input;
}

BodyPose updated(BodyTracker& tracker, const FittingMessages& input, LiveProducts& products,
                 int64_t stamp_ns, bool images_required,
                 const std::function<void(const BodyPose&)>& report) {
  const std::vector<cv::Mat> masks = masksOf(input, *input.rig);
  const std::vector<cv::Mat> images = imagesOf(input, images_required);
  LiveProducts::Source source = products.at(input.header.stamp);
  BodyPose pose;
  bool is_reported = false;
  const auto take = [&](const BodyPose& found) {
    if (std::exchange(is_reported, true)) return;
    pose = found;
    if (pose.status == PoseStatus::kLost) pose.reason += source.lack();
    if (report) report(pose);
  };
  take(tracker.update(
      {stamp_ns, masks, images, source, input.behind, input.images_awaited, input.later_s, take}));
  return pose;
}

}  // namespace markerless_mocap
