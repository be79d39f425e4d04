#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "markerless_mocap/camera/frame_set_assembler.h"
#include "markerless_mocap/ros/messages.h"
#include "nodes/common/holding_queue.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/common/stamp_cache.h"
#include "ros/node_options.h"
#include "ros/rig_collector.h"

namespace markerless_mocap {

/// What the other stages and the cameras say of one instant. Messages that have not come are null.
struct FittingMessages {
  std_msgs::Header header;  ///< of the hull
  std::string error;        ///< why nothing can be fitted; empty: it can
  bool complete = false;    ///< every stage that is asked for has said something
  std::shared_ptr<const CameraRig> rig;
  VoxelGridConstPtr grid;
  sensor_msgs::PointCloud2ConstPtr hull, labels;
  BodyPartsMsg::ConstPtr parts;
  PoseTreeMsg::ConstPtr tree;
  std::vector<sensor_msgs::ImageConstPtr> masks;  ///< by camera
  std::vector<CameraImage> images;                ///< by camera, of the masks' stamps
};

/// What a method looks at beside hull and parts.
struct FittingNeeds {
  bool masks;   ///< and the rig, and the pose tree
  bool images;  ///< and masks
};

/// Listens to all that a pose is fitted to and joins it by stamps. An instant that lacks parts or
/// tree is given out when a later one is complete if masks are there to go by.
class FittingInputs {
 public:
  /// \param sink gets the instants, oldest first, one at a time; it must not take long
  FittingInputs(ros::NodeHandle& handle, const FittingNodeOptions& options, FittingNeeds needs,
                StageStatus* status, std::function<void(FittingMessages)> sink);

 private:
  enum Stream : size_t { kHull, kParts, kLabels, kTree };
  /// A message of one of the streams.
  struct Item {
    sensor_msgs::PointCloud2ConstPtr cloud;
    BodyPartsMsg::ConstPtr parts;
    PoseTreeMsg::ConstPtr tree;
  };
  using Assembler = FrameSetAssembler<Item>;

  void listenToStages();
  void listenToCamera(size_t camera);
  void receive(Stream stream, const std_msgs::Header& header, Item item);
  void join(Assembler::FrameSet instant);
  /// Gives out what is held, oldest first, up to an instant whose silhouettes may still come.
  void dispatchReady();
  bool waitsForMasks(const FittingMessages& input) const;
  int64_t stampTolerance() const;  ///< nanoseconds
  void addViews(FittingMessages* input);
  /// Finds out the rig; one sentence on what is missing, empty once it is known.
  std::string prepareRig();
  void reportCounts();

  FittingNodeOptions options_;
  FittingNeeds needs_;
  StageStatus* status_;
  std::function<void(FittingMessages)> sink_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  RigCollector collector_;
  std::shared_ptr<const CameraRig> rig_;  ///< null until it is known
  Assembler assembler_;
  StampCache<sensor_msgs::ImageConstPtr> masks_;
  StampCache<CameraImage> images_;
  HoldingQueue<FittingMessages> pending_;  ///< joined, but for the views
  VoxelGridConstPtr grid_;
  StageInputs inputs_;
};

}  // namespace markerless_mocap
