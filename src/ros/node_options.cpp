#include "ros/node_options.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "options/option_texts.h"

namespace markerless_mocap {
namespace {

constexpr const char* kCamerasMeaning =
    "names of the cameras; the topics of camera c are c/image_raw, c/camera_info, c/silhouette";
constexpr const char* kRigMeaning =
    "rig file that calibrates the cameras in place of camera_info and tf; empty: none";
constexpr const char* kTransportMeaning =
    "raw reads c/image_raw, compressed reads c/image_raw/compressed";
constexpr const char* kMaskMeaning =
    "raw reads the masks on c/silhouette, compressed reads PNGs on c/silhouette/compressed, which "
    "are small enough for a network";
constexpr const char* kBodyMeaning = "suffix of the body's frames, joints and topics";
constexpr const char* kTemplateMeaning =
    "file of the URDF template; empty: the package's own urdf/human.urdf.in";

void checkCameras(const char* stage, const std::vector<std::string>& cameras, size_t min_cameras) {
  const std::string key = std::string(stage) + "/cameras";
  if (cameras.size() < min_cameras || cameras.size() > 32)
    throw std::invalid_argument(key + " lists " + std::to_string(cameras.size()) +
                                " cameras, allowed is " + std::to_string(min_cameras) + " to 32");
  std::set<std::string> names;
  for (const std::string& name : cameras)
    if (name.empty() || !names.insert(name).second)
      throw std::invalid_argument(key + " holds \"" + shortened(name) +
                                  "\", allowed are names that are not empty and all different");
}

void checkWorldFrame(const char* stage, const std::string& frame) {
  if (frame.empty())
    throw std::invalid_argument(std::string(stage) +
                                "/world_frame is empty, allowed is a frame's name");
}

void checkBodyId(const char* stage, const std::string& id) {
  bool usable = !id.empty() && std::isalpha(static_cast<unsigned char>(id[0]));
  for (const char c : id) usable = usable && std::isalnum(static_cast<unsigned char>(c));
  if (!usable)
    throw std::invalid_argument(std::string(stage) + "/body_id is \"" + shortened(id) +
                                "\", allowed are letters and digits, a letter first");
}

size_t required(int min_cameras, const std::vector<std::string>& cameras) {
  return min_cameras > 0 ? static_cast<size_t>(min_cameras) : (3 * cameras.size() + 3) / 4;
}

}  // namespace

void SilhouetteNodeOptions::visit(OptionVisitor& v) {
  v.field("cameras", cameras, kCamerasMeaning);
  v.field("image_transport", image_transport, {"raw", "compressed"}, kTransportMeaning);
  v.field("input", input, {"image", "mask"},
          "what the images are; image: colour or grey; mask: silhouettes already, non-zero for the "
          "person, which pass through");
  v.field("background_folder", background_folder, {},
          "folder of the backgrounds, c.background for camera c, with + for each / of its name; a "
          "file that is there is read at the start instead of learning, and the service "
          "save_background writes it; empty: none");
  v.field("keep_background", keep_background,
          "whether the backgrounds are written to background_folder as soon as they are known, so "
          "that a node that starts again uses them; those of another size or light are refused");
}

void SilhouetteNodeOptions::validate() const {
  checkFields(*this);
  checkCameras(kStage, cameras, 1);
  if (keep_background && background_folder.empty())
    throw std::invalid_argument(
        "silhouette/keep_background is true, but background_folder is empty, allowed is a folder");
}

// No name of a topic has a +.
std::string SilhouetteNodeOptions::backgroundFile(std::string camera) const {
  if (input != "image" || background_folder.empty()) return "";
  std::replace(camera.begin(), camera.end(), '/', '+');
  return (std::filesystem::path(background_folder) / (camera + ".background")).string();
}

void HullNodeOptions::visit(OptionVisitor& v) {
  v.field("cameras", cameras, kCamerasMeaning);
  v.field("world_frame", world_frame, {}, "frame of the hull; tf connects the cameras to it");
  v.field("rig_file", rig_file, {}, kRigMeaning);
  v.field("image_transport", image_transport, {"raw", "compressed"}, kTransportMeaning);
  v.field("mask_transport", mask_transport, {"raw", "compressed"}, kMaskMeaning);
  v.field("privacy", privacy,
          "whether no image may be read; voxels then have no colours, whatever color says");
  v.field("color", color, "whether the voxels are coloured from the images");
  v.field("min_cameras", min_cameras, 0, 32,
          "number of cameras that a frame set must have to be carved; 0: three quarters of those "
          "listed");
  v.field("stamp_tolerance", stamp_tolerance, 0.0, 1.0,
          "stamps closer than this belong to one frame set, s");
  v.field(
      "deadline", deadline, 0.0, 60.0,
      "a frame set older than the newest stamp by this is carved without the missing cameras, s");
  v.field("volume_file", volume_file, {},
          "file of the volume; read at the start if it is there, and written by the service "
          "save_volume and the menu of the volume in rviz; empty: none");
}

void HullNodeOptions::validate() const {
  checkFields(*this);
  checkCameras(kStage, cameras, 2);
  checkWorldFrame(kStage, world_frame);
  if (min_cameras > static_cast<int>(cameras.size()))
    throw std::invalid_argument("visual_hull/min_cameras is " + std::to_string(min_cameras) +
                                ", allowed is at most the number of cameras, " +
                                std::to_string(cameras.size()));
  if (deadline < stamp_tolerance)
    throw std::invalid_argument("visual_hull/deadline is " + std::to_string(deadline) +
                                ", allowed is stamp_tolerance or more");
}

bool HullNodeOptions::readsImages() const {
  return color && !privacy;
}

size_t HullNodeOptions::requiredCameras() const {
  return required(min_cameras, cameras);
}

void FittingNodeOptions::visit(OptionVisitor& v) {
  v.field("cameras", cameras, kCamerasMeaning);
  v.field("world_frame", world_frame, {}, "frame of the hulls; tf connects the cameras to it");
  v.field("rig_file", rig_file, {}, kRigMeaning);
  v.field("image_transport", image_transport, {"raw", "compressed"}, kTransportMeaning);
  v.field("mask_transport", mask_transport, {"raw", "compressed"}, kMaskMeaning);
  v.field("privacy", privacy,
          "whether no image may be read; then there are no overlays, unknown backgrounds are not "
          "looked up by colour, and methods that need images are refused");
  v.field("min_cameras", min_cameras, 0, 32,
          "number of cameras that a frame set must have to be fitted; 0: three quarters of those "
          "listed; as that of visual_hull");
  v.field("stamp_tolerance", stamp_tolerance, 0.0, 1.0,
          "stamps closer than this belong to one frame set, s; as that of visual_hull");
  v.field("deadline", deadline, 0.0, 60.0,
          "a frame set older than the newest stamp by this is fitted without the missing cameras, "
          "s; as that of visual_hull");
  v.field("body_id", body_id, {}, kBodyMeaning);
  v.field("urdf_template", urdf_template, {}, kTemplateMeaning);
  v.field("body_file", body_file, {},
          "file of the shape of the person's body; read at the start if it is there, else written "
          "when the shape has been estimated; empty: none");
}

void FittingNodeOptions::validate() const {
  checkFields(*this);
  checkCameras(kStage, cameras, 0);
  checkWorldFrame(kStage, world_frame);
  checkBodyId(kStage, body_id);
  if (deadline < stamp_tolerance)
    throw std::invalid_argument("pose_fitting/deadline is " + std::to_string(deadline) +
                                ", allowed is stamp_tolerance or more");
}

void FittingNodeOptions::requireCameras() const {
  checkCameras(kStage, cameras, 2);
}

size_t FittingNodeOptions::requiredCameras() const {
  return required(min_cameras, cameras);
}

void StudioNodeOptions::visit(OptionVisitor& v) {
  v.field("body_id", body_id, {}, kBodyMeaning);
  v.field("urdf_template", urdf_template, {}, kTemplateMeaning);
  v.field("world_frame", world_frame, {}, "frame that cameras and person stand in");
  v.field("clock", clock, "whether stamps start at 1000 s and /clock is published");
  v.field("wait_for_silhouettes", wait_for_silhouettes,
          "whether the film starts only when c/silhouette is advertised for every camera c");
}

void StudioNodeOptions::validate() const {
  checkFields(*this);
  checkBodyId(kStage, body_id);
}

void UsbCameraOptions::visit(OptionVisitor& v) {
  v.field("cameras", cameras,
          "names of the cameras; the topics of camera c are c/image_raw and, with a rig file, "
          "c/camera_info");
  v.field("sources", sources,
          "for each camera its device such as /dev/video0, the device's number, or a video file");
  v.field("rig_file", rig_file, {}, "rig file whose camera_info and tf are published; empty: none");
  v.field("world_frame", world_frame, {}, "frame that the rig stands in");
  v.field("width", width, 16, 16384, "width of the images of devices, px");
  v.field("height", height, 16, 16384, "height of the images of devices, px");
  v.field("fps", fps, 0.1, 1000.0, "images of a device per second");
  v.field("pixel_format", pixel_format, {},
          "four letters of the format that devices send; MJPG lets several cameras share a USB "
          "bus");
  v.field("exposure", exposure, 0, 1000000,
          "exposure of devices in the driver's unit, mostly 0.1 ms; 0: automatic");
  v.field("white_balance", white_balance, 0, 20000,
          "white balance of devices, kelvin; 0: automatic");
  v.field("loop", loop, "whether video files begin again at their end");
}

void UsbCameraOptions::validate() const {
  checkFields(*this);
  checkCameras(kStage, cameras, 1);
  checkWorldFrame(kStage, world_frame);
  if (sources.size() != cameras.size())
    throw std::invalid_argument("usb_cameras/sources lists " + std::to_string(sources.size()) +
                                " sources, allowed is one for each of the " +
                                std::to_string(cameras.size()) + " cameras");
  if (pixel_format.size() != 4)
    throw std::invalid_argument("usb_cameras/pixel_format is \"" + pixel_format +
                                "\", allowed are four letters such as MJPG or YUYV");
}

}  // namespace markerless_mocap
