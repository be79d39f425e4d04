#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "capture/virtual_studio.h"

namespace markerless_mocap {

/// Options of a rendered capture.
struct RenderOptions {
  std::string output;  ///< bag to write
  StudioOptions studio;
  StudioFiles files;
  std::string body_id = "truth";    ///< of the rendered person
  std::string images = "raw";       ///< raw, jpeg or none
  int jpeg_quality = 92;            ///< 1 to 100
  bool masks = false;               ///< also write <camera>/silhouette, degraded by mask_damage
  std::string compression = "lz4";  ///< of the bag: lz4 or none
  std::string rig_out;              ///< rig file to write, or empty
  std::function<bool()> interrupted = [] { return false; };  ///< called for every frame set
};

/// Summary of a capture.
struct RenderSummary {
  int cameras = 0, frame_sets = 0, background = 0, dropped = 0;
  double stature = 0.0;  ///< of the person, m
  double seconds = 0.0;  ///< duration
};

/// Renders the empty room and then the motion into a bag: images, camera_info, latched tf_static,
/// /ground_truth/joints, joint_states, <camera>/silhouette and the latched human_description. The
/// first stamp is 1000 s. The same options give the same bytes. The bag appears only if it is
/// complete. Throws as VirtualStudio, on invalid options, and if interrupted.
/// \param notes stream for the progress; nullptr: none
/// \param terminal true if `notes` is a terminal
RenderSummary renderCapture(const RenderOptions& options, std::ostream* notes, bool terminal);

void print(const RenderSummary& summary, std::ostream& out);

}  // namespace markerless_mocap
