#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/tracking/tracked_body.h"
#include "nodes/common/catch_up_queue.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/common/stamp_cache.h"

namespace markerless_mocap {

/// The pose of one time, and what it was fitted to.
struct FittedScene {
  std::shared_ptr<const TrackedBody> body;
  BodyPose pose;
  std::shared_ptr<const CameraRig> rig;
  std::vector<sensor_msgs::ImageConstPtr> masks;  ///< by camera; null where missing
};

/// One picture for each camera and time, on <camera>/<name>. They are made only for cameras whose
/// topic has a subscriber, in a thread of their own; the newest ones if there is no time for all.
class CameraPictures {
 public:
  /// Makes a picture of a camera that has a mask. \param image empty if it is not there
  /// \return CV_8UC1 or CV_8UC3 BGR; empty: there is none
  using Make =
      std::function<cv::Mat(const FittedScene& scene, size_t camera, const cv::Mat& image)>;

  struct Source {
    std::vector<std::string> cameras;
    std::string transport;     ///< of the images
    bool reads_images = true;  ///< while a picture is wanted
  };

  /// \param status must outlive this object
  CameraPictures(ros::NodeHandle& handle, std::string name, Source source, StageStatus* status,
                 Make make);
  ~CameraPictures();
  CameraPictures(const CameraPictures&) = delete;
  CameraPictures& operator=(const CameraPictures&) = delete;

  /// Follows who looks on; to be called for every frame set. Returns whether anybody does.
  bool isWanted();
  /// Returns at once.
  void show(FittedScene scene) { queue_.push(std::move(scene)); }

 private:
  void work();
  void publish(size_t camera, const FittedScene& scene);
  CameraImage imageOf(size_t camera, const sensor_msgs::Image& mask);

  const std::string name_;
  const Source source_;
  const Make make_;
  std::vector<ros::Publisher> publishers_;    ///< by camera
  std::vector<ros::Subscriber> subscribers_;  ///< by camera; none: nobody looks on
  std::mutex mutex_;                          ///< of images_
  StampCache<CameraImage> images_;
  CatchUpQueue<FittedScene> queue_;
  StageInputs inputs_;
  std::thread worker_;
};

}  // namespace markerless_mocap
