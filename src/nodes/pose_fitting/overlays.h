#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/Image.h>

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

/// What is drawn into the images of one time.
struct OverlayScene {
  std::shared_ptr<const TrackedBody> body;
  BodyPose pose;
  std::shared_ptr<const CameraRig> rig;
  std::vector<sensor_msgs::ImageConstPtr> masks;  ///< by camera; null where missing
};

/// The images of the cameras with the body in them, on <camera>/overlay. Images are subscribed and
/// drawn only for cameras whose overlay has a subscriber, in a thread of their own.
class Overlays {
 public:
  /// \param status must outlive this object
  Overlays(ros::NodeHandle& handle, std::vector<std::string> cameras, std::string transport,
           StageStatus* status);
  ~Overlays();
  Overlays(const Overlays&) = delete;
  Overlays& operator=(const Overlays&) = delete;

  /// Follows who looks on; to be called for every frame set. Returns whether anybody does.
  bool isWanted();
  /// Returns at once.
  void show(OverlayScene scene) { queue_.push(std::move(scene)); }

 private:
  void work();
  void draw(size_t camera, const OverlayScene& scene);
  CameraImage imageOf(size_t camera, const sensor_msgs::Image& mask);

  std::vector<std::string> cameras_;
  std::string transport_;
  std::vector<ros::Publisher> publishers_;    ///< by camera
  std::vector<ros::Subscriber> subscribers_;  ///< by camera; none: nobody looks on
  std::mutex mutex_;                          ///< of images_
  StampCache<CameraImage> images_;
  CatchUpQueue<OverlayScene> queue_;
  StageInputs inputs_;
  std::thread worker_;
};

}  // namespace markerless_mocap
