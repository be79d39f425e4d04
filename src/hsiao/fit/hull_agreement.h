#pragma once

#include "hsiao/fit/hull_distance_field.h"
#include "hsiao/model/hsiao_body_shape.h"

namespace markerless_mocap {

/// Mutual coverage of a body and a hull, both 0 to 1.
struct HullAgreement {
  double hull_explained = 0.0;  ///< fraction of the hull's voxels within `margin` of the body
  double body_in_hull = 0.0;    ///< fraction of the body's volume inside the hull
};

/// \param margin maximum distance of a voxel centre outside the body, metres
HullAgreement measureHullAgreement(const HsiaoBodyShape& shape, const HsiaoFrames& frames,
                                   const VisualHull& hull, const HullDistanceField& field,
                                   double margin);

}  // namespace markerless_mocap
