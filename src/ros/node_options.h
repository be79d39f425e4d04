#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Options of the node `silhouette` in addition to SilhouetteOptions, in the same private
/// namespace.
struct SilhouetteNodeOptions {
  static constexpr const char* kStage = "silhouette";
  /// names of the cameras; the topics of camera c are c/image_raw, c/camera_info, c/silhouette
  std::vector<std::string> cameras;
  /// raw reads c/image_raw, compressed reads c/image_raw/compressed
  std::string image_transport = "raw";
  /// what the images are; image: colour or grey; mask: silhouettes already, non-zero for the
  /// person, which pass through
  std::string input = "image";
  /// folder of the backgrounds, c.background for camera c, with + for each / of its name; a file
  /// that is there is read at the start instead of learning, and the service save_background writes
  /// it; empty: none
  std::string background_folder;
  /// whether the backgrounds are written to background_folder as soon as they are known, so that a
  /// node that starts again uses them; those of another size or light are refused
  bool keep_background = false;

  void visit(OptionVisitor& v);
  void validate() const;
  /// Path of the camera's background, another one for each camera; empty: none.
  std::string backgroundFile(std::string camera) const;
};

/// Options of the node `visual_hull` in addition to HullOptions.
struct HullNodeOptions {
  static constexpr const char* kStage = "visual_hull";
  /// names of the cameras; the topics of camera c are c/image_raw, c/camera_info, c/silhouette
  std::vector<std::string> cameras;
  /// frame of the hull; tf connects the cameras to it
  std::string world_frame = "world";
  /// rig file that calibrates the cameras in place of camera_info and tf; empty: none
  std::string rig_file;
  /// raw reads c/image_raw, compressed reads c/image_raw/compressed
  std::string image_transport = "raw";
  /// raw reads the masks on c/silhouette, compressed reads PNGs on c/silhouette/compressed, which
  /// are small enough for a network
  std::string mask_transport = "raw";
  /// whether no image may be read; voxels then have no colours, whatever color says
  bool privacy = false;
  /// whether the voxels are coloured from the images
  bool color = true;
  /// number of cameras that a frame set must have to be carved; 0: three quarters of those listed
  int min_cameras = 0;
  /// stamps closer than this belong to one frame set, s
  double stamp_tolerance = 0.005;
  /// a frame set older than the newest stamp by this is carved without the missing cameras, s
  double deadline = 0.5;
  /// file of the volume; read at the start if it is there, and written by the service save_volume
  /// and the menu of the volume in rviz; empty: none
  std::string volume_file;

  void visit(OptionVisitor& v);
  void validate() const;
  bool readsImages() const;
  /// min_cameras, or what it stands for when it is 0.
  size_t requiredCameras() const;
};

/// Options of the node `pose_fitting` in addition to TrackerOptions.
struct FittingNodeOptions {
  static constexpr const char* kStage = "pose_fitting";
  /// names of the cameras; the topics of camera c are c/image_raw, c/camera_info, c/silhouette
  std::vector<std::string> cameras;
  /// frame of the hulls; tf connects the cameras to it
  std::string world_frame = "world";
  /// rig file that calibrates the cameras in place of camera_info and tf; empty: none
  std::string rig_file;
  /// raw reads c/image_raw, compressed reads c/image_raw/compressed
  std::string image_transport = "raw";
  /// raw reads the masks on c/silhouette, compressed reads PNGs on c/silhouette/compressed, which
  /// are small enough for a network
  std::string mask_transport = "raw";
  /// whether no image may be read; then there are no overlays, unknown backgrounds are not looked
  /// up by colour, and methods that need images are refused
  bool privacy = false;
  /// number of cameras that a frame set must have to be fitted; 0: three quarters of those listed;
  /// as that of visual_hull
  int min_cameras = 0;
  /// stamps closer than this belong to one frame set, s; as that of visual_hull
  double stamp_tolerance = 0.005;
  /// a frame set older than the newest stamp by this is fitted without the missing cameras, s; as
  /// that of visual_hull
  double deadline = 0.5;
  /// suffix of the body's frames, joints and topics
  std::string body_id = "person1";
  /// file of the URDF template; empty: the package's own urdf/human.urdf.in
  std::string urdf_template;
  /// file of the shape of the person's body; read at the start if it is there, else written when
  /// the shape has been estimated; empty: none
  std::string body_file;

  void visit(OptionVisitor& v);
  void validate() const;
  /// For methods that read silhouettes. Throws std::invalid_argument on fewer than two cameras.
  void requireCameras() const;
  /// min_cameras, or what it stands for when it is 0.
  size_t requiredCameras() const;
};

/// Options of the node `virtual_studio` in addition to StudioOptions.
struct StudioNodeOptions {
  static constexpr const char* kStage = "virtual_studio";
  /// suffix of the body's frames, joints and topics
  std::string body_id = "truth";
  /// file of the URDF template; empty: the package's own urdf/human.urdf.in
  std::string urdf_template;
  /// frame that cameras and person stand in
  std::string world_frame = "world";
  /// whether stamps start at 1000 s and /clock is published
  bool clock = false;
  /// whether the film starts only when c/silhouette is advertised for every camera c
  bool wait_for_silhouettes = false;

  void visit(OptionVisitor& v);
  void validate() const;
};

/// Options of the node `usb_cameras`.
struct UsbCameraOptions {
  static constexpr const char* kStage = "usb_cameras";
  /// names of the cameras; the topics of camera c are c/image_raw and, with a rig file,
  /// c/camera_info
  std::vector<std::string> cameras;
  /// for each camera its device such as /dev/video0, the device's number, or a video file
  std::vector<std::string> sources;
  /// rig file whose camera_info and tf are published; empty: none
  std::string rig_file;
  /// frame that the rig stands in
  std::string world_frame = "world";
  /// width of the images of devices, px
  int width = 1280;
  /// height of the images of devices, px
  int height = 720;
  /// images of a device per second
  double fps = 30.0;
  /// four letters of the format that devices send; MJPG lets several cameras share a USB bus
  std::string pixel_format = "MJPG";
  /// exposure of devices in the driver's unit, mostly 0.1 ms; 0: automatic
  int exposure = 100;
  /// white balance of devices, kelvin; 0: automatic
  int white_balance = 4500;
  /// whether video files begin again at their end
  bool loop = false;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
