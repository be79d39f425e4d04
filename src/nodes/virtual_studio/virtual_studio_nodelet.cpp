#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "nodes/common/guarded_start.h"
#include "nodes/virtual_studio/studio_stage.h"
#include "ros/parameters.h"

namespace markerless_mocap {

/// Rendered images of a moving person with ground truth: images, camera_info, tf,
/// `ground_truth/joints`, `ground_truth/joint_states` and `ground_truth/<camera>/silhouette`.
class VirtualStudioNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    StudioOptions options;
    StudioNodeOptions node_options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options, node_options);
    stage_ = std::make_unique<StudioStage>(getNodeHandle(), getPrivateNodeHandle(), options,
                                           node_options);
  }

  std::unique_ptr<StudioStage> stage_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::VirtualStudioNodelet, nodelet::Nodelet)
