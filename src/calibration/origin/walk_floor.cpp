#include "calibration/walk_floor.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "calibration/origin/person_cloud.h"
#include "numerics/order_statistics.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

constexpr double kSlender = 2.0;       // length by width of a person who stands
constexpr double kAxisSigma = 0.05;    // rad, of the mean axis of a walking person
constexpr double kSoleScatter = 0.01;  // m
constexpr int kLeastSteps = 10;

/// Mean of axes whose signs mean nothing, without those more than 25 degrees off.
Eigen::Vector3d meanAxis(const std::vector<PersonCloud>& people) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int round = 0; round < 4; ++round) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const PersonCloud& person : people)
      if (round == 0 || std::abs(person.axis.dot(mean)) > std::cos(25 * M_PI / 180))
        sum += person.axis * person.axis.transpose();
    mean = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
  }
  return mean;
}

/// Middle of what lies within 6 cm of the end of a person in a direction.
Eigen::Vector3d endOf(const PersonCloud& person, const Eigen::Vector3d& direction) {
  const Eigen::VectorXd along = person.points.transpose() * direction;
  const double end = along.maxCoeff();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (Eigen::Index i = 0; i < along.size(); ++i)
    if (along[i] > end - 0.06) {
      sum += person.points.col(i);
      ++count;
    }
  return sum / count;
}

/// How far an end goes from one frame set to the next: a sole stands still for a while.
double strideOf(const std::vector<PersonCloud>& people, const Eigen::Vector3d& direction) {
  std::vector<double> steps;
  for (size_t i = 1; i < people.size(); ++i)
    steps.push_back((endOf(people[i], direction) - endOf(people[i - 1], direction)).norm());
  return quantileOf(steps, 0.3);
}

/// The axis with the sign that points up: away from the end that stands still, or, if both ends
/// move alike, as the cameras' images do.
Eigen::Vector3d upwards(const CameraRig& cameras, const std::vector<PersonCloud>& people,
                        const Eigen::Vector3d& axis) {
  constexpr double kClear = 0.6;
  const double one = strideOf(people, axis), other = strideOf(people, -axis);
  if (other < kClear * one) return axis;
  if (one < kClear * other) return -axis;
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  for (const Camera& camera : cameras) up -= camera.calibration().T_world_camera.linear().col(1);
  return up.dot(axis) < 0 ? -axis : axis;
}

Eigen::Matrix3d levelledTo(const Eigen::Vector3d& up) {
  return shortestRotation(Eigen::Vector3d::UnitZ(), up).toRotationMatrix();
}

/// Middle of the lower of a person's soles, world; empty if its hull has no flat end. Below a sole
/// the hull tapers; the sole is where its cross-section has most of its area.
std::optional<Eigen::Vector3d> soleOf(const PersonCloud& person, const Eigen::Vector3d& up,
                                      const CameraRig& cameras, const SilhouetteSet& silhouettes) {
  VoxelBox box;
  box.world_box.linear() = levelledTo(up);
  box.world_box.translation() = endOf(person, -up) + 0.03 * up;
  box.half << 0.22, 0.22, 0.13;
  box.voxel = 0.01;
  const Eigen::Matrix3Xd hull = hullIn(box, cameras, silhouettes);
  const int slices = int(std::lround(2 * box.half.z() / box.voxel));
  std::vector<double> areas(size_t(slices), 0.0);
  std::vector<Eigen::Vector3d> sums(size_t(slices), Eigen::Vector3d::Zero());
  for (Eigen::Index i = 0; i < hull.cols(); ++i) {
    const size_t slice = size_t((hull(2, i) + box.half.z()) / box.voxel);
    ++areas[slice];
    sums[slice] += hull.col(i);
  }
  const size_t first = size_t(
      std::find_if(areas.begin(), areas.end(), [](double a) { return a > 0; }) - areas.begin());
  constexpr size_t kShoe = 10;  // slices
  if (first == 0 || first + kShoe > areas.size()) return std::nullopt;
  const double most =
      *std::max_element(areas.begin() + long(first), areas.begin() + long(first + kShoe));
  if (most < 40) return std::nullopt;  // square centimetres
  size_t level = first;
  while (areas[level] < 0.5 * most) ++level;
  const Eigen::Vector3d to_lower_face(0, 0, -box.voxel / 2);
  return box.world_box * (sums[level] / areas[level] + to_lower_face);
}

/// Soles on a plane: z = offset + slope . (x, y), in a frame whose z is nearly up.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;  ///< along the normal, m
  double scatter = 0.0, tilt_sigma = 0.0;
};

