#pragma once

#include <ros/node_handle.h>

#include <cstdint>

#include "markerless_mocap/camera/instant_assembler.h"
#include "markerless_mocap/ros/node_options.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "nodes/callback_gate.h"
#include "nodes/camera_image.h"
#include "nodes/stage_status.h"

namespace markerless_mocap {

/// One camera's images in, its masks out.
class SilhouetteCamera {
 public:
  SilhouetteCamera(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                   const std::string& camera, const SilhouetteOptions& options,
                   const SilhouetteNodeOptions& node_options);

 private:
  void receive(const CameraImage& image);
  void process(const CameraImage& image);
  cv::Mat maskOf(const CameraImage& image);
  void reportSilence();

  std::string camera_;
  std::string topic_;
  SilhouetteNodeOptions node_options_;
  SilhouetteExtractor extractor_;
  InstantAssembler<CameraImage> order_;  ///< one stream: drops duplicates, late and wild stamps
  StageStatus status_;
  ros::Publisher publisher_;
  ros::WallTimer silence_timer_;
  ros::Subscriber subscriber_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
