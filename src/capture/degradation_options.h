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
  /// distance of a chair behind the centre, at -x, that comes with the person and is not in the
  /// empty room, m; 0: no chair; 0.4: where sit_couch sits
  double brought_chair_distance = 0.0;
  /// distance from the centre of a box that is put down 2 s after the person has come, m; 0: no box
  double brought_box_distance = 0.0;
  /// way by which a box 1.9 m from the centre is moved 2 s after the person has come, m; 0: no box
  double moved_box_shift = 0.0;
  /// angle by which a door opens 1 s after the person has come, and shuts, every 6 s, degrees; 0:
  /// no door
  double door_angle = 0.0;
  /// distance from the centre of a bystander who is there all the time and fidgets; masks do not
  /// show him, m; 0: nobody
  double bystander_distance = 0.0;
  /// width of a screen on a wall that plays a film all the time, m; 0: no screen
  double screen_width = 0.0;
  /// width of a window with trees that move in the wind all the time, m; 0: no window
  double window_width = 0.0;
  /// fraction of the main lamp's light that goes off 2 s after the person has come, on 2 s later,
  /// and so on
  double light_switch = 0.0;
  /// brightness of patches of sun that wander over the floor all the time, relative to the lamps'
  double sun_patches = 0.0;
  /// how much each camera's exposure follows its image; 1: the mean brightness stays that of the
  /// empty room
  double auto_exposure = 0.0;
  /// how much each camera's white balance follows its image; 1: the mean colour stays that of the
  /// empty room
  double auto_white_balance = 0.0;
  /// fraction of the light that the floor mirrors, seen from above; more from the side
  double floor_reflection = 0.0;

  void visit(OptionVisitor& v);
};

}  // namespace markerless_mocap
