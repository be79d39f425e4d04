#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "nodes/common/guarded_start.h"
#include "nodes/common/stage_queue.h"
#include "nodes/pose_fitting/fitting_stage.h"
#include "ros/parameters.h"

namespace markerless_mocap {

/// Silhouettes, `hull/points`, `segmentation/parts` and `pose_tree` of one time -> joint states,
/// tf, `pose`, `pose/body`.
class PoseFittingNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    TrackerOptions options;
    FittingNodeOptions node_options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options, node_options);
    ros::NodeHandle handle = queue_.served(getNodeHandle());
    stage_ =
        std::make_unique<FittingStage>(handle, getMTPrivateNodeHandle(), options, node_options);
  }

  StageQueue queue_{1};
  std::unique_ptr<FittingStage> stage_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::PoseFittingNodelet, nodelet::Nodelet)
