#include "capture/studio_options.h"

namespace markerless_mocap {

void StudioOptions::visit(OptionVisitor& v) {
  v.field(
      "motion", motion, {},
      "what the person does: name of a file in config/motions, or path of a .yaml or .bvh file");
  v.field("motion_start", motion_start, 0, 3600,
          "time of the motion that is skipped at its start, s");
  v.field("bend_radius", bend_radius, -20, 20,
          "radius of the circle that the path over the floor is bent to, m; positive: to the left; "
          "negative: to the right; 0: not bent");
  v.field("duration", duration, 0, 3600,
          "length of the film after the empty room, s; longer than the motion: the motion is "
          "repeated; 0: the motion once");
  v.field("volume_half_width", volume_half_width, 0.5, 20,
          "largest distance of a joint from the centre in x and in y, m");
  v.field("rig", rig, {},
          "ring8, ring7_overhead, ring4, ring16, ceiling4, random8, wide6 (fisheye lenses) or path "
          "of a rig file; the cameras of the named rigs are cam0, cam1, ...");
  v.field("width", width, 16, 8192, "image width, px; a rig file has its own");
  v.field("height", height, 16, 8192, "image height, px; a rig file has its own");
  v.field("distortion_k1", distortion_k1, -0.2, 0.2,
          "first radial distortion coefficient; random8, wide6 and rig files have their own");
  v.field("fps", fps, 1, 240, "frame rate, Hz");
  v.field("background_frames", background_frames, 0, 10000,
          "number of frame sets of the empty room at the start");
  v.field("seed", seed, 0, 1000000000,
          "seed of the room, of the random rig and of all degradations");
  v.field("character_file", character_file, {},
          "path of a rigged character (glTF, Collada, FBX) in place of the generated person, of "
          "whose options it uses only stature");
  character.visit(v);
  degradations.visit(v);
}

void StudioOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
