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
}

}  // namespace markerless_mocap
