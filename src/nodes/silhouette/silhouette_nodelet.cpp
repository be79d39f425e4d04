#include <nodelet/nodelet.h>
#include <std_srvs/Trigger.h>

#include <boost/function.hpp>
#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <vector>

#include "nodes/common/callback_gate.h"
#include "nodes/common/guarded_start.h"
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
    for (const std::string& camera : node_options.cameras)
      cameras_.push_back(std::make_unique<SilhouetteCamera>(
          getMTNodeHandle(), getMTPrivateNodeHandle(), camera, options, node_options));
    learn_ = advertise("learn_background", &SilhouetteCamera::learnBackground,
                       "learning from the next " + std::to_string(options.background_frames) +
                           " images of each camera");
    save_ = advertise("save_background", &SilhouetteCamera::saveBackground,
                      "saved in " + node_options.background_folder);
  }

  /// Advertises a service that calls `act` for each camera. The first failure ends it with the
  /// reason.
  ros::ServiceServer advertise(const std::string& name, void (SilhouetteCamera::*act)(),
                               const std::string& done) {
    using Response = std_srvs::Trigger::Response;
    const auto run = gate_.guarded([this, act, done](Response* response) {
      response->success = false;
      try {
        for (const auto& camera : cameras_) (camera.get()->*act)();
        response->success = true;
        response->message = done;
      } catch (const std::exception& error) {
        response->message = error.what();
      }
    });
    const boost::function<bool(std_srvs::Trigger::Request&, Response&)> callback =
        [run](std_srvs::Trigger::Request&, Response& response) {
          run(&response);
          return true;
        };
    return getMTPrivateNodeHandle().advertiseService(name, callback);
  }

  std::vector<std::unique_ptr<SilhouetteCamera>> cameras_;
  ros::ServiceServer learn_, save_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::SilhouetteNodelet, nodelet::Nodelet)
