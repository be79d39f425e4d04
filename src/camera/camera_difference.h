#pragma once

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Whether images of one camera, taken for those of the other one, would mislead: their positions
/// differ by more than 1 cm, or the rays of the middle or a corner of the image by more than 3 mrad
/// (1 cm in a distance of 3 m), or their images have other sizes.
bool seeDifferently(const Camera& a, const Camera& b);

}  // namespace markerless_mocap
