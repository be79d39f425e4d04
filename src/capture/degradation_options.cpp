#include "capture/degradation_options.h"

namespace markerless_mocap {

void DegradationOptions::visit(OptionVisitor& v) {
  v.field("noise_levels", noise_levels, 0, 40,
          "standard deviation of the sensor noise, grey levels of 255");
  v.field("flicker", flicker, 0, 0.3, "standard deviation of the light's brightness, relative");
  v.field("shadow_strength", shadow_strength, 0, 1, "how much of a lamp's light its shadow takes");
  v.field("camouflage", camouflage, 0, 1,
          "how far the colours of the clothes go towards the wall's: 1 is the wall's own");
  v.field("mask_damage", mask_damage, 0, 1,
          "holes, specks and ragged edges in the silhouettes that the studio gives: 0.5 loses one "
          "pixel of twenty");
  v.field("calibration_error_px", calibration_error_px, 0, 50,
          "how far off the cameras' calibration as told puts a point in the image, pixels");
  v.field("time_offset_ms", time_offset_ms, 0, 500,
          "a camera takes its picture up to half of this before or after its stamp, ms");
  v.field("drop_rate", drop_rate, 0, 0.9, "share of the images that go missing");
  v.field("exposure_ms", exposure_ms, 0, 200, "how long the shutter is open, ms");
  v.field("second_person", second_person, 0, 10,
          "another person acts this far from the centre, m; 0: nobody");
  v.field(
      "chair", chair, 0, 10,
      "a chair stands this far behind the centre, at -x, also in the empty room, m; 0: none; 0.4 "
      "is where sit_couch sits");
}

}  // namespace markerless_mocap
