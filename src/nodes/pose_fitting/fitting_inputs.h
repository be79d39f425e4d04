#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/frame_set_assembler.h"
#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "markerless_mocap/ros/messages.h"
#include "nodes/common/holding_queue.h"
#include "nodes/common/hull_grids.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/common/stamp_cache.h"
#include "nodes/pose_fitting/color_images.h"
#include "ros/node_options.h"
#include "ros/rig_collector.h"

namespace markerless_mocap {

/// Messages of the other stages and of the cameras for one time. Missing messages are null.
struct FittingMessages {
  std_msgs::Header header;  ///< of the hull
  std::string error;        ///< why no pose can be fitted; empty if it can
  bool complete = false;    ///< all required stages have sent a message
  std::shared_ptr<const CameraRig> rig;
  VoxelGridConstPtr grid;
  sensor_msgs::PointCloud2ConstPtr hull, labels;
  BodyPartsMsg::ConstPtr parts;
  PoseTreeMsg::ConstPtr tree;
  boost::shared_ptr<const HullCameras> cameras;
  std::vector<sensor_msgs::ImageConstPtr> masks;  ///< by camera; null: not to be used
  std::vector<CameraImage> images;  ///< by camera, with the stamps of the masks; or none at all
};

/// Subscribes to all inputs of pose fitting and joins them by stamp. For a method that needs masks,
/// a frame set without parts or tree is passed on when a later one is complete or after the
/// deadline. For the others it is dropped. A frame set without a hull is always dropped. For a
/// method that needs colours, images are subscribed only while the masks call for them.
class FittingInputs {
 public:
  /// \param sink receives the frame sets, oldest first, one at a time; it must return quickly
  FittingInputs(ros::NodeHandle& handle, const FittingNodeOptions& options, TrackerNeeds needs,
                StageStatus* status, std::function<void(FittingMessages)> sink);

  /// Stamp of each camera's last silhouette, and what the last frame set used. Thread-safe.
  void describeCameras(MocapStatus* message) const;

 private:
  enum Stream : size_t { kHull, kParts, kLabels, kTree, kCameras };
  /// A message of one of the streams.
  struct Item {
    sensor_msgs::PointCloud2ConstPtr cloud;
    BodyPartsMsg::ConstPtr parts;
    PoseTreeMsg::ConstPtr tree;
    boost::shared_ptr<const HullCameras> cameras;
  };
  /// What is known of a camera.
  struct CameraState {
    ros::Time last_stamp;
    bool used = false;
    std::string reason;
  };
  using Assembler = FrameSetAssembler<Item>;

  /// A silhouette as it has come.
  struct Mask {
    sensor_msgs::ImageConstPtr message;
    bool unknown = false;  ///< as hasUnknownBackground()
  };

  void listenToStages();
  void listenToCamera(size_t camera);
  void receiveMask(size_t camera, const sensor_msgs::ImageConstPtr& mask);
  void receive(Stream stream, const std_msgs::Header& header, Item item);
  void join(Assembler::FrameSet frame_set);
  /// Passes on the waiting frame sets, oldest first, up to one whose silhouettes, or images that it
  /// needs, may still arrive.
  void dispatchReady();
  bool waitsForViews(const FittingMessages& input) const;
  int64_t stampTolerance() const;  ///< nanoseconds
  /// The stamp that a camera's silhouette of this hull has by the camera's own clock.
  int64_t stampOfCamera(size_t camera, int64_t hull_stamp_ns) const;
  void followLag(size_t camera, int64_t mask_stamp_ns, int64_t hull_stamp_ns);
  void addViews(FittingMessages* input);
  /// Why visual_hull says that nobody should use the camera; empty: it does not say so.
  std::string refusalOf(const FittingMessages& input, size_t camera) const;
  void noteUse(size_t camera, bool used, const std::string& reason);
  /// Takes over what has changed about the cameras.
  void followRig();
  CameraImage takeImage(size_t camera, const Mask& mask);
  /// Determines the rig. Returns a message about what is missing; empty once the rig is known.
  std::string prepareRig();
  void reportCounts();

  FittingNodeOptions options_;
  TrackerNeeds needs_;
  StageStatus* status_;
  std::function<void(FittingMessages)> sink_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  RigCollector collector_;
  std::shared_ptr<const CameraRig> rig_;  ///< null until the rig is known
  Assembler assembler_;
  std::vector<double> offsets_;  ///< s, of the cameras' clocks; empty: they agree
  LagEstimate lags_;             ///< of clocks that do not agree
  StampCache<Mask> masks_;
  StampCache<CameraImage> images_;
  HoldingQueue<FittingMessages> pending_;  ///< joined, but without views
  HullGrids grids_;
  double next_look_ = 0.0;  ///< s, when to look for changes of the rig
  mutable std::mutex states_mutex_;
  std::vector<CameraState> states_;    ///< by camera
  std::optional<ColorImages> colors_;  ///< of a method that needs them
  StageInputs inputs_;
};

}  // namespace markerless_mocap
