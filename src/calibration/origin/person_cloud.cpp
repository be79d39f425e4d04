#include "calibration/origin/person_cloud.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "numerics/face_parts.h"

namespace markerless_mocap {
namespace {

constexpr uchar kPerson = 255, kBackground = 0;
constexpr double kHalf = 1.3, kVoxel = 0.04;  // m: a person fits in, however the world lies

/// Middle of the largest blob of a silhouette, pixels; empty if there is none of 0.05 % of the
/// image.
std::optional<Eigen::Vector2d> middleOf(const cv::Mat& silhouette) {
  if (silhouette.empty()) return std::nullopt;
  cv::Mat labels, statistics, middles;
  const int count = cv::connectedComponentsWithStats(silhouette == kPerson, labels, statistics,
                                                     middles, 8, CV_32S);
  int best = 0, most = int(5e-4 * double(silhouette.total()));
  for (int i = 1; i < count; ++i)
    if (const int area = statistics.at<int>(i, cv::CC_STAT_AREA); area > most) {
      most = area;
      best = i;
    }
  if (best == 0) return std::nullopt;
  return Eigen::Vector2d(middles.at<double>(best, 0), middles.at<double>(best, 1));
}

/// Where the rays through the silhouettes' middles come nearest to each other.
std::optional<Eigen::Vector3d> placeOf(const CameraRig& cameras, const SilhouetteSet& silhouettes) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  int rays = 0;
  for (size_t i = 0; i < cameras.size(); ++i) {
    const auto middle = middleOf(silhouettes[i]);
    if (!middle) continue;
    const Eigen::Vector3d d = cameras[i].rayDirection(*middle);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
    A += across;
    b += across * cameras[i].position();
    ++rays;
  }
  constexpr double kLeastDeterminant = 1e-3;  // rays that are parallel meet nowhere
  if (rays < 2 || A.determinant() < kLeastDeterminant) return std::nullopt;
  return Eigen::Vector3d(A.inverse() * b);
}

bool isInHull(const Eigen::Vector3d& place, const CameraRig& cameras,
              const SilhouetteSet& silhouettes) {
  int inside = 0;
  for (size_t i = 0; i < cameras.size(); ++i) {
    if (silhouettes[i].empty()) continue;
    const auto pixel = cameras[i].projectInside(place);
    if (!pixel) continue;
    const uchar value =
        silhouettes[i].at<uchar>(int(std::lround(pixel->y())), int(std::lround(pixel->x())));
    if (value == kBackground) return false;
    inside += value == kPerson;
  }
  return inside >= 2;
}

}  // namespace

Eigen::Matrix3Xd hullIn(const VoxelBox& box, const CameraRig& cameras,
                        const SilhouetteSet& silhouettes) {
  const Eigen::Vector3i counts = (2 * box.half / box.voxel).array().round().cast<int>();
  std::vector<Eigen::Vector3d> found;
  for (int z = 0; z < counts.z(); ++z)
    for (int y = 0; y < counts.y(); ++y)
      for (int x = 0; x < counts.x(); ++x) {
        const Eigen::Vector3d place =
            (Eigen::Vector3d(x, y, z).array() + 0.5).matrix() * box.voxel - box.half;
        if (isInHull(box.world_box * place, cameras, silhouettes)) found.push_back(place);
      }
  Eigen::Matrix3Xd points(3, Eigen::Index(found.size()));
  for (size_t i = 0; i < found.size(); ++i) points.col(Eigen::Index(i)) = found[i];
  return points;
}

std::optional<PersonCloud> personIn(const CameraRig& cameras, const SilhouetteSet& silhouettes) {
  const auto place = placeOf(cameras, silhouettes);
  if (!place) return std::nullopt;
  VoxelBox box;
  box.world_box.translation() = *place;
  box.half.setConstant(kHalf);
  box.voxel = kVoxel;
  const Eigen::Matrix3Xd hull = hullIn(box, cameras, silhouettes);
  std::vector<Eigen::Vector3i> voxels;
  for (Eigen::Index i = 0; i < hull.cols(); ++i)
    voxels.push_back(((hull.col(i) + box.half) / kVoxel - Eigen::Vector3d::Constant(0.5))
                         .array()
                         .round()
                         .cast<int>());
  const std::vector<size_t> body = largestFacePart(voxels);
  constexpr size_t kLeast = 200;  // voxels: 13 litres
  if (body.size() < kLeast) return std::nullopt;
  PersonCloud person;
  person.points.resize(3, Eigen::Index(body.size()));
  for (size_t i = 0; i < body.size(); ++i)
    person.points.col(Eigen::Index(i)) = box.world_box * hull.col(Eigen::Index(body[i]));
  person.middle = person.points.rowwise().mean();
  const Eigen::Matrix3Xd from_middle = person.points.colwise() - person.middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shape(from_middle * from_middle.transpose());
  person.axis = shape.eigenvectors().col(2);
  person.slenderness = std::sqrt(shape.eigenvalues()[2] / shape.eigenvalues()[1]);
  return person;
}

}  // namespace markerless_mocap
