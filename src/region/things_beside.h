#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "region/placed_body.h"

namespace markerless_mocap {

/// Masks by camera, and whether they were in doubt.
struct ClearedMasks {
  std::vector<cv::Mat> masks;
  std::vector<bool> doubted;  ///< mask and body differ so much that colours are needed
};

/// The masks of a person who is tracked, without what they cannot be. Parts that are beside the
/// predicted body, such as a bystander, become background. Where a mask and the predicted body
/// differ more than a moved limb explains, it becomes unknown: its contours then say nothing, and
/// colours tell the person from a box at their legs, an open door behind them, the sun on the floor
/// at their feet, or trousers that look like the wall. A mask stays as it is where it does not show
/// the predicted body, so that a wrong prediction takes no person away.
/// The masks that are returned are the same objects where nothing is changed.
/// \param masks by camera, CV_8UC1 0 | 128 unknown | 255, empty where missing
/// \param has_colors by camera; false ones may be left out at the end: where no colours can decide
/// little is made unknown, only what is far too large for a limb
/// \param seconds how far ahead the body is predicted; 0: it is fitted to these masks, and believed
/// even if they show little of it. After more than 0.12 s it may be wrong by more than what is
/// beside the person: then masks are treated as without colours, and none is in doubt
ClearedMasks withoutThingsBeside(const std::vector<cv::Mat>& masks,
                                 const std::vector<bool>& has_colors, const CameraRig& rig,
                                 const PlacedBody& predicted, double seconds);

}  // namespace markerless_mocap
