#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Silhouettes of a person at one time, by camera: CV_8UC1, 0 background, 255 person, 128 unknown;
/// empty where an image is missing.
using SilhouetteSet = std::vector<cv::Mat>;

/// Where the floor is, as a person walked on it.
struct WalkFloor {
  /// From the rig's world to one with z up, the floor at z = 0, the origin amid the places where
  /// the person trod, and x as near to the old x as it can be.
  Eigen::Isometry3d new_old = Eigen::Isometry3d::Identity();
  int steps = 0;            ///< frame sets in which a sole was found
  double scatter = 0.0;     ///< m: how far soles lie from one plane, root mean square
  double extent = 0.0;      ///< m: how far apart they are
  double tilt_sigma = 0.0;  ///< rad: standard deviation of the upward direction
  double stature = 0.0;     ///< m: from the floor to the highest point, upper quartile
};

/// Finds floor and up from a person who walks or stands in several places: soles lie on one plane,
/// the head is above. Uses the visual hull of each frame set around where the silhouettes' middles
/// meet, so no volume need be known; the scale is that of the cameras' places. Throws
/// std::invalid_argument with a sentence that says what is missing.
/// \param cameras at least two; their world may lie in any way
WalkFloor floorFromWalk(const CameraRig& cameras, const std::vector<SilhouetteSet>& frame_sets);

}  // namespace markerless_mocap
