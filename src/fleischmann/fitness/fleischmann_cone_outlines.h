#pragma once

#include <array>

#include "fleischmann/model/fleischmann_body_shape.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Cones are stored as structure of arrays; elements after the tenth are unused.
constexpr int kConeLanes = 16;
using ConeFloats = std::array<float, kConeLanes>;

/// A 3-vector per cone.
using ConeVectors = std::array<ConeFloats, 3>;

/// The ten cones in the world.
struct alignas(32) FleischmannWorldCones {
  ConeVectors a, b;    ///< centres of the ends
  ConeVectors u, v;    ///< half axes at a
  ConeVectors un, vn;  ///< u and v divided by their squared lengths
  ConeVectors growth;  ///< gradient of the scale along the axis; the scale at a is 1
  ConeFloats taper;
};

/// Places the cones in the world.
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

/// Corners of the cones' outlines, pixels, in the order a, b, b, a around each outline.
struct alignas(32) ConeCorners {
  std::array<ConeFloats, 4> x, y;
  /// 0 if a cone has no outline: seen along its axis, or not completely in front of the camera.
  std::array<int, kConeLanes> seen;
};

/// A camera in single precision with the full lens model, for many points at once.
class ViewCamera {
 public:
  /// \param downsampling integer factor by which the image is reduced
  ViewCamera(const Camera& camera, int downsampling);

  int width() const { return width_; }
  int height() const { return height_; }
  Eigen::Vector3f position() const { return Eigen::Map<const Eigen::Vector3f>(numbers_.position); }
  /// The visible contour of a truncated cone consists of two of its straight lines: those whose
  /// tangent plane contains the camera centre. The corners are the ends of these lines.
  void outlines(const FleischmannWorldCones& cones, ConeCorners& out) const;

  /// Plain numbers for the projection.
  struct Numbers {
    float R[3][3], t[3];  ///< world to camera
    float position[3];
    float fx, skew, cx, fy, cy;
    float k[8];   ///< OpenCV order
    float reach;  ///< largest squared radius of undistorted image-plane points; of a fisheye the
                  ///< largest angle to the axis, rad
    bool fisheye;
  };

 private:
  int width_, height_;
  Numbers numbers_;
};

}  // namespace markerless_mocap
