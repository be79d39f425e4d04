#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "capture/virtual_studio.h"

namespace markerless_mocap {

/// What to film and how to write it.
struct RenderOptions {
  std::string output;  ///< bag to write
  StudioOptions studio;
  StudioFiles files;
  std::string body_id = "truth";    ///< of the driven body
  std::string images = "raw";       ///< raw, jpeg or none
  int jpeg_quality = 92;            ///< 1 to 100
  bool masks = false;               ///< write <camera>/silhouette, spoilt by mask_damage
  std::string compression = "lz4";  ///< of the bag: lz4 or none
  std::string rig_out;              ///< rig file to write, or empty
  std::function<bool()> interrupted = [] { return false; };  ///< asked at every instant
};

/// What has been written.
struct RenderSummary {
  int cameras = 0, frame_sets = 0, background = 0, dropped = 0;
  double stature = 0.0;  ///< of the person, m
  double seconds = 0.0;  ///< of film
};

/// Films the empty room and then the motion into a bag: images, camera_info, latched tf_static,
/// /ground_truth/joints, joint_states, <camera>/silhouette and the latched human_description. The
/// first stamp is 1000 s. Same options, same bytes; the bag appears only when it is whole. Throws
/// as VirtualStudio, on bad options here, and when interrupted. \param notes where progress goes;
/// nullptr: nowhere \param terminal whether it is a terminal
RenderSummary renderCapture(const RenderOptions& options, std::ostream* notes, bool terminal);

void print(const RenderSummary& summary, std::ostream& out);

}  // namespace markerless_mocap
