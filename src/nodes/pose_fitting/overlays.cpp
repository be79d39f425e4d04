#include "nodes/pose_fitting/overlays.h"

#include <utility>

#include "evaluation/body_overlay.h"
#include "nodes/common/camera_pixels.h"
#include "nodes/common/end_process.h"
#include "nodes/common/publish_shared.h"
#include "ros/body_markers.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 8;
constexpr size_t kMaxImages = 24;  // per camera; it covers the delay of the stages
constexpr size_t kMaxWaiting = 2;  // frame sets

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

Overlays::Overlays(ros::NodeHandle& handle, std::vector<std::string> cameras, std::string transport,
                   StageStatus* status)
    : cameras_(std::move(cameras)),
      transport_(std::move(transport)),
      subscribers_(cameras_.size()),
      images_(cameras_.size(), kMaxImages),
      queue_(kMaxWaiting),
      inputs_(handle, status) {
  for (const std::string& camera : cameras_)
    publishers_.push_back(handle.advertise<sensor_msgs::Image>(camera + "/overlay", 2));
  worker_ = std::thread([this] { runOrEndProcess("drawing overlays", [this] { work(); }); });
}

Overlays::~Overlays() {
  queue_.close();
  worker_.join();
}

bool Overlays::isWanted() {
  bool wanted = false;
  for (size_t i = 0; i < cameras_.size(); ++i) {
    const bool looked_at = publishers_[i].getNumSubscribers() > 0;
    wanted = wanted || looked_at;
    if (!looked_at && subscribers_[i]) {
      subscribers_[i].shutdown();
      subscribers_[i] = ros::Subscriber();
    }
    if (looked_at && !subscribers_[i])
      subscribers_[i] = inputs_.subscribeToImages(
          cameras_[i], transport_, kQueue, StageInputs::kOptional, [this, i](const CameraImage& c) {
            const std::lock_guard<std::mutex> lock(mutex_);
            images_.add(i, nanosecondsOf(c.header().stamp), c);
          });
  }
  return wanted;
}

void Overlays::work() {
  while (const std::optional<OverlayScene> scene = queue_.take())
    for (size_t i = 0; scene->rig && i < scene->masks.size() && i < scene->rig->size(); ++i)
      if (scene->masks[i] && publishers_[i].getNumSubscribers() > 0) draw(i, *scene);
}

CameraImage Overlays::imageOf(size_t camera, const sensor_msgs::Image& mask) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return images_.take(camera, nanosecondsOf(mask.header.stamp));
}

void Overlays::draw(size_t camera, const OverlayScene& scene) {
  const Camera& view = (*scene.rig)[camera];
  const CameraImage image = imageOf(camera, *scene.masks[camera]);
  const cv::Mat pixels = imageOfCamera(view, image);
  if (pixels.empty()) return;  // silhouette tells why
  const BodyModel& model = *scene.body->model;
  LinkPoses T_world_link;
  std::vector<OverlayPart> parts;
  if (scene.pose.status != PoseStatus::kLost) {
    model.forwardKinematics(scene.pose.T_world_body, scene.pose.angles, T_world_link);
    parts = partsToDraw(model, scene.pose);
  }
  const cv::Mat mask = maskOfCamera(view, *scene.masks[camera]);
  const std::string text = view.name() + ": " + poseSummary(scene.pose);
  const cv::Mat picture = bodyOverlay(view, pixels, mask, model, T_world_link, parts, text);
  publishShared(publishers_[camera], messageFromMat(picture, image.header()));
}

}  // namespace markerless_mocap
