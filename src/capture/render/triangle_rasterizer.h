#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core/types.hpp>
#include <vector>

#include "capture/render/sample_grid.h"
#include "capture/scene/lit_scene.h"

namespace markerless_mocap {

/// What a ray of the grid meets first.
struct Sample {
  enum Kind : uint8_t { kNothing, kObject, kPerson };
  float depth;  ///< z in the camera's frame, infinity for nothing
  uint8_t bgr[3];
  Kind kind;
};

/// The part of a grid that the objects of a scene may cover, with what its rays meet.
struct SampleBuffer {
  cv::Rect rect;                ///< of grid places; even corner and whole pixels
  std::vector<Sample> samples;  ///< row by row

  const Sample* row(int y) const { return &samples[size_t(y - rect.y) * rect.width - rect.x]; }
  Sample* row(int y) { return &samples[size_t(y - rect.y) * rect.width - rect.x]; }
};

/// Draws all triangles of the scene, front and back, with a depth buffer. Neighbours that share an
/// edge leave no gap and no ray to both.
SampleBuffer rasterize(const SampleGrid& grid, const LitScene& scene);

}  // namespace markerless_mocap
