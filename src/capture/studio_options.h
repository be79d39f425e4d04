#pragma once

#include <string>

#include "capture/degradation_options.h"
#include "character/character_options.h"
#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the virtual studio.
struct StudioOptions {
  static constexpr const char* kStage = "virtual_studio";
  /// what the person does: name of a file in config/motions, or path of a .yaml or .bvh file
  std::string motion = "wave_and_walk";
  /// time of the motion that is skipped at its start, s
  double motion_start = 0.0;
  /// radius of the circle that the path over the floor is bent to, m; positive: to the left;
  /// negative: to the right; 0: not bent
  double bend_radius = 0.0;
  /// length of the film after the empty room, s; longer than the motion: the motion is repeated; 0:
  /// the motion once
  double duration = 0.0;
  /// largest distance of a joint from the centre in x and in y, m
  double volume_half_width = 1.8;
  /// ring8, ring7_overhead, ring4, ring16, ceiling4, random8, wide6 (fisheye lenses) or path of a
  /// rig file; the cameras of the named rigs are cam0, cam1, ...
  std::string rig = "ring7_overhead";
  /// image width, px; a rig file has its own
  int width = 640;
  /// image height, px; a rig file has its own
  int height = 480;
  /// first radial distortion coefficient; random8, wide6 and rig files have their
  /// own
  double distortion_k1 = 0.0;
  /// frame rate, Hz
  double fps = 30.0;
  /// number of frame sets of the empty room at the start
  int background_frames = 30;
  /// seed of the room, of the random rig and of all degradations
  int seed = 1;
  /// path of a rigged character (glTF, Collada, FBX) in place of the generated person, of whose
  /// options it uses only stature
  std::string character_file;
  CharacterOptions character;
  DegradationOptions degradations;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
