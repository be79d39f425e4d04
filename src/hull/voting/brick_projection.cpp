#include "hull/voting/brick_projection.h"

#include "camera/lens_distortion.h"
#include "camera/lens_equations.h"
#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

/// The image-plane points of points in the world: the operations of Camera::projectInside() in
/// their order, so that the pixels are the same. \param to_camera rows of a 3 x 4 matrix \param k
/// distortion
MOCAP_WIDEST void distortAll(const double* to_camera, const double* k, int count,
                             const double* __restrict x, const double* __restrict y,
                             const double* __restrict z, double* __restrict depth,
                             double* __restrict squared_radius, double* __restrict distorted_x,
                             double* __restrict distorted_y) {
  const double *m = to_camera, *n = to_camera + 4, *o = to_camera + 8;
  for (int i = 0; i < count; ++i) {
    depth[i] = o[0] * x[i] + o[1] * y[i] + o[2] * z[i] + o[3];
    const double across = (m[0] * x[i] + m[1] * y[i] + m[2] * z[i] + m[3]) / depth[i];
    const double down = (n[0] * x[i] + n[1] * y[i] + n[2] * z[i] + n[3]) / depth[i];
    squared_radius[i] = across * across + down * down;
    double distorted[2];
    distortPolynomial(k, across, down, distorted);
    distorted_x[i] = distorted[0];
    distorted_y[i] = distorted[1];
  }
}

}  // namespace

BrickProjection::BrickProjection(const Camera& camera, const VoxelLattice& lattice)
    : camera_(camera),
      lattice_(lattice),
      lens_(lensNumbersOf(camera.calibration())),
      to_camera_(camera.calibration().T_world_camera.inverse().matrix().topRows<3>()) {}

int BrickProjection::project(const Eigen::Vector3i& corner, VoxelPixel (&pixels)[kVoxels]) const {
  const Eigen::Vector3i end = (corner.array() + kBrickSide).min(lattice_.size.array());
  Points points;
  int voxels[kVoxels], count = 0;
  for (int z = corner.z(); z < end.z(); ++z)
    for (int y = corner.y(); y < end.y(); ++y)
      for (int x = corner.x(); x < end.x(); ++x, ++count) {
        const Eigen::Vector3d center =
            lattice_.origin + lattice_.pitch * (Eigen::Array3d(x, y, z) + 0.5).matrix();
        points.x[count] = center.x();
        points.y[count] = center.y();
        points.z[count] = center.z();
        voxels[count] =
            x - corner.x() + kBrickSide * (y - corner.y() + kBrickSide * (z - corner.z()));
      }
  if (lens_.type == LensType::kPolynomial)
    distortAll(to_camera_.data(), lens_.k, count, points.x, points.y, points.z, points.depth,
               points.squared_radius, points.distorted_x, points.distorted_y);
  int seen = 0;
  for (int i = 0; i < count; ++i)
    if (const auto pixel = pixelOf(points, i))
      pixels[seen++] = {voxels[i], int(pixel->x() + 0.5), int(pixel->y() + 0.5)};
  return seen;
}

std::optional<Eigen::Vector2d> BrickProjection::pixelOf(const Points& points, int i) const {
  if (lens_.type != LensType::kPolynomial)
    return camera_.projectInside({points.x[i], points.y[i], points.z[i]});
  if (!(points.depth[i] > 0 && points.squared_radius[i] < lens_.reach)) return std::nullopt;
  const Eigen::Vector2d pixel = camera_.calibration().K.topRows<2>() *
                                Eigen::Vector3d(points.distorted_x[i], points.distorted_y[i], 1);
  if (!camera_.isInImage(pixel)) return std::nullopt;
  return pixel;
}

}  // namespace markerless_mocap
