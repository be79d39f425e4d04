#include "evaluation/body_silhouette.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

namespace markerless_mocap {
namespace {

constexpr int kCorners = 32;
constexpr uchar kUnknown = 128;  // of a mask

/// Adds the outline of a sphere in the image: the circle of points whose viewing rays touch the
/// sphere. Returns whether the whole outline is in front of the camera.
bool addOutline(const Camera& camera, const Eigen::Vector3d& center, double radius,
                std::vector<cv::Point>* outline) {
  const Eigen::Vector3d to_center = center - camera.position();
  const double distance = to_center.norm();
  if (distance <= radius) return false;
  const Eigen::Vector3d axis = to_center / distance;
  const Eigen::Vector3d side = axis.unitOrthogonal();
  const Eigen::Vector3d up = axis.cross(side);
  const double sine = radius / distance;
  const Eigen::Vector3d middle = center - axis * (radius * sine);
  const double circle_radius = radius * std::sqrt(1.0 - sine * sine);
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * M_PI * k / kCorners;
    const auto pixel =
        camera.project(middle + circle_radius * (std::cos(angle) * side + std::sin(angle) * up));
    if (!pixel) return false;
    outline->emplace_back(int(std::lround(pixel->x())), int(std::lround(pixel->y())));
  }
  return true;
}

}  // namespace

cv::Mat bodySilhouette(const BodyModel& model, const LinkPoses& T_world_link, const Camera& camera,
                       const std::vector<bool>& link_shown) {
  cv::Mat mask = cv::Mat::zeros(camera.height(), camera.width(), CV_8UC1);
  std::vector<cv::Point> outline, hull;
  for (const RoundCone& cone : model.shape()) {
    if (!link_shown.empty() && !link_shown.at(cone.link)) continue;
    const Eigen::Isometry3d& T_world = T_world_link.at(cone.link);
    outline.clear();
    if (!addOutline(camera, T_world * cone.a, cone.radius_a, &outline) ||
        !addOutline(camera, T_world * cone.b, cone.radius_b, &outline))
      continue;
    cv::convexHull(outline, hull);
    cv::fillConvexPoly(mask, hull, cv::Scalar(255));
  }
  return mask;
}

double maskIou(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != CV_8UC1 || b.type() != CV_8UC1)
    throw std::invalid_argument("masks to compare must be CV_8UC1 and of one size");
  const cv::Mat known = (a != kUnknown) & (b != kUnknown);
  const int either = cv::countNonZero((a | b) & known);
  return either == 0 ? 0.0 : double(cv::countNonZero((a > 0) & (b > 0) & known)) / either;
}

}  // namespace markerless_mocap
