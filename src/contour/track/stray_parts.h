#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// The masks without the parts that are not of the person: connected parts that the hull does not
/// project into. They are, for example, a lamp that flickers or furniture at the wall, which only
/// one camera sees. What is attached to the person and large, such as a patch of sun at their feet,
/// becomes unknown where the hull does not project into it. A mask stays the same object if it
/// shows no such things, if the hull is empty, or if the background is unknown in places: the hull
/// is then uncertain, too. \param masks by camera, CV_8UC1 0 | 128 unknown | 255, empty where
/// missing
std::vector<cv::Mat> withoutStrayParts(const std::vector<cv::Mat>& masks, const VisualHull& hull,
                                       const CameraRig& rig);

}  // namespace markerless_mocap
