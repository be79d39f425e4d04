#include <nodelet/nodelet.h>

#include <memory>
#include <mutex>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "markerless_mocap/skeleton/pose_tree_builder.h"
#include "nodes/common/guarded_start.h"
#include "nodes/common/hull_grids.h"
#include "nodes/common/live_options.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "nodes/common/stage_inputs.h"
#include "ros/parameters.h"
#include "ros/pose_tree_conversions.h"
#include "ros/pose_tree_markers.h"

namespace markerless_mocap {

/// `hull/points` -> `pose_tree`, and for display `pose_tree/markers`, `pose_tree/skeleton`.
class PoseTreeNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    PoseTreeOptions options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options);
    builder_.emplace(options);
    ros::NodeHandle& handle = getNodeHandle();
    status_ = std::make_unique<StageStatus>(handle, getPrivateNodeHandle(), "pose tree");
    trees_ = handle.advertise<PoseTreeMsg>("pose_tree", kPublisherQueue);
    markers_ = handle.advertise<visualization_msgs::MarkerArray>("pose_tree/markers", 4);
    skeletons_ = handle.advertise<sensor_msgs::PointCloud2>("pose_tree/skeleton", 4);
    inputs_.emplace(handle, status_.get());
    inputs_->listenToLatched<VoxelGrid>(
        "hull/grid", StageInputs::kOptional,
        [this](const VoxelGridConstPtr& grid) { receiveGrid(grid); });
    inputs_->listen<sensor_msgs::PointCloud2>(
        "hull/points", 2, StageInputs::kRequired,
        [this](const sensor_msgs::PointCloud2ConstPtr& hull) { receive(*hull); });
    live_.emplace(getMTPrivateNodeHandle(), options, std::set<std::string>(),
                  [this](const PoseTreeOptions& changed) {
                    const std::lock_guard<std::mutex> lock(mutex_);
                    builder_.emplace(changed);
                  });
  }

  bool isWanted() const {
    return trees_.getNumSubscribers() + markers_.getNumSubscribers() +
               skeletons_.getNumSubscribers() >
           0;
  }

  void receiveGrid(const VoxelGridConstPtr& grid) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const std::string fault = grids_.add(grid); !fault.empty()) status_->remark(fault);
  }

  void receive(const sensor_msgs::PointCloud2& cloud) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!isWanted()) return status_->ok("it rests, nobody asks for trees");
    forgetOnTimeJump(cloud.header.stamp);
    PoseTree tree;
    try {
      tree = builder_->build(grids_.hullOf(cloud));
    } catch (const std::exception& error) {
      tree = PoseTree();
      tree.reason = error.what();
    }
    report(tree);
    publish(tree, cloud.header);
  }

  void forgetOnTimeJump(const ros::Time& stamp) {
    if (stamp < last_stamp_) {
      builder_->reset();
      status_->count("time went back");
    }
    last_stamp_ = stamp;
  }

  void report(const PoseTree& tree) {
    status_->count(toString(tree.status));
    if (tree.valid())
      status_->ok("the tree is labelled");
    else
      status_->problem(tree.reason);
  }

  void publish(const PoseTree& tree, const std_msgs::Header& header) {
    publishShared(trees_, messageFromPoseTree(tree, header));
    status_->sent(header.stamp);
    if (markers_.getNumSubscribers() > 0) markers_.publish(treeMarkers(tree, header));
    if (skeletons_.getNumSubscribers() > 0) publishShared(skeletons_, skeletonCloud(tree, header));
  }

  std::mutex mutex_;  ///< settings change between hulls
  std::optional<PoseTreeBuilder> builder_;
  HullGrids grids_;
  ros::Time last_stamp_;
  std::unique_ptr<StageStatus> status_;
  ros::Publisher trees_, markers_, skeletons_;
  std::optional<StageInputs> inputs_;
  std::optional<LiveOptions<PoseTreeOptions>> live_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::PoseTreeNodelet, nodelet::Nodelet)
