#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

#include "capture/render/sample_grid.h"
#include "capture/scene/lit_scene.h"

namespace markerless_mocap {

/// The first hit of a ray of the grid.
struct Sample {
  enum Kind : uint8_t { kNothing, kObject, kPerson };
  float depth;  ///< z in the camera's frame, metres; infinity: no hit
  uint8_t bgr[3];
  Kind kind;
};

/// The part of a grid that the objects of a scene may cover, with the hits of its rays.
struct SampleBuffer {
  cv::Rect rect;  ///< in grid positions; starts at an even position and covers whole pixels
  std::vector<Sample> samples;  ///< row by row

  const Sample* row(int y) const { return &samples[size_t(y - rect.y) * rect.width - rect.x]; }
  Sample* row(int y) { return &samples[size_t(y - rect.y) * rect.width - rect.x]; }
};

/// Draws all triangles of the scene, front and back, with a depth buffer. A ray through the common
/// edge of two triangles hits exactly one of them.
/// \param mirrored draw the scene below the floor, as if the floor were a mirror
SampleBuffer rasterize(const SampleGrid& grid, const LitScene& scene, bool mirrored = false);

}  // namespace markerless_mocap
