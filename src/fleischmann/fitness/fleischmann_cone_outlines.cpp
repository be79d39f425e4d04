#include "fleischmann/fitness/fleischmann_cone_outlines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "camera/lens_distortion.h"
#include "camera/lens_equations.h"
#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

constexpr float kMinDepth = 1e-3f;            // minimum depth, metres
constexpr float kMinSquaredDistance = 1e-6f;  // minimum squared distance from a cone's axis,
                                              // relative to its half axes
constexpr double kMaxRadiusSquared = 1e4;     // on the image plane: 89.4 degrees off the axis

void setLane(ConeVectors& vectors, int lane, const Eigen::Vector3d& value) {
  for (int c = 0; c < 3; ++c) vectors[c][lane] = float(value[c]);
}

/// The camera centre in the frame of each cone, relative to the half axes of its end.
struct CameraPlaces {
  ConeFloats x, y;    ///< perpendicular to the axis
  ConeFloats size;    ///< scale of the cross-section at the height of the camera
  ConeFloats inside;  ///< squared distance from the axis minus the squared scale; positive if the
                      ///< camera is outside the cone
};

// The loops have no branches, so that the compiler vectorises them.
MOCAP_WIDEST void seeCamera(const FleischmannWorldCones& w, const ViewCamera::Numbers& numbers,
                            CameraPlaces& result) {
  const ViewCamera::Numbers n = numbers;
  CameraPlaces out;
  for (int i = 0; i < kConeLanes; ++i) {
    const float dx = n.position[0] - w.a[0][i], dy = n.position[1] - w.a[1][i],
                dz = n.position[2] - w.a[2][i];
    const float x = dx * w.un[0][i] + dy * w.un[1][i] + dz * w.un[2][i];
    const float y = dx * w.vn[0][i] + dy * w.vn[1][i] + dz * w.vn[2][i];
    const float size = 1.0f + dx * w.growth[0][i] + dy * w.growth[1][i] + dz * w.growth[2][i];
    out.x[i] = x;
    out.y[i] = y;
    out.size[i] = size;
    out.inside[i] = x * x + y * y - size * size;
  }
  result = out;
}

/// Directions of the two contour lines, relative to the half axes of an end. The tangent plane
/// contains the camera if cos(t - direction of the camera) = scale / distance.
struct ContourLines {
  ConeFloats cosine[2], sine[2];
};

void findContour(const CameraPlaces& at, ContourLines& out) {
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const float x = at.x[i], y = at.y[i], size = at.size[i];
    const float root = std::sqrt(std::max(at.inside[i], 0.0f));
    const float inverse = 1.0f / std::max(x * x + y * y, kMinSquaredDistance);
    out.cosine[0][i] = (size * x - root * y) * inverse;
    out.sine[0][i] = (size * y + root * x) * inverse;
    out.cosine[1][i] = (size * x + root * y) * inverse;
    out.sine[1][i] = (size * y - root * x) * inverse;
  }
}

/// One corner of all cones.
struct CornerLanes {
  ConeFloats x, y;
  ConeFloats depth;     ///< metres
  ConeFloats off_axis;  ///< as Numbers::reach
};

/// Projects the point of an end's ellipse at (cosine, sine). No branches and no aliasing, so that
/// the compiler vectorises the loop.
MOCAP_WIDEST void projectCorners(const FleischmannWorldCones& w, const ViewCamera::Numbers& numbers,
                                 const ConeVectors& center, const ConeFloats& scale,
                                 const ConeFloats& cosine, const ConeFloats& sine,
                                 CornerLanes& result) {
  const ViewCamera::Numbers n = numbers;
  CornerLanes out;
  for (int i = 0; i < kConeLanes; ++i) {
    const float c = cosine[i] * scale[i], s = sine[i] * scale[i];
    const float px = center[0][i] + c * w.u[0][i] + s * w.v[0][i];
    const float py = center[1][i] + c * w.u[1][i] + s * w.v[1][i];
    const float pz = center[2][i] + c * w.u[2][i] + s * w.v[2][i];
    const float depth = n.R[2][0] * px + n.R[2][1] * py + n.R[2][2] * pz + n.t[2];
    const float inverse = 1.0f / depth;
    const float x = (n.R[0][0] * px + n.R[0][1] * py + n.R[0][2] * pz + n.t[0]) * inverse;
    const float y = (n.R[1][0] * px + n.R[1][1] * py + n.R[1][2] * pz + n.t[1]) * inverse;
    const float r = x * x + y * y;
    const float radial = (1.0f + r * (n.k[0] + r * (n.k[1] + r * n.k[4]))) /
                         (1.0f + r * (n.k[5] + r * (n.k[6] + r * n.k[7])));
    const float u = x * radial + 2.0f * n.k[2] * x * y + n.k[3] * (r + 2.0f * x * x);
    const float v = y * radial + n.k[2] * (r + 2.0f * y * y) + 2.0f * n.k[3] * x * y;
    out.x[i] = n.fx * u + n.skew * v + n.cx;
    out.y[i] = n.fy * v + n.cy;
    out.depth[i] = depth;
    out.off_axis[i] = r;
  }
  result = out;
}

