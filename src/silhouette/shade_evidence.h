#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Makes those shades foreground that are clothes, not shadow. Two kinds of evidence weigh
/// together: a shadow keeps the texture of what it falls on, so its brightness ratio hardly varies
/// within a window; and clothes have more of the person below them and beside them, a shadow on the
/// floor has not. \param shade_ratio CV_32FC1, brightness relative to the background's; 0 where
/// there is no shade \param mask CV_8UC1, 0 | 255, in and out
void restoreClothes(const cv::Mat& shade_ratio, cv::Mat* mask);

enum Side : uint8_t { kLeft = 1, kRight = 2, kAbove = 4, kBelow = 8 };

/// The sides on which a pixel has foreground within `reach` pixels.
/// \param mask CV_8UC1, non-zero = foreground; returns CV_8UC1, Side bits
cv::Mat enclosingSides(const cv::Mat& mask, int reach);

}  // namespace markerless_mocap
