#pragma once

#include "hsiao/fit/hull_distance_field.h"
#include "hsiao/model/hsiao_body_shape.h"

namespace markerless_mocap {

/// How well a body and a hull cover each other, both 0 to 1.
struct HullAgreement {
  double hull_explained = 0.0;  ///< share of the hull's voxels within `margin` of the body
  double body_in_hull = 0.0;    ///< share of the body's volume inside the hull
};

/// \param margin metres by which a voxel centre may lie outside the body
HullAgreement measureHullAgreement(const HsiaoBodyShape& shape, const HsiaoFrames& frames,
                                   const VisualHull& hull, const HullDistanceField& field,
                                   double margin);

}  // namespace markerless_mocap