/// Robust least squares (Cauchy), with the mean axis of the body as a weak guess of the normal.
Plane planeThrough(const std::vector<Eigen::Vector3d>& soles, const Eigen::Vector3d& axis) {
  const Eigen::Matrix3d level = levelledTo(axis);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), fit = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& sole : soles) middle += sole / double(soles.size());
  std::vector<Eigen::Vector3d> places;
  for (const Eigen::Vector3d& sole : soles) places.push_back(level.transpose() * (sole - middle));
  const auto residual = [&](const Eigen::Vector3d& p) {
    return p.z() - fit[0] - fit[1] * p.x() - fit[2] * p.y();
  };
  Eigen::Matrix3d N;
  double scatter = 0.05;
  for (int round = 0; round < 20; ++round) {
    N = Eigen::Vector3d(0, 1, 1).asDiagonal() * (1 / (kAxisSigma * kAxisSigma));
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : places) {
      const double r = residual(p) / scatter, w = 1 / ((1 + r * r) * scatter * scatter);
      const Eigen::Vector3d g(1, p.x(), p.y());
      N += w * g * g.transpose();
      b += w * p.z() * g;
    }
    fit = N.inverse() * b;
    std::vector<double> sizes;
    for (const Eigen::Vector3d& p : places) sizes.push_back(std::abs(residual(p)));
    scatter = std::max(kSoleScatter, 1.48 * quantileOf(sizes, 0.5));
  }
  Plane plane;
  plane.normal = level * Eigen::Vector3d(-fit[1], -fit[2], 1).normalized();
  plane.offset = plane.normal.dot(middle + level.col(2) * fit[0]);
  plane.scatter = scatter;
  plane.tilt_sigma = std::sqrt(N.inverse().diagonal().tail<2>().sum());
  return plane;
}

/// z along the normal, x as near to the old x (or else the old z) as it can be.
Eigen::Isometry3d worldOn(const Plane& plane, const Eigen::Vector3d& middle) {
  Eigen::Vector3d x = Eigen::Vector3d::UnitX() - plane.normal.x() * plane.normal;
  if (x.norm() < 0.3) x = Eigen::Vector3d::UnitZ() - plane.normal.z() * plane.normal;
  x.normalize();
  Eigen::Isometry3d old_new = Eigen::Isometry3d::Identity();
  old_new.linear() << x, plane.normal.cross(x), plane.normal;
  old_new.translation() = middle - (plane.normal.dot(middle) - plane.offset) * plane.normal;
  return old_new.inverse();
}

/// The people who stand, and their silhouettes.
struct Standing {
  std::vector<PersonCloud> people;
  std::vector<const SilhouetteSet*> silhouettes;
};

Standing standingPeople(const CameraRig& cameras, const std::vector<SilhouetteSet>& frame_sets) {
  Standing standing;
  for (const SilhouetteSet& silhouettes : frame_sets) {
    auto person = personIn(cameras, silhouettes);
    if (!person || person->slenderness < kSlender) continue;
    standing.people.push_back(std::move(*person));
    standing.silhouettes.push_back(&silhouettes);
  }
  if (int(standing.people.size()) < kLeastSteps)
    throw std::invalid_argument(
        "a person who stands or walks is seen in " + std::to_string(standing.people.size()) +
        " of " + std::to_string(frame_sets.size()) + " frame sets, the floor needs at least " +
        std::to_string(kLeastSteps) +
        ": is the person seen whole by most cameras, and is everything else still?");
  return standing;
}

double extentOf(const std::vector<Eigen::Vector3d>& soles) {
  double most = 0;
  for (const Eigen::Vector3d& a : soles)
    for (const Eigen::Vector3d& b : soles) most = std::max(most, (a - b).norm());
  return most;
}

}  // namespace

WalkFloor floorFromWalk(const CameraRig& cameras, const std::vector<SilhouetteSet>& frame_sets) {
  const Standing standing = standingPeople(cameras, frame_sets);
  const Eigen::Vector3d axis = upwards(cameras, standing.people, meanAxis(standing.people));
  Plane plane;
  plane.normal = axis;
  std::vector<Eigen::Vector3d> soles;
  for (int round = 0; round < 3; ++round) {
    soles.clear();
    for (size_t i = 0; i < standing.people.size(); ++i)
      if (const auto sole =
              soleOf(standing.people[i], plane.normal, cameras, *standing.silhouettes[i]))
        soles.push_back(*sole);
    if (int(soles.size()) < kLeastSteps)
      throw std::invalid_argument(
          "the soles are not seen by the cameras, so the floor is not known");
    plane = planeThrough(soles, axis);
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& sole : soles) middle += sole / double(soles.size());
  std::vector<double> heights;
  for (const PersonCloud& person : standing.people)
    heights.push_back((person.points.transpose() * plane.normal).maxCoeff() - plane.offset);
  WalkFloor floor;
  floor.new_old = worldOn(plane, middle);
  floor.steps = int(soles.size());
  floor.scatter = plane.scatter;
  floor.extent = extentOf(soles);
  floor.tilt_sigma = plane.tilt_sigma;
  floor.stature = quantileOf(heights, 0.75);  // walkers bob
  return floor;
}

}  // namespace markerless_mocap
