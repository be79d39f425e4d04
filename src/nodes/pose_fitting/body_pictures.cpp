#include "nodes/pose_fitting/body_pictures.h"

#include "evaluation/body_overlay.h"
#include "markerless_mocap/region/person_mask.h"
#include "nodes/common/camera_pixels.h"
#include "ros/body_markers.h"
#include "tracking/part_of_joint.h"

namespace markerless_mocap {
namespace {

cv::Scalar bgrOf(const std_msgs::ColorRGBA& color) {
  return cv::Scalar(color.b, color.g, color.r) * 255.0;
}

/// The parts that are seen, in the colours of the markers.
std::vector<OverlayPart> partsToDraw(const BodyModel& model, const BodyPose& pose) {
  std::vector<OverlayPart> parts;
  for (size_t part = 0; part < kPartCount; ++part) {
    if (!pose.part_seen[part]) continue;
    std::vector<bool> shown(model.links().size());
    for (size_t link = 0; link < shown.size(); ++link)
      shown[link] = partOfLink(model, int(link)) == PartLabel(part);
    parts.push_back({shown, bgrOf(colorOfDeviation(pose.part_sigma_m[part]))});
  }
  return parts;
}

}  // namespace

cv::Mat overlayOf(const FittedScene& scene, size_t camera, const cv::Mat& image) {
  if (image.empty()) return {};
  const Camera& view = (*scene.rig)[camera];
  const BodyModel& model = *scene.body->model;
  LinkPoses T_world_link;
  std::vector<OverlayPart> parts;
  if (scene.pose.status != PoseStatus::kLost) {
    model.forwardKinematics(scene.pose.T_world_body, scene.pose.angles, T_world_link);
    parts = partsToDraw(model, scene.pose);
  }
  return bodyOverlay(view, image, maskOfCamera(view, *scene.masks[camera]), model, T_world_link,
                     parts, view.name() + ": " + poseSummary(scene.pose));
}

cv::Mat personMaskOf(const FittedScene& scene, size_t camera, const cv::Mat& image) {
  if (scene.pose.status == PoseStatus::kLost) return {};
  const Camera& view = (*scene.rig)[camera];
  return personMask(view, *scene.body->model, scene.pose, maskOfCamera(view, *scene.masks[camera]),
                    image);
}

}  // namespace markerless_mocap
