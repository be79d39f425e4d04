#pragma once

#include <array>

#include "fleischmann/model/fleischmann_body_shape.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Cones stand side by side in vectors; the places behind the tenth are empty.
constexpr int kConeLanes = 16;
using ConeFloats = std::array<float, kConeLanes>;

/// A vector of three for each cone.
using ConeVectors = std::array<ConeFloats, 3>;

/// The ten cones in the world.
struct alignas(32) FleischmannWorldCones {
  ConeVectors a, b;    ///< centres of the ends
  ConeVectors u, v;    ///< half axes at a
  ConeVectors un, vn;  ///< the same, divided by their squared lengths
  ConeVectors growth;  ///< gradient of the size along the axis; 1 at a
  ConeFloats taper;
};

/// Brings the cones to where their segments are.
class ConePlacer {
 public:
  explicit ConePlacer(const FleischmannBodyShape& body);
  void place(const FleischmannFrames& frames, FleischmannWorldCones& out) const;

 private:
  struct Local {
    FleischmannSegment segment;
    Eigen::Vector3d a, b, u, v;
    double inverse_u, inverse_v, growth;
  };
  std::array<Local, kFleischmannConeCount> cones_;
  ConeFloats taper_;
};

/// Corners of the cones' outlines in the order a, b, b, a around each, pixels.
struct alignas(32) ConeCorners {
  std::array<ConeFloats, 4> x, y;
  /// 0 where a cone has no outline: seen along its axis, or not wholly before the camera.
  std::array<int, kConeLanes> seen;
};

/// A camera in single precision for many points at once, with the full lens model.
class ViewCamera {
 public:
  /// \param reduction whole number by which the image is made smaller
  ViewCamera(const Camera& camera, int downsampling);

  int width() const { return width_; }
  int height() const { return height_; }
  /// The visible contour of a truncated cone is two of its straight lines: those along which the
  /// tangent plane holds the camera. Their ends are the corners.
  void outlines(const FleischmannWorldCones& cones, ConeCorners& out) const;

  /// What the projection needs; plain numbers.
  struct Numbers {
    float R[3][3], t[3];  ///< world to camera
    float position[3];
    float fx, skew, cx, fy, cy;
    float k[8];                ///< OpenCV order
    float max_radius_squared;  ///< of undistorted image-plane points
  };

 private:
  int width_, height_;
  Numbers numbers_;
};

}  // namespace markerless_mocap
