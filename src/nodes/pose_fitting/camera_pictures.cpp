#include "nodes/pose_fitting/camera_pictures.h"

#include <stdexcept>
#include <utility>

#include "nodes/common/camera_pixels.h"
#include "nodes/common/end_process.h"
#include "nodes/common/publish_shared.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kQueue = 8;
constexpr size_t kMaxImages = 24;  // per camera; it covers the delay of the stages
constexpr size_t kMaxWaiting = 2;  // frame sets

}  // namespace

CameraPictures::CameraPictures(ros::NodeHandle& handle, std::string name, Source source,
                               StageStatus* status, Make make)
    : name_(std::move(name)),
      source_(std::move(source)),
      make_(std::move(make)),
      subscribers_(source_.cameras.size()),
      images_(source_.cameras.size(), kMaxImages),
      queue_(kMaxWaiting),
      inputs_(handle, status) {
  for (const std::string& camera : source_.cameras)
    publishers_.push_back(handle.advertise<sensor_msgs::Image>(camera + "/" + name_, 2));
  worker_ = std::thread([this] { runOrEndProcess("pictures " + name_, [this] { work(); }); });
}

CameraPictures::~CameraPictures() {
  queue_.close();
  worker_.join();
}

bool CameraPictures::isWanted() {
  bool wanted = false;
  for (size_t i = 0; i < publishers_.size(); ++i) {
    const bool looked_at = publishers_[i].getNumSubscribers() > 0;
    wanted = wanted || looked_at;
    if (!looked_at && subscribers_[i]) {
      subscribers_[i].shutdown();
      subscribers_[i] = ros::Subscriber();
    }
    if (looked_at && source_.reads_images && !subscribers_[i])
      subscribers_[i] =
          inputs_.subscribeToImages(source_.cameras[i], source_.transport, kQueue,
                                    StageInputs::kOptional, [this, i](const CameraImage& image) {
                                      const std::lock_guard<std::mutex> lock(mutex_);
                                      images_.add(i, nanosecondsOf(image.header().stamp), image);
                                    });
  }
  return wanted;
}

void CameraPictures::work() {
  while (const std::optional<FittedScene> scene = queue_.take())
    for (size_t i = 0; scene->rig && i < scene->masks.size() && i < scene->rig->size(); ++i)
      if (scene->masks[i] && publishers_[i].getNumSubscribers() > 0) publish(i, *scene);
}

CameraImage CameraPictures::imageOf(size_t camera, const sensor_msgs::Image& mask) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return images_.take(camera, nanosecondsOf(mask.header.stamp));
}

void CameraPictures::publish(size_t camera, const FittedScene& scene) {
  const sensor_msgs::Image& mask = *scene.masks[camera];
  // Of an image that cannot be read, silhouette tells why.
  const cv::Mat image = imageOfCamera((*scene.rig)[camera], imageOf(camera, mask));
  cv::Mat picture;
  try {
    picture = make_(scene, camera, image);
  } catch (const std::invalid_argument&) {  // a mask that fitting has left out, too
  }
  if (!picture.empty()) publishShared(publishers_[camera], messageFromMat(picture, mask.header));
}

}  // namespace markerless_mocap
