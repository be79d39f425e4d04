#include "capture/cameras/camera_rigs.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "camera/lens_equations.h"
#include "markerless_mocap/camera/rig_file.h"
#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

constexpr double kVolumeRadius = 1.3, kVolumeHeight = 2.4;
constexpr double kRingRadius = 4.2, kRingHeight = 1.9, kOverhead = 4.6;
constexpr double kWideRadius = 2.2, kWideHeight = 2.3;
constexpr double kCeilingCorner = 2.6, kCeilingHeight = 2.7;
/// Fraction of the half image that the volume fills.
constexpr double kFilled = 0.97;

const Eigen::Vector3d kTarget(0.0, 0.0, 1.0);

/// A lens without its focal length.
struct LensPlan {
  double k1 = 0.0, k2 = 0.0;
  double aspect = 1.0;          ///< fy / fx
  Eigen::Vector2d shift{0, 0};  ///< of the principal point, fraction of the image size
  std::vector<double> fisheye;  ///< coefficients; empty: k1 and k2 are those of the lens
  double wider = 1.0;  ///< field of view (tangent) relative to the one that just shows the volume
};

/// Uniform random numbers in [low, high].
class RandomStream {
 public:
  explicit RandomStream(uint64_t seed) : state_(splitMix64(seed ^ 0x5269675365656421u)) {}
  double between(double low, double high) {
    state_ = splitMix64(state_);
    return low + (high - low) * splitMixUniform(state_);
  }

 private:
  uint64_t state_;
};

/// Focal length in x at which all points of the volume are inside the image, pixels.
double focalLength(const Eigen::Isometry3d& T_world_camera, const LensPlan& lens, int width,
                   int height) {
  const Eigen::Vector2d free(kFilled * width * (0.5 - std::abs(lens.shift.x())),
                             kFilled * height * (0.5 - std::abs(lens.shift.y())));
  double focal = HUGE_VAL;
  for (const Eigen::Vector3d& point : volumePoints()) {
    const Eigen::Vector3d p = T_world_camera.inverse() * point;
    const Eigen::Vector2d plane = p.head<2>() / p.z();
    const double s = plane.squaredNorm();
    Eigen::Vector2d seen = plane * (1.0 + s * (lens.k1 + s * lens.k2));
    if (!lens.fisheye.empty()) distortFisheye(lens.fisheye.data(), p.data(), seen.data());
    focal = std::min(
        {focal, free.x() / std::abs(seen.x()), free.y() / (lens.aspect * std::abs(seen.y()))});
  }
  return focal / lens.wider;
}

CameraCalibration placed(const RigPlan& plan, const Eigen::Isometry3d& T_world_camera,
                         const LensPlan& lens) {
  CameraCalibration c;
  c.width = plan.width;
  c.height = plan.height;
  c.T_world_camera = T_world_camera;
  const double focal = focalLength(T_world_camera, lens, plan.width, plan.height);
  c.K << focal, 0, (plan.width - 1) / 2.0 + lens.shift.x() * plan.width, 0, focal * lens.aspect,
      (plan.height - 1) / 2.0 + lens.shift.y() * plan.height, 0, 0, 1;
  c.D = {lens.k1, lens.k2, 0, 0, 0};
  if (!lens.fisheye.empty()) {
    c.D = lens.fisheye;
    c.lens = LensType::kFisheye;
  }
  return c;
}

Eigen::Vector3d onCircle(double turns, double radius, double height) {
  return {radius * std::cos(2.0 * M_PI * turns), radius * std::sin(2.0 * M_PI * turns), height};
}

using Places = std::vector<Eigen::Vector3d>;

Places ringOf(int cameras, double radius = kRingRadius, double height = kRingHeight) {
  Places places;
  for (int i = 0; i < cameras; ++i) places.push_back(onCircle((i + 0.5) / cameras, radius, height));
  return places;
}

