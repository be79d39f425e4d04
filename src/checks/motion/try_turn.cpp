#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "checks/motion/explanation.h"

namespace markerless_mocap {
namespace {

constexpr size_t kParts = 5;  // of the recording
constexpr int kFewRays = 20;  // for a rotation
constexpr int kRounds = 80;   // of adjusting all cameras
constexpr double kLarge = 5 * M_PI / 180;

/// The rotation that takes the rays from..to-1 to the points, with losses of a scale in pixels
/// (Kabsch, reweighted). None if there are few rays.
std::optional<Eigen::Matrix3d> rotationTo(const CameraState& state, size_t from, size_t to,
                                          const Eigen::Matrix3d& start, double scale) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  int count = 0;
  for (size_t at = from; at < to; ++at) {
    if (!state.rays[at] || !state.points[at]) continue;
    Ray ray = *state.rays[at];
    ray.direction = start * ray.direction;
    const double r = residualOf(ray, *state.points[at]) / scale;
    const double weight = 1 / std::pow(1 + r * r, 2);
    sum += weight * (*state.points[at] - ray.origin).normalized() *
           state.rays[at]->direction.transpose();
    ++count;
  }
  if (count < kFewRays) return std::nullopt;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant());
  return Eigen::Matrix3d(svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose());
}

std::optional<Eigen::Matrix3d> robustRotation(const CameraState& state, size_t from, size_t to) {
  std::optional<Eigen::Matrix3d> rotation = Eigen::Matrix3d::Identity();
  for (const double scale : {1000.0, 200.0, 50.0, 20.0, 10.0, kResidualScale, kResidualScale})
    if (rotation) rotation = rotationTo(state, from, to, *rotation, scale);
  return rotation;
}

/// The small rotation across an axis that takes rays to points best, reweighted: a rotation about
/// the axis itself is hardly told from the shape of the person as seen from above or below.
Eigen::Matrix3d tiltTo(const CameraState& state, const Eigen::Vector3d& axis, size_t from,
                       size_t to) {
  const Eigen::Vector3d right = axis.unitOrthogonal(), down = axis.cross(right);
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 8; ++i) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() * 1e-9;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (size_t at = from; at < to; ++at) {
      if (!state.rays[at] || !state.points[at]) continue;
      Ray ray = *state.rays[at];
      ray.direction = rotation * ray.direction;
      const double weight = std::pow(1 - lossOf(residualOf(ray, *state.points[at])), 2);
      Eigen::Matrix<double, 3, 2> turning;
      turning << right.cross(ray.direction), down.cross(ray.direction);
      normal += weight * turning.transpose() * turning;
      sum += weight * turning.transpose() *
             ((*state.points[at] - ray.origin).normalized() - ray.direction);
    }
    const Eigen::Vector2d step = normal.ldlt().solve(sum);
    const Eigen::Vector3d turn = step.x() * right + step.y() * down;
    if (turn.norm() > 1e-12)
      rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * rotation;
  }
  return rotation;
}

Eigen::Vector3d vectorOf(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

/// About any axis if large, else across the optical axis.
std::optional<Eigen::Matrix3d> turnOf(const CameraState& state, const Eigen::Vector3d& axis,
                                      size_t from, size_t to) {
  auto rotation = robustRotation(state, from, to);
  if (!rotation || Eigen::AngleAxisd(*rotation).angle() > kLarge) return rotation;
  return tiltTo(state, axis, from, to);
}

/// Standard deviation of the mean over parts of the recording.
double deviationOf(const CameraState& state, const Eigen::Vector3d& mean,
                   const Eigen::Vector3d& axis) {
  double sum = 0;
  int parts = 0;
  const size_t moments = state.rays.size() / kBodyMarks;
  for (size_t part = 0; part < kParts; ++part) {
    const size_t from = part * moments / kParts, to = (part + 1) * moments / kParts;
    const auto rotation = turnOf(state, axis, from * kBodyMarks, to * kBodyMarks);
    if (!rotation) continue;
    sum += (vectorOf(*rotation) - mean).squaredNorm();
    ++parts;
  }
  return parts < 3 ? INFINITY : std::sqrt(sum / (parts - 1) / parts);
}

Eigen::Vector3d axisOf(const CameraModel& camera) {
  return camera.calibration.T_world_camera.linear().col(2);
}

/// Tilts every camera towards the points of all, which then move, and so on.
void adjustTilts(const RigSight& sight, RigModel* model) {
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Rays> rays;
    for (const CameraModel& camera : *model) rays.push_back(raysOf(sight, camera));
    const auto points = pointsOf(rays, {});
    for (size_t k = 0; k < model->size(); ++k) {
      CameraState state;
      state.rays = rays[k];
      state.points = points;
      Eigen::Isometry3d& pose = (*model)[k].calibration.T_world_camera;
      pose.linear() = tiltTo(state, axisOf((*model)[k]), 0, rays[k].size()) * pose.linear();
    }
  }
}

}  // namespace

void tryAllTurns(const RigSight& sight, const RigModel& model,
                 const std::vector<CameraState>& states, std::vector<Explanation>* out) {
  Explanation tried;
  tried.kind = ExplanationKind::kTurned;
  tried.model = model;
  adjustTilts(sight, &tried.model);
  std::vector<Rays> before, after;
  for (const CameraState& state : states) {
    const size_t k = state.camera;
    tried.cameras.push_back(k);
    tried.before = std::max(tried.before, state.loss.residual);
    before.push_back(state.rays);
    after.push_back(raysOf(sight, tried.model[k]));
    const double turn = Eigen::AngleAxisd(model[k].calibration.T_world_camera.linear().transpose() *
                                          tried.model[k].calibration.T_world_camera.linear())
                            .angle();
    tried.amounts.push_back(turn);
    tried.amount = std::max(tried.amount, turn);
    tried.gain += state.loss.rays;
  }
  tried.gain *= lossOf(before) - lossOf(after);
  out->push_back(std::move(tried));
}

void tryTurn(const RigSight& sight, const RigModel& model, const CameraState& state,
             std::vector<Explanation>* out) {
  const Eigen::Vector3d axis = axisOf(model[state.camera]);
  const auto rotation = turnOf(state, axis, 0, state.rays.size());
  if (!rotation) return;
  Explanation tried;
  tried.kind = ExplanationKind::kTurned;
  tried.cameras = {state.camera};
  tried.model = model;
  CameraCalibration& camera = tried.model[state.camera].calibration;
  camera.T_world_camera.linear() = *rotation * camera.T_world_camera.linear();
  const CameraLoss loss = lossOf(raysOf(sight, tried.model[state.camera]), state.points);
  tried.amount = Eigen::AngleAxisd(*rotation).angle();
  tried.deviation = deviationOf(state, vectorOf(*rotation), axis);
  tried.before = state.loss.residual;
  tried.after = loss.residual;
  tried.gain = state.loss.rays * (state.loss.loss - loss.loss);
  out->push_back(std::move(tried));
}

}  // namespace markerless_mocap
