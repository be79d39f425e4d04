#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <vector>

#include "markerless_mocap/ros/parameters.h"
#include "nodes/guarded_start.h"
#include "nodes/silhouette_camera.h"

namespace markerless_mocap {

/// `<camera>/image_raw` -> `<camera>/silhouette` for each listed camera, cameras side by side.
class SilhouetteNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    SilhouetteOptions options;
    SilhouetteNodeOptions node_options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options, node_options);
    for (const std::string& camera : node_options.cameras)
      cameras_.push_back(std::make_unique<SilhouetteCamera>(
          getMTNodeHandle(), getMTPrivateNodeHandle(), camera, options, node_options));
  }

  std::vector<std::unique_ptr<SilhouetteCamera>> cameras_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::SilhouetteNodelet, nodelet::Nodelet)
