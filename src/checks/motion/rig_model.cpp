#include "checks/motion/rig_model.h"

#include <algorithm>
#include <cmath>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr int kRefinements = 3;
constexpr double kParallel = 1e-4;  // squared sine below which two rays give no point

/// The middle of the shortest line between two rays; none if it lies behind one of them.
std::optional<Eigen::Vector3d> between(const Ray& a, const Ray& b) {
  const Eigen::Vector3d apart = b.origin - a.origin;
  const double cosine = a.direction.dot(b.direction), sine2 = 1 - cosine * cosine;
  if (sine2 < kParallel) return std::nullopt;
  const double along_a = a.direction.dot(apart), along_b = b.direction.dot(apart);
  const double s = (along_a - cosine * along_b) / sine2, t = (cosine * along_a - along_b) / sine2;
  if (s <= 0 || t <= 0) return std::nullopt;
  return 0.5 * (a.origin + s * a.direction + b.origin + t * b.direction);
}

double totalLoss(const std::vector<const Ray*>& rays, const Eigen::Vector3d& point) {
  double sum = 0;
  for (const Ray* ray : rays) sum += lossOf(residualOf(*ray, point));
  return sum;
}

/// One step of iteratively reweighted least squares.
Eigen::Vector3d nearer(const std::vector<const Ray*>& rays, const Eigen::Vector3d& point) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() * 1e-9;
  Eigen::Vector3d right = normal * point;
  for (const Ray* ray : rays) {
    const double r = residualOf(*ray, point), s2 = kResidualScale * kResidualScale;
    const double distance = std::max(1e-6, (point - ray->origin).norm());
    const double weight = std::pow(ray->focal / distance, 2) * std::pow(s2 / (s2 + r * r), 2);
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray->direction * ray->direction.transpose();
    normal += weight * across;
    right += weight * across * ray->origin;
  }
  return normal.ldlt().solve(right);
}

std::vector<const Ray*> raysAt(const std::vector<Rays>& rays, size_t at,
                               const std::vector<size_t>& left_out) {
  std::vector<const Ray*> out;
  for (size_t k = 0; k < rays.size(); ++k)
    if (rays[k][at] && std::find(left_out.begin(), left_out.end(), k) == left_out.end())
      out.push_back(&*rays[k][at]);
  return out;
}

}  // namespace

Rays raysOf(const RigSight& sight, const CameraModel& model) {
  return raysOf(sight, model, sightOf(sight.tracks[model.source], model.calibration, model.turn));
}

Rays raysOf(const RigSight& sight, const CameraModel& model, const Sight& pixels) {
  const PersonTrack& track = sight.tracks[model.source];
  const Camera camera(model.calibration);
  const double focal = model.calibration.K(0, 0) * kModelWidth / model.calibration.width;
  const double first = track.seconds.empty() ? 0 : track.seconds.front();
  Rays rays(sight.moments.size() * kBodyMarks);
  for (size_t m = 0; m < sight.moments.size(); ++m) {
    // stamp + offset + drift * (stamp - first) = moment
    const double stamp = first + (sight.moments[m] - first - model.offset) / (1.0 + model.drift);
    for (int mark = 0; mark < kBodyMarks; ++mark)
      if (const auto pixel = pixelAt(track, pixels, BodyMark(mark), stamp))
        rays[m * kBodyMarks + size_t(mark)] =
            Ray{camera.position(), camera.rayDirection(*pixel), focal};
  }
  return rays;
}

double residualOf(const Ray& ray, const Eigen::Vector3d& point) {
  const Eigen::Vector3d to = point - ray.origin;
  return ray.focal * std::atan2(ray.direction.cross(to).norm(), ray.direction.dot(to));
}

double lossOf(double residual) {
  const double r2 = residual * residual;
  return r2 / (r2 + kResidualScale * kResidualScale);
}

std::optional<Eigen::Vector3d> pointOf(const std::vector<Rays>& rays, size_t at,
                                       const std::vector<size_t>& left_out) {
  const std::vector<const Ray*> here = raysAt(rays, at, left_out);
  std::optional<Eigen::Vector3d> best;
  double least = HUGE_VAL;
  for (size_t a = 0; a < here.size(); ++a)
    for (size_t b = 0; b < a; ++b) {
      const auto point = between(*here[a], *here[b]);
      const double loss = point ? totalLoss(here, *point) : HUGE_VAL;
      if (loss >= least) continue;
      least = loss;
      best = point;
    }
  for (int i = 0; best && i < kRefinements; ++i) best = nearer(here, *best);
  return best;
}

std::vector<std::optional<Eigen::Vector3d>> pointsOf(const std::vector<Rays>& rays,
                                                     const std::vector<size_t>& left_out) {
  std::vector<std::optional<Eigen::Vector3d>> points;
  for (size_t at = 0; at < rays.front().size(); ++at) points.push_back(pointOf(rays, at, left_out));
  return points;
}

CameraLoss lossOf(const Rays& rays, const std::vector<std::optional<Eigen::Vector3d>>& points) {
  CameraLoss loss;
  double sum = 0;
  std::vector<double> residuals;
  for (size_t at = 0; at < rays.size(); ++at) {
    if (!rays[at] || !points[at]) continue;
    residuals.push_back(residualOf(*rays[at], *points[at]));
    sum += lossOf(residuals.back());
  }
  loss.rays = int(residuals.size());
  if (loss.rays == 0) return loss;
  loss.loss = sum / loss.rays;
  loss.residual = nearestQuantile(residuals, 0.5);
  return loss;
}

double lossOf(const std::vector<Rays>& rays) {
  double sum = 0;
  int count = 0;
  const auto points = pointsOf(rays, {});
  for (const Rays& camera : rays)
    for (size_t at = 0; at < camera.size(); ++at) {
      const auto cameras =
          std::count_if(rays.begin(), rays.end(), [&](const Rays& r) { return r[at].has_value(); });
      if (!camera[at] || cameras < 2) continue;
      ++count;
      sum += points[at] ? lossOf(residualOf(*camera[at], *points[at])) : 1.0;
    }
  return count == 0 ? 1.0 : sum / count;
}

}  // namespace markerless_mocap
