#pragma once

#include <opencv2/core/mat.hpp>

#include "fleischmann/fitness/fleischmann_cone_outlines.h"
#include "fleischmann/fleischmann_fitness.h"

namespace markerless_mocap {

/// Sum of the edge map at points along the edges of the body, and the number of these points in the
/// image.
struct EdgeSum {
  int64_t sum = 0;  ///< of values 0 to 255
  int points = 0;
};

/// Whether a point of the image, at a fraction of the axis of its cone, is hidden by another cone.
class HiddenPoints {
 public:
  HiddenPoints(const ConeCorners& corners, const FleischmannWorldCones& cones,
               const Eigen::Vector3f& camera);
  bool operator()(int cone, float along, float x, float y) const;

 private:
  struct Outline {
    float x[4], y[4];  ///< corners, pixels
    float low_x, high_x, low_y, high_y;
    float axis_x, axis_y;     ///< along the axis; scaled so that its end is at 1
    float near_end, far_end;  ///< distances of the axis' ends from the camera, m
    bool seen;
  };
  static bool contains(const Outline& outline, float x, float y);

  std::array<Outline, kFleischmannConeCount> outlines_;
};

/// \param samples points per edge, at the centres of equal sections
/// \param hidden points that are left out; nullptr: none
EdgeSum sampleEdges(const ConeCorners& corners, const cv::Mat& map, const EdgeSelection& choice,
                    int samples, const HiddenPoints* hidden = nullptr);

}  // namespace markerless_mocap
