#include <nodelet/nodelet.h>

#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "markerless_mocap/skeleton/pose_tree_builder.h"
#include "nodes/common/guarded_start.h"
#include "nodes/common/hull_follower.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
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
    hulls_.emplace(getNodeHandle(), getPrivateNodeHandle(), getMTPrivateNodeHandle(), getName(),
                   "pose tree");
    builder_.emplace(hulls_->options());
    trees_ = hulls_->advertise<PoseTreeMsg>("pose_tree", kPublisherQueue);
    markers_ = hulls_->advertise<visualization_msgs::MarkerArray>("pose_tree/markers", 4);
    skeletons_ = hulls_->advertise<sensor_msgs::PointCloud2>("pose_tree/skeleton", 4);
    hulls_->follow(
        "trees", [this](const PoseTreeOptions& changed) { builder_.emplace(changed); },
        [this](const sensor_msgs::PointCloud2& hull, const HullGrids& grids) {
          process(hull, grids);
        });
  }

  void process(const sensor_msgs::PointCloud2& cloud, const HullGrids& grids) {
    forgetOnTimeJump(cloud.header.stamp);
    PoseTree tree;
    try {
      tree = builder_->build(grids.hullOf(cloud));
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
      hulls_->status().count("time went back");
    }
    last_stamp_ = stamp;
  }

  void report(const PoseTree& tree) {
    hulls_->status().count(toString(tree.status));
    if (tree.valid())
      hulls_->status().ok("the tree is labelled");
    else
      hulls_->status().problem(tree.reason);
  }

  void publish(const PoseTree& tree, const std_msgs::Header& header) {
    publishShared(trees_, messageFromPoseTree(tree, header));
    hulls_->status().sent(header.stamp);
    if (markers_.getNumSubscribers() > 0) markers_.publish(treeMarkers(tree, header));
    if (skeletons_.getNumSubscribers() > 0) publishShared(skeletons_, skeletonCloud(tree, header));
  }

  std::optional<PoseTreeBuilder> builder_;
  ros::Time last_stamp_;
  ros::Publisher trees_, markers_, skeletons_;
  std::optional<HullFollower<PoseTreeOptions>> hulls_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::PoseTreeNodelet, nodelet::Nodelet)
