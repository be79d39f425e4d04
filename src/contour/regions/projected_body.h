#pragma once

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"
#include "region/region_segmenter.h"

namespace markerless_mocap {

/// Samples of the image that are one metre long at the body's pelvis.
/// \param step pixels from one sample to the next
float samplesPerMetre(const Camera& camera, int step, const ContourPose& pose);

/// The body in its pose, as the camera sees it; cones that lie behind the camera are left out.
/// \param step pixels from one sample to the next
/// \param error_m expected error of the outline
ProjectedBody projectedBody(const Camera& camera, int step, const ContourBody& body,
                            const ContourPose& pose, double error_m);

}  // namespace markerless_mocap
