#pragma once

#include <opencv2/core/mat.hpp>

#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// Fills false holes, which the test of single pixels leaves where the person looks like the
/// background: narrow gaps and holes whose surroundings have the colour of the background inside.
/// If the colours differ, the hole is real.
/// \param gain light of the image relative to the background's
/// \param max_hole_px holes up to this area are always filled; those up to fifty times that if they
///   are false
void fillFalseHoles(const cv::Mat& image, const Background& background, double gain,
                    int max_hole_px, BitMask* mask);

}  // namespace markerless_mocap