/// As projectCorners(), for a fisheye.
void projectFisheyeCorners(const FleischmannWorldCones& w, const ViewCamera::Numbers& n,
                           const ConeVectors& center, const ConeFloats& scale,
                           const ConeFloats& cosine, const ConeFloats& sine, CornerLanes& out) {
  for (int i = 0; i < kConeLanes; ++i) {
    const float c = cosine[i] * scale[i], s = sine[i] * scale[i];
    float in_world[3], p[3], plane[2];
    for (int k = 0; k < 3; ++k) in_world[k] = center[k][i] + c * w.u[k][i] + s * w.v[k][i];
    for (int k = 0; k < 3; ++k)
      p[k] = n.R[k][0] * in_world[0] + n.R[k][1] * in_world[1] + n.R[k][2] * in_world[2] + n.t[k];
    distortFisheye(n.k, p, plane);
    out.x[i] = n.fx * plane[0] + n.skew * plane[1] + n.cx;
    out.y[i] = n.fy * plane[1] + n.cy;
    out.depth[i] = std::hypot(p[0], p[1], p[2]);
    out.off_axis[i] = std::atan2(std::hypot(p[0], p[1]), p[2]);
  }
}

}  // namespace

ConePlacer::ConePlacer(const FleischmannBodyShape& body) {
  taper_.fill(1.0f);
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const FleischmannCone& cone = body.cones()[i];
    cones_[i] = {cone.segment,
                 cone.a,
                 cone.b,
                 cone.u,
                 cone.v,
                 1.0 / cone.u.squaredNorm(),
                 1.0 / cone.v.squaredNorm(),
                 (cone.taper - 1.0) / (cone.b - cone.a).squaredNorm()};
    taper_[i] = float(cone.taper);
  }
}

void ConePlacer::place(const FleischmannFrames& frames, FleischmannWorldCones& out) const {
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const Local& cone = cones_[i];
    const Eigen::Matrix3d& R = frames.R[cone.segment];
    const Eigen::Vector3d a = R * cone.a, b = R * cone.b, u = R * cone.u, v = R * cone.v;
    setLane(out.a, i, frames.p[cone.segment] + a);
    setLane(out.b, i, frames.p[cone.segment] + b);
    setLane(out.u, i, u);
    setLane(out.v, i, v);
    setLane(out.un, i, cone.inverse_u * u);
    setLane(out.vn, i, cone.inverse_v * v);
    setLane(out.growth, i, cone.growth * (b - a));
  }
  for (ConeVectors* vectors : {&out.a, &out.b, &out.u, &out.v, &out.un, &out.vn, &out.growth})
    for (int i = kFleischmannConeCount; i < kConeLanes; ++i)
      setLane(*vectors, i, Eigen::Vector3d::Zero());
  out.taper = taper_;
}

ViewCamera::ViewCamera(const Camera& camera, int downsampling)
    : width_(camera.width() / downsampling), height_(camera.height() / downsampling) {
  if (downsampling < 1 || width_ < 1 || height_ < 1)
    throw std::invalid_argument("camera '" + camera.name() + "': an image of " +
                                std::to_string(camera.width()) + " x " +
                                std::to_string(camera.height()) + " cannot be downsampled by " +
                                std::to_string(downsampling));
  const CameraCalibration& c = camera.calibration();
  const Eigen::Isometry3d T = c.T_world_camera.inverse();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) numbers_.R[i][j] = float(T.linear()(i, j));
    numbers_.t[i] = float(T.translation()[i]);
    numbers_.position[i] = float(camera.position()[i]);
  }
  // Integer coordinates are pixel centres: the centre of the first reduced pixel is at -0.5 + 0.5 r
  // of the original.
  const double s = 1.0 / downsampling;
  numbers_.fx = float(s * c.K(0, 0));
  numbers_.skew = float(s * c.K(0, 1));
  numbers_.cx = float(s * (c.K(0, 2) + 0.5) - 0.5);
  numbers_.fy = float(s * c.K(1, 1));
  numbers_.cy = float(s * (c.K(1, 2) + 0.5) - 0.5);
  std::fill(std::begin(numbers_.k), std::end(numbers_.k), 0.0f);
  std::copy(c.D.begin(), c.D.end(), numbers_.k);
  numbers_.fisheye = c.lens == LensType::kFisheye;
  numbers_.reach = float(std::min(lensNumbersOf(c).reach, kMaxRadiusSquared));
}

void ViewCamera::outlines(const FleischmannWorldCones& cones, ConeCorners& out) const {
  static const ConeFloats whole = [] {
    ConeFloats ones;
    ones.fill(1.0f);
    return ones;
  }();
  CameraPlaces places;
  ContourLines lines{};
  seeCamera(cones, numbers_, places);
  findContour(places, lines);
  for (int i = 0; i < kFleischmannConeCount; ++i)
    out.seen[i] = places.inside[i] > kMinSquaredDistance;
  const auto corner = [&](int at, const ConeVectors& center, const ConeFloats& scale, int side) {
    CornerLanes lanes;
    const auto project = numbers_.fisheye ? projectFisheyeCorners : projectCorners;
    project(cones, numbers_, center, scale, lines.cosine[side], lines.sine[side], lanes);
    out.x[at] = lanes.x;
    out.y[at] = lanes.y;
    for (int i = 0; i < kFleischmannConeCount; ++i)
      out.seen[i] &= int(lanes.depth[i] > kMinDepth) & int(lanes.off_axis[i] < numbers_.reach);
  };
  corner(0, cones.a, whole, 0);
  corner(1, cones.b, cones.taper, 0);
  corner(2, cones.b, cones.taper, 1);
  corner(3, cones.a, whole, 1);
}

}  // namespace markerless_mocap
