#include <nodelet/nodelet.h>

#include <optional>
#include <pluginlib/class_list_macros.hpp>

#include "markerless_mocap/segmentation/body_segmenter.h"
#include "markerless_mocap/segmentation/part_tracker.h"
#include "nodes/common/guarded_start.h"
#include "nodes/common/hull_follower.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "ros/segmentation_conversions.h"

namespace markerless_mocap {

/// `hull/points` -> `segmentation/parts`, `segmentation/points`, `segmentation/curves`.
class BodySegmentationNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    hulls_.emplace(getNodeHandle(), getPrivateNodeHandle(), getMTPrivateNodeHandle(), getName(),
                   "body segmentation");
    setOptions(hulls_->options());
    parts_ = hulls_->advertise<BodyPartsMsg>("segmentation/parts", kPublisherQueue);
    points_ = hulls_->advertise<sensor_msgs::PointCloud2>("segmentation/points", kPublisherQueue);
    curves_ = hulls_->advertise<visualization_msgs::MarkerArray>("segmentation/curves", 4);
    hulls_->follow(
        "parts", [this](const SegmentationOptions& changed) { setOptions(changed); },
        [this](const sensor_msgs::PointCloud2& hull, const HullGrids& grids) {
          process(hull, grids);
        });
  }

  void setOptions(const SegmentationOptions& options) {
    segmenter_.emplace(options);
    memory_ = PartTracker();
  }

  void process(const sensor_msgs::PointCloud2& cloud, const HullGrids& grids) {
    VisualHull hull;
    BodyParts parts;
    try {
      hull = grids.hullOf(cloud);
      parts = segmenter_->segment(hull, int64_t(cloud.header.stamp.toNSec()), &memory_);
    } catch (const std::exception& error) {
      parts = BodyParts();
      parts.reason = error.what();
    }
    report(parts);
    publishShared(parts_, messageFromParts(parts, cloud.header));
    hulls_->status().sent(cloud.header.stamp);
    publishShared(points_, labelledCloud(hull, parts, cloud.header));
    curves_.publish(curveMarkers(parts, cloud.header));
  }

  void report(const BodyParts& parts) {
    hulls_->status().count(toString(parts.status));
    if (parts.status == SegmentationStatus::kOk)
      hulls_->status().ok("all six parts are seen");
    else
      hulls_->status().problem(parts.reason);
  }

  std::optional<BodySegmenter> segmenter_;
  PartTracker memory_;
  ros::Publisher parts_, points_, curves_;
  std::optional<HullFollower<SegmentationOptions>> hulls_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::BodySegmentationNodelet, nodelet::Nodelet)
