#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// The masks without the parts that are not of the person: connected parts that the hull does not
/// project into. They are, for example, a lamp that flickers or furniture at the wall, which only
/// one camera sees. A mask stays the same object if no such part is large, if the hull is empty, or
/// if the background is unknown in places: the hull is then uncertain, too.
/// \param masks by camera, CV_8UC1 0 | 128 unknown | 255, empty where missing
/// \param hull called only if a mask has large parts apart from each other
std::vector<cv::Mat> withoutStrayParts(const std::vector<cv::Mat>& masks,
                                       const std::function<const VisualHull&()>& hull,
                                       const CameraRig& rig);

}  // namespace markerless_mocap
