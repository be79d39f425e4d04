#include "evaluation/marked_point.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

double worstResidual(const std::vector<PointMark>& marks) {
  const Eigen::Vector3d point = meetingPoint(marks);
  double worst = 0.0;
  for (const PointMark& mark : marks) worst = std::max(worst, residualOf(mark, point));
  return worst;
}

}  // namespace

Eigen::Matrix3d informationOf(const PointMark& mark, const Eigen::Vector3d& point) {
  const Eigen::Vector3d d = mark.camera->rayDirection(mark.pixel);
  const double pixels_per_metre =
      mark.camera->calibration().K(0, 0) / std::max(0.1, (point - mark.camera->position()).norm());
  return pixels_per_metre * pixels_per_metre * (Eigen::Matrix3d::Identity() - d * d.transpose());
}

Eigen::Vector3d meetingPoint(const std::vector<PointMark>& marks) {
  Eigen::Vector3d point =
      marks[0].camera->position() + marks[0].camera->rayDirection(marks[0].pixel);
  for (int i = 0; i < 5; ++i) {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const PointMark& mark : marks) {
      const Eigen::Matrix3d information = informationOf(mark, point);
      A += information;
      b += information * mark.camera->position();
    }
    point = A.ldlt().solve(b);
  }
  return point;
}

double residualOf(const PointMark& mark, const Eigen::Vector3d& point) {
  const auto pixel = mark.camera->project(point);
  return pixel ? (*pixel - mark.pixel).norm() : INFINITY;
}

std::vector<PointMark> leaveOutDisagreeing(double limit_px, std::vector<PointMark>* marks) {
  std::vector<PointMark> out;
  while (marks->size() >= 2 && worstResidual(*marks) > limit_px) {
    if (marks->size() == 2) {
      out.insert(out.end(), marks->begin(), marks->end());
      marks->clear();
      break;
    }
    size_t best = 0;
    double least = INFINITY;
    for (size_t i = 0; i < marks->size(); ++i) {
      std::vector<PointMark> others = *marks;
      others.erase(others.begin() + long(i));
      const double worst = worstResidual(others);
      if (worst < least) least = worst, best = i;
    }
    out.push_back((*marks)[best]);
    marks->erase(marks->begin() + long(best));
  }
  return out;
}

}  // namespace markerless_mocap
