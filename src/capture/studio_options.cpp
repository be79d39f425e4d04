#include "markerless_mocap/capture/studio_options.h"

namespace markerless_mocap {

void StudioOptions::visit(OptionVisitor& v) {
  v.field("cameras", cameras, 2, 32, "cameras, named cam0, cam1, ...");
  v.field("overhead", overhead, "the last camera hangs above the centre instead of in the ring");
  v.field("width", width, 16, 8192, "image width, pixels");
  v.field("height", height, 16, 8192, "image height, pixels");
  v.field("horizontal_view_deg", horizontal_view_deg, 10, 140, "horizontal field of view, degrees");
  v.field("ring_radius", ring_radius, 1, 20, "horizontal distance of the ring from the centre, m");
  v.field("ring_height", ring_height, 0.1, 10, "height of the ring above the floor, m");
  v.field("overhead_height", overhead_height, 2.5, 20,
          "height of the overhead camera above the floor, m");
  v.field("distortion_k1", distortion_k1, -0.2, 0.2, "first radial distortion coefficient");
  v.field("fps", fps, 1, 240, "instants per second");
  v.field("duration", duration, 0.1, 3600, "length of the motion after the empty room, s");
  v.field("background_frames", background_frames, 0, 10000,
          "instants of the empty room at the start");
  v.field("stature", stature, 0.5, 2.5, "of the person, m");
  v.field("walk_radius", walk_radius, 0.2, 10, "radius of the circle that is walked, m");
  v.field("walk_speed", walk_speed, 0, 1.5, "of the person, m/s");
  v.field("noise_levels", noise_levels, 0, 40,
          "standard deviation of the sensor noise, grey levels of 255");
  v.field("seed", seed, 0, 1000000000, "of the sensor noise");
}

void StudioOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
