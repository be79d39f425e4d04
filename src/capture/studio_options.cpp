#include "capture/studio_options.h"

namespace markerless_mocap {

void StudioOptions::visit(OptionVisitor& v) {
  v.field(
      "motion", motion, {},
      "what the person does: name of a file in config/motions, or path of a .yaml or .bvh file");
  v.field("motion_start", motion_start, 0, 3600, "seconds of the motion that are left out");
  v.field("bend_radius", bend_radius, -20, 20,
          "the way over the floor is wound up on a circle of this radius, m; negative: to the "
          "right; 0: as it is");
  v.field("duration", duration, 0, 3600,
          "length of the motion after the empty room, s; 0: once through; longer: over and over");
  v.field("stage", stage, 0.5, 20,
          "no joint may go further from the centre in x or y than this, m");
  v.field(
      "rig", rig, {},
      "ring8, ring7_overhead, ring4, ceiling4, random8 or path of a rig file; cameras are named "
      "cam0, cam1, ...");
  v.field("width", width, 16, 8192, "image width, pixels; a rig file has its own");
  v.field("height", height, 16, 8192, "image height, pixels; a rig file has its own");
  v.field("distortion_k1", distortion_k1, -0.2, 0.2,
          "first radial distortion coefficient; random8 and rig files have their own");
  v.field("fps", fps, 1, 240, "instants per second");
  v.field("background_frames", background_frames, 0, 10000,
          "instants of the empty room at the start");
  v.field("seed", seed, 0, 1000000000, "of the room, the random rig and all troubles");
  v.field("character_file", character_file, {},
          "path of a rigged character (glTF, Collada, FBX) in place of the generated person; only "
          "`stature` of the keys below is then used");
  character.visit(v);
  degradations.visit(v);
}

void StudioOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
