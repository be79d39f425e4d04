#pragma once

#include <opencv2/core/mat.hpp>

#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// Fills what a test of each pixel has missed of the person: narrow gaps and holes around which the
/// person looks like the background inside. Where it does not, one looks through a real gap.
/// \param gain light of the image relative to the background's
/// \param max_hole_px holes up to this area are filled anyhow, those up to fifty times that if
/// missed
void fillFalseHoles(const cv::Mat& image, const Background& background, double gain,
                    int max_hole_px, BitMask* mask);

}  // namespace markerless_mocap
