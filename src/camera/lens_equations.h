#pragma once

#include <cmath>

namespace markerless_mocap {

/// The distorted image-plane point of an undistorted one. Source: OpenCV's calib3d.
/// \param k k1 k2 p1 p2 k3 k4 k5 k6
template <class T>
void distortPolynomial(const T* k, const T& x, const T& y, T* out) {
  const T s = x * x + y * y;
  const T radial =
      (T(1) + s * (k[0] + s * (k[1] + s * k[4]))) / (T(1) + s * (k[5] + s * (k[6] + s * k[7])));
  out[0] = x * radial + T(2) * k[2] * x * y + k[3] * (s + T(2) * x * x);
  out[1] = y * radial + k[2] * (s + T(2) * y * y) + T(2) * k[3] * x * y;
}

/// The distorted image-plane point of a point in the camera's frame, which may lie beside or behind
/// the camera. Source: Kannala and Brandt (2006), as OpenCV's fisheye has it: the angle to the axis
/// gives the radius. \param k k1 k2 k3 k4
template <class T>
void distortFisheye(const T* k, const T* p, T* out) {
  using std::atan2;
  using std::sqrt;
  const T squared = p[0] * p[0] + p[1] * p[1];
  if (!(squared > T(0))) {  // the root has no derivative on the axis
    out[0] = p[0] / p[2];
    out[1] = p[1] / p[2];
    return;
  }
  const T across = sqrt(squared), angle = atan2(across, p[2]), s = angle * angle;
  const T factor = angle * (T(1) + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3])))) / across;
  out[0] = factor * p[0];
  out[1] = factor * p[1];
}

}  // namespace markerless_mocap
