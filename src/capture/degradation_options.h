#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Degradations of the rendered images, one number each; 0 switches one off. A part of the studio's
/// section.
struct DegradationOptions {
  static constexpr const char* kStage = "virtual_studio";
  /// standard deviation of the sensor noise, grey levels of 255
  double noise_stddev = 3.0;
  /// relative standard deviation of the brightness of the light
  double flicker = 0.01;
  /// fraction of the light of a lamp that a shadow takes
  double shadow_strength = 0.35;
  /// how close the colours of the clothes are to the wall's; 1: equal
  double camouflage = 0.0;
  /// amount of holes, specks and ragged edges in the silhouettes that the studio gives; 0.5: one
  /// pixel of twenty is lost
  double mask_damage = 0.0;
  /// error of the published calibration, as the shift of a point in the image, px
  double calibration_error_px = 0.0;
  /// a camera takes its image up to half of this before or after its stamp, ms
  double time_offset_ms = 0.0;
  /// fraction of the images that are missing
  double drop_rate = 0.0;
  /// exposure time, ms
  double exposure_ms = 0.0;
  /// distance of a second person from the centre, m; 0: nobody
  double second_person_distance = 0.0;
  /// distance of a chair behind the centre, at -x, also in the empty room, m; 0: no chair; 0.4:
  /// where sit_couch sits
  double chair_distance = 0.0;

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
