#pragma once

#include <opencv2/core/mat.hpp>

#include "capture/render/sample_grid.h"
#include "capture/scene/lit_scene.h"
#include "capture/scene/textured_room.h"

namespace markerless_mocap {

/// Reflections on the floor in one camera. The floor reflects more at a low angle (Schlick, An
/// Inexpensive BRDF Model for Physically-based Rendering, 1994). Immutable.
class FloorMirror {
 public:
  /// \param reflection 0 to 1: fraction of the light that is reflected at right angles
  FloorMirror(const Camera& camera, const SampleGrid& grid, const TexturedRoom& room,
              double reflection);

  /// Adds the reflections of the empty room to its picture, CV_8UC3.
  void addRoom(cv::Mat& picture) const;
  /// Puts the reflections of the scene's objects in place of the room's.
  void addObjects(const SampleGrid& grid, const LitScene& scene, cv::Mat& image) const;

 private:
  cv::Mat reflected_;  ///< CV_32FC1: fraction of the light of each pixel that is a reflection
  cv::Mat room_;       ///< CV_8UC3: the empty room in the mirror
};

}  // namespace markerless_mocap
