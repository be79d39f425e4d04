#include <nodelet/nodelet.h>

#include <memory>
#include <mutex>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>

#include "markerless_mocap/segmentation/body_segmenter.h"
#include "markerless_mocap/segmentation/part_tracker.h"
#include "nodes/common/guarded_start.h"
#include "nodes/common/hull_grids.h"
#include "nodes/common/live_options.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "nodes/common/stage_inputs.h"
#include "ros/parameters.h"
#include "ros/segmentation_conversions.h"

namespace markerless_mocap {

/// `hull/points` -> `segmentation/parts`, `segmentation/points`, `segmentation/curves`.
class BodySegmentationNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    SegmentationOptions options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options);
    segmenter_.emplace(options);
    ros::NodeHandle& handle = getNodeHandle();
    status_ = std::make_unique<StageStatus>(handle, getPrivateNodeHandle(), "body segmentation");
    parts_ = handle.advertise<BodyPartsMsg>("segmentation/parts", kPublisherQueue);
    points_ = handle.advertise<sensor_msgs::PointCloud2>("segmentation/points", kPublisherQueue);
    curves_ = handle.advertise<visualization_msgs::MarkerArray>("segmentation/curves", 4);
    inputs_.emplace(handle, status_.get());
    inputs_->listenToLatched<VoxelGrid>(
        "hull/grid", StageInputs::kOptional,
        [this](const VoxelGridConstPtr& grid) { receiveGrid(grid); });
    inputs_->listen<sensor_msgs::PointCloud2>(
        "hull/points", 2, StageInputs::kRequired,
        [this](const sensor_msgs::PointCloud2ConstPtr& hull) { receive(*hull); });
    live_.emplace(getMTPrivateNodeHandle(), options, std::set<std::string>(),
                  [this](const SegmentationOptions& changed) {
                    const std::lock_guard<std::mutex> lock(mutex_);
                    segmenter_.emplace(changed);
                    memory_ = PartTracker();
                  });
  }

  bool isWanted() const {
    return parts_.getNumSubscribers() + points_.getNumSubscribers() + curves_.getNumSubscribers() >
           0;
  }

  void receiveGrid(const VoxelGridConstPtr& grid) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const std::string fault = grids_.add(grid); !fault.empty()) status_->remark(fault);
  }

  void receive(const sensor_msgs::PointCloud2& cloud) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!isWanted()) return status_->ok("it rests, nobody asks for parts");
    VisualHull hull;
    BodyParts parts;
    try {
      hull = grids_.hullOf(cloud);
      parts = segmenter_->segment(hull, int64_t(cloud.header.stamp.toNSec()), &memory_);
    } catch (const std::exception& error) {
      parts = BodyParts();
      parts.reason = error.what();
    }
    report(parts);
    publishShared(parts_, messageFromParts(parts, cloud.header));
    status_->sent(cloud.header.stamp);
    publishShared(points_, labelledCloud(hull, parts, cloud.header));
    curves_.publish(curveMarkers(parts, cloud.header));
  }

  void report(const BodyParts& parts) {
    status_->count(toString(parts.status));
    if (parts.status == SegmentationStatus::kOk)
      status_->ok("all six parts are seen");
    else
      status_->problem(parts.reason);
  }

  std::mutex mutex_;  ///< settings change between hulls
  std::optional<BodySegmenter> segmenter_;
  PartTracker memory_;
  HullGrids grids_;
  std::unique_ptr<StageStatus> status_;
  ros::Publisher parts_, points_, curves_;
  std::optional<StageInputs> inputs_;
  std::optional<LiveOptions<SegmentationOptions>> live_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::BodySegmentationNodelet, nodelet::Nodelet)
