#pragma once

#include <bitset>
#include <opencv2/core/mat.hpp>
#include <utility>

#include "fleischmann/fitness/fleischmann_cone_outlines.h"
#include "fleischmann/fleischmann_fitness.h"

namespace markerless_mocap {

/// Sum of the edge map at points along the edges of the body, and the number of these points in the
/// image.
struct EdgeSum {
  int64_t sum = 0;  ///< of values 0 to 255
  int points = 0;
};

/// A line in an image, along the outline of a cone.
struct EdgeLine {
  float x[2], y[2];  ///< ends, pixels
  float along[2];    ///< the ends' places along the cone's axis, 0 to 1
  int samples;       ///< points, at the centres of equal sections
  float at(int i) const { return (float(i) + 0.5f) / float(samples); }
};

/// What the cones hide of each other in one view.
class HiddenPoints {
 public:
  static constexpr int kMaxSamples = 200;
  using Points = std::bitset<kMaxSamples>;

  HiddenPoints(const ConeCorners& corners, const FleischmannWorldCones& cones,
               const Eigen::Vector3f& camera);
  /// The points of a line that another cone hides: those inside its outline where its axis is
  /// nearer to the camera than that of the line's own cone.
  Points on(const EdgeLine& line, int cone) const;

 private:
  struct Outline {
    float x[4], y[4];  ///< corners, pixels; the inside is on the right of each side
    float low_x, high_x, low_y, high_y;
    float start_x, start_y;   ///< where the axis begins
    float axis_x, axis_y;     ///< along the axis; scaled so that its end is at 1
    float near_end, far_end;  ///< distances of the axis' ends from the camera, m
    bool seen;
  };
  /// The part of a line inside an outline, as fractions of it; empty if the first is larger.
  static std::pair<float, float> inside(const Outline& outline, const EdgeLine& line);

  std::array<Outline, kFleischmannConeCount> outlines_;
};

/// \param samples points per edge, at the centres of equal sections
/// \param hidden points that are left out; nullptr: none
EdgeSum sampleEdges(const ConeCorners& corners, const cv::Mat& map, const EdgeSelection& choice,
                    int samples, const HiddenPoints* hidden = nullptr);

}  // namespace markerless_mocap
