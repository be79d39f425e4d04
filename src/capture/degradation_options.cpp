#include "capture/degradation_options.h"

namespace markerless_mocap {

void DegradationOptions::visit(OptionVisitor& v) {
  v.field("noise_stddev", noise_stddev, 0, 40,
          "standard deviation of the sensor noise, grey levels of 255");
  v.field("flicker", flicker, 0, 0.3, "relative standard deviation of the brightness of the light");
  v.field("shadow_strength", shadow_strength, 0, 1,
          "fraction of the light of a lamp that a shadow takes");
  v.field("camouflage", camouflage, 0, 1,
          "how close the colours of the clothes are to the wall's; 1: equal");
  v.field("mask_damage", mask_damage, 0, 1,
          "amount of holes, specks and ragged edges in the silhouettes that the studio gives; 0.5: "
          "one pixel of twenty is lost");
  v.field("calibration_error_px", calibration_error_px, 0, 50,
          "error of the published calibration, as the shift of a point in the image, px");
  v.field("time_offset_ms", time_offset_ms, 0, 500,
          "a camera takes its image up to half of this before or after its stamp, ms");
  v.field("drop_rate", drop_rate, 0, 0.9, "fraction of the images that are missing");
  v.field("exposure_ms", exposure_ms, 0, 200, "exposure time, ms");
  v.field("second_person_distance", second_person_distance, 0, 10,
          "distance of a second person from the centre, m; 0: nobody");
  v.field("chair_distance", chair_distance, 0, 10,
          "distance of a chair behind the centre, at -x, also in the empty room, m; 0: no chair; "
          "0.4: where sit_couch sits");
  v.field("brought_chair_distance", brought_chair_distance, 0, 10,
          "distance of a chair behind the centre, at -x, that comes with the person and is not in "
          "the empty room, m; 0: no chair; 0.4: where sit_couch sits");
  v.field("brought_box_distance", brought_box_distance, 0, 10,
          "distance from the centre of a box that is put down 2 s after the person has come, m; 0: "
          "no box");
  v.field("moved_box_shift", moved_box_shift, 0, 5,
          "way by which a box 1.9 m from the centre is moved 2 s after the person has come, m; 0: "
          "no box");
  v.field("door_angle", door_angle, 0, 120,
          "angle by which a door opens 1 s after the person has come, and shuts, every 6 s, "
          "degrees; 0: no door");
  v.field("bystander_distance", bystander_distance, 0, 10,
          "distance from the centre of a bystander who is there all the time and fidgets; masks do "
          "not show him, m; 0: nobody");
  v.field("screen_width", screen_width, 0, 4,
          "width of a screen on a wall that plays a film all the time, m; 0: no screen");
  v.field("window_width", window_width, 0, 4,
          "width of a window with trees that move in the wind all the time, m; 0: no window");
  v.field("light_switch", light_switch, 0, 1,
          "fraction of the main lamp's light that goes off 2 s after the person has come, on 2 s "
          "later, and so on");
  v.field("sun_patches", sun_patches, 0, 3,
          "brightness of patches of sun that wander over the floor all the time, relative to the "
          "lamps'");
  v.field("auto_exposure", auto_exposure, 0, 1,
          "how much each camera's exposure follows its image; 1: the mean brightness stays that of "
          "the empty room");
  v.field("auto_white_balance", auto_white_balance, 0, 1,
          "how much each camera's white balance follows its image; 1: the mean colour stays that "
          "of the empty room");
  v.field("floor_reflection", floor_reflection, 0, 1,
          "fraction of the light that the floor mirrors, seen from above; more from the side");
}

}  // namespace markerless_mocap
