#include "markerless_mocap/tracking/person_options.h"

namespace markerless_mocap {

void PersonOptions::visit(OptionVisitor& v) {
  v.field("stature", stature, 0.5, 2.5, "height of the person, m");
  v.field("measure", measure,
          "whether the body's sizes are measured before the first pose is claimed (contour); "
          "false: proportions of the stature");
  v.field("stature_deviation", stature_deviation, 0.001, 1.0,
          "standard deviation of the stature's error when the body is measured, m");
  v.field("measuring_poses", measuring_poses, 5, 300,
          "different poses that the body is measured from");
}

}  // namespace markerless_mocap