Places placesOf(const std::string& kind) {
  if (kind == "ring8") return ringOf(8);
  if (kind == "ring4") return ringOf(4);
  if (kind == "ring16") return ringOf(16);
  if (kind == "wide6") return ringOf(6, kWideRadius, kWideHeight);
  if (kind == "ceiling4") {
    Places corners;
    for (int i = 0; i < 4; ++i)
      corners.push_back(onCircle((i + 0.5) / 4, std::sqrt(2.0) * kCeilingCorner, kCeilingHeight));
    return corners;
  }
  Places places = ringOf(7);
  places.emplace_back(0.0, 0.0, kOverhead);
  return places;
}

std::vector<CameraCalibration> randomRig(const RigPlan& plan) {
  RandomStream rng(plan.seed);
  std::vector<CameraCalibration> rig;
  for (int i = 0; i < 8; ++i) {
    const double turns = (i + rng.between(-0.33, 0.33)) / 8.0;
    const double radius = rng.between(3.6, 4.8), height = rng.between(0.7, 3.2);
    const Eigen::Vector3d aside(rng.between(-0.15, 0.15), rng.between(-0.15, 0.15),
                                rng.between(-0.15, 0.15));
    Eigen::Isometry3d T_world_camera = lookAt(onCircle(turns, radius, height), kTarget + aside);
    T_world_camera.rotate(Eigen::AngleAxisd(rng.between(-0.1, 0.1), Eigen::Vector3d::UnitZ()));
    LensPlan lens;
    lens.k1 = rng.between(-0.18, 0.06);
    lens.k2 = rng.between(-0.02, 0.04);
    lens.aspect = rng.between(0.99, 1.01);
    lens.shift = {rng.between(-0.02, 0.02), rng.between(-0.02, 0.02)};
    lens.wider = rng.between(0.95, 1.15);
    rig.push_back(placed(plan, T_world_camera, lens));
  }
  return rig;
}

std::vector<CameraCalibration> plannedRig(const RigPlan& plan) {
  if (plan.kind == "random8") return randomRig(plan);
  LensPlan lens;
  lens.k1 = plan.distortion_k1;
  if (plan.kind == "wide6") lens.fisheye = {-0.03, 0.006, -0.002, 0.0003};
  std::vector<CameraCalibration> rig;
  for (const Eigen::Vector3d& place : placesOf(plan.kind))
    rig.push_back(placed(plan, lookAt(place, kTarget), lens));
  return rig;
}

}  // namespace

Eigen::Isometry3d lookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  const Eigen::Vector3d away = target - position;
  if (!(away.norm() > 1e-9))
    throw std::invalid_argument("a camera cannot look at the point where it is");
  const Eigen::Vector3d forward = away.normalized();
  const bool steep = std::abs(forward.z()) > 0.999;
  const Eigen::Vector3d up = steep ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = forward.cross(up).normalized();
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear() << right, forward.cross(right), forward;
  T_world_camera.translation() = position;
  return T_world_camera;
}

const std::vector<std::string>& rigKinds() {
  static const std::vector<std::string> kinds = {"ring8",    "ring7_overhead", "ring4", "ring16",
                                                 "ceiling4", "random8",        "wide6"};
  return kinds;
}

std::vector<Eigen::Vector3d> volumePoints() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 24; ++i)
    for (const double height : {0.0, kVolumeHeight})
      points.push_back(onCircle(i / 24.0, kVolumeRadius, height));
  return points;
}

CameraRig makeRig(const RigPlan& plan) {
  const auto& kinds = rigKinds();
  if (std::find(kinds.begin(), kinds.end(), plan.kind) == kinds.end()) {
    std::string allowed;
    for (const std::string& kind : kinds) allowed += (allowed.empty() ? "" : ", ") + kind;
    throw std::invalid_argument("the rig is \"" + plan.kind + "\", allowed are " + allowed +
                                " or path of a rig file with the ending .yaml");
  }
  std::vector<CameraCalibration> planned = plannedRig(plan);
  for (size_t i = 0; i < planned.size(); ++i) planned[i].name = "cam" + std::to_string(i);
  CameraRig rig;
  for (const CameraCalibration& camera : rigFromText(rigText(planned), "rig"))
    rig.emplace_back(camera);
  return rig;
}

}  // namespace markerless_mocap
