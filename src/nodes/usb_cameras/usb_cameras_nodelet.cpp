#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "nodes/common/guarded_start.h"
#include "nodes/usb_cameras/usb_camera_stage.h"
#include "ros/parameters.h"

namespace markerless_mocap {

/// Images of USB cameras with fixed exposure, or of video files.
class UsbCamerasNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    guardedStart(getName(), [this] { start(); });
  }

  void start() {
    UsbCameraOptions options;
    loadOptionsTogether(parametersOf(getPrivateNodeHandle()), getName(), options);
    stage_ = std::make_unique<UsbCameraStage>(getNodeHandle(), getPrivateNodeHandle(), options);
  }

  std::unique_ptr<UsbCameraStage> stage_;
};

}  // namespace markerless_mocap

PLUGINLIB_EXPORT_CLASS(markerless_mocap::UsbCamerasNodelet, nodelet::Nodelet)
