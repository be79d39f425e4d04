#include "markerless_mocap/tracking/person_options.h"

namespace markerless_mocap {

void PersonOptions::visit(OptionVisitor& v) {
  v.field("stature", stature, 0.5, 2.5, "height of the person, m");
  v.field("measure", measure,
          "estimate the shape of the body from the first poses (contour); false: the "
          "proportions follow from the stature");
  v.field("stature_sigma", stature_sigma, 0.001, 1.0,
          "standard deviation of the error of `stature` when the shape is estimated, m");
  v.field("shape_poses", shape_poses, 5, 300,
          "number of different poses that the shape is estimated from");
}

}  // namespace markerless_mocap
