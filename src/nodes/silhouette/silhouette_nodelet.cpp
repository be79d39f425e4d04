#include <nodelet/nodelet.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <thread>
#include <vector>

#include "nodes/common/guarded_start.h"
#include "nodes/common/live_options.h"
#include "nodes/common/stage_queue.h"
#include "nodes/common/stage_services.h"
#include "nodes/silhouette/silhouette_camera.h"
#include "ros/parameters.h"

namespace markerless_mocap {

/// `<camera>/image_raw` -> `<camera>/silhouette` for each listed camera; the cameras run in
/// parallel. Services for all its cameras: `~learn_background`, `~save_background`.
class SilhouetteNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    SilhouetteOptions options;
    SilhouetteNodeOptions node_options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options, node_options);
    ros::NodeHandle handle = queue_.served(getNodeHandle());
    shared_.emplace(node_options.cameras.size(), options);
    for (size_t i = 0; i < node_options.cameras.size(); ++i)
      cameras_.push_back(std::make_unique<SilhouetteCamera>(handle, getMTPrivateNodeHandle(), i,
                                                            options, node_options, &*shared_));
    live_.emplace(getMTPrivateNodeHandle(), options, SilhouetteOptions::fixedKeys(),
                  [this](const SilhouetteOptions& changed) { shared_->settings.change(changed); });
    services_.emplace(getMTPrivateNodeHandle());
    const std::string learning = "learning from the next " +
                                 std::to_string(options.background_frames) +
                                 " images of each camera";
    services_->onTrigger("learn_background", [this, learning] {
      for (const auto& camera : cameras_) camera->learnBackground();
      return learning;
    });
    const std::string saved = "saved in " + node_options.background_folder;
    services_->onTrigger("save_background", [this, saved] {
      for (const auto& camera : cameras_) camera->saveBackground();
      return saved;
    });
  }

  StageQueue queue_{std::max(std::thread::hardware_concurrency(), 1u)};
  std::optional<SilhouetteCamera::Shared> shared_;
  std::vector<std::unique_ptr<SilhouetteCamera>> cameras_;
  std::optional<LiveOptions<SilhouetteOptions>> live_;
  std::optional<StageServices> services_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::SilhouetteNodelet, nodelet::Nodelet)
