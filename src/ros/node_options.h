#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// What the node `silhouette` asks for beside SilhouetteOptions, in the same private namespace.
struct SilhouetteNodeOptions {
  static constexpr const char* kStage = "silhouette";
  std::vector<std::string> cameras;
  std::string image_transport = "raw";
  std::string input = "image";
  std::string background_folder;

  void visit(OptionVisitor& v);
  void validate() const;
};

/// What the node `visual_hull` asks for beside HullOptions.
struct HullNodeOptions {
  static constexpr const char* kStage = "visual_hull";
  std::vector<std::string> cameras;
  std::string world_frame = "world";
  std::string rig_file;
  std::string image_transport = "raw";
  bool color = true;
  int min_cameras = 0;
  double stamp_tolerance = 0.005;
  double deadline = 0.5;

  void visit(OptionVisitor& v);
  void validate() const;
  /// min_cameras, or what it stands for when it is 0.
  size_t requiredCameras() const;
};

/// What the node `pose_fitting` asks for beside TrackerOptions.
struct FittingNodeOptions {
  static constexpr const char* kStage = "pose_fitting";
  std::vector<std::string> cameras;
  std::string world_frame = "world";
  std::string rig_file;
  std::string image_transport = "raw";
  double stamp_tolerance = 0.005;
  std::string body_id = "person1";
  std::string urdf_template;
  std::string body_file;

  void visit(OptionVisitor& v);
  void validate() const;
  /// Throws std::invalid_argument unless there are the two cameras that a method which looks at
  /// silhouettes needs.
  void checkCamerasFor(const std::string& method) const;
};

/// What the node `virtual_studio` asks for beside StudioOptions.
struct StudioNodeOptions {
  static constexpr const char* kStage = "virtual_studio";
  std::string body_id = "truth";
  std::string urdf_template;
  std::string world_frame = "world";
  bool clock = false;
  bool wait_for_silhouettes = false;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
