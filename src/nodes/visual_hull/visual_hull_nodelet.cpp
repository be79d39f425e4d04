#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "nodes/common/guarded_start.h"
#include "nodes/common/stage_queue.h"
#include "nodes/visual_hull/hull_stage.h"
#include "ros/package_files.h"
#include "ros/parameters.h"
#include "ros/volume_file.h"

namespace markerless_mocap {

/// `<camera>/silhouette` of one time -> `hull/points`, `hull/grid`.
class VisualHullNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    HullOptions options;
    HullNodeOptions node_options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options, node_options);
    if (isThere(node_options.volume_file))
      options = withVolumeOf(node_options.volume_file, options);
    ros::NodeHandle handle = queue_.served(getNodeHandle());
    stage_ = std::make_unique<HullStage>(handle, getMTPrivateNodeHandle(), options, node_options);
  }

  StageQueue queue_{1};
  std::unique_ptr<HullStage> stage_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::VisualHullNodelet, nodelet::Nodelet)
