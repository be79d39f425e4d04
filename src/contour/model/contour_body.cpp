#include "contour/model/contour_body.h"

#include <Eigen/Geometry>
#include <stdexcept>

#include "contour/model/contour_kinematics.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

using Eigen::Matrix3d;
using Eigen::Vector3d;

ContourBody::ContourBody(const ShapeParameters& shape) : shape_(shape) {
  for (int i = 0; i < kShapeParameterCount; ++i)
    if (!std::isfinite(shape[i]) || (!isOffset(i) && !(shape[i] > 0)))
      throw std::invalid_argument("shape parameter " + shapeParameterName(i) + " of a body is " +
                                  std::to_string(shape[i]) + ", it must be finite" +
                                  (isOffset(i) ? "" : " and positive"));
  const ContourKinematicTree& tree = contourKinematicTree();
  for (size_t s = 0; s < ContourSegment::kCount; ++s) joints_[s] = tree.segments[s].joint.at(shape);
  for (size_t c = 0; c < kContourCones; ++c)
    for (size_t end = 0; end < 2; ++end) ends_[c][end] = tree.cones[c].ends[end].local.at(shape);
}

void ContourBody::place(const ContourPose& pose, ContourFrames& frames) const {
  const ContourKinematicTree& tree = contourKinematicTree();
  frames.axis.leftCols<3>().setIdentity();
  frames.pivot.leftCols<3>().setZero();
  for (size_t s = 0; s < ContourSegment::kCount; ++s) {
    const KinematicSegment& segment = tree.segments[s];
    const bool root = segment.parent < 0;
    const size_t parent = root ? 0 : size_t(segment.parent);
    Matrix3d R = root ? Matrix3d(Matrix3d::Identity()) : frames.R[parent];
    const Vector3d t = root ? pose.position : Vector3d(frames.t[parent] + R * joints_[s]);
    if (segment.spherical_joint >= 0) {
      R = R * pose.rotations[size_t(segment.spherical_joint)];
      const int dof = sphericalDof(segment.spherical_joint);
      frames.axis.middleCols<3>(dof) = R;
      frames.pivot.middleCols<3>(dof).colwise() = t;
    } else {
      for (size_t i = 0; i < segment.axes.size(); ++i) {
        const int angle = segment.first_angle + int(i);
        frames.axis.col(revoluteDof(angle)) = R * segment.axes[i];
        frames.pivot.col(revoluteDof(angle)) = t;
        R = R * Eigen::AngleAxisd(pose.angles[size_t(angle)], segment.axes[i]);
      }
    }
    frames.R[s] = R;
    frames.t[s] = t;
  }
}

void ContourBody::place(const ContourFrames& frames, ContourWorldCones& cones) const {
  const ContourKinematicTree& tree = contourKinematicTree();
  for (size_t c = 0; c < kContourCones; ++c) {
    const size_t s = tree.cones[c].ends[0].segment;
    cones[c].a = frames.t[s] + frames.R[s] * ends_[c][0];
    cones[c].b = frames.t[s] + frames.R[s] * ends_[c][1];
    cones[c].radius_a = shape_[tree.cones[c].radius[0]];
    cones[c].radius_b = shape_[tree.cones[c].radius[1]];
  }
}

Eigen::Matrix3Xd ContourBody::points(const ContourPose& pose) const {
  ContourFrames frames;
  place(pose, frames);
  const std::vector<AttachedPoint>& ridden = contourKinematicTree().points;
  Eigen::Matrix3Xd points(3, Eigen::Index(ridden.size()));
  for (size_t i = 0; i < ridden.size(); ++i)
    points.col(Eigen::Index(i)) =
        frames.t[ridden[i].segment] + frames.R[ridden[i].segment] * ridden[i].local.at(shape_);
  return points;
}

ContourLimb::Id limbOfCone(int cone) {
  return contourKinematicTree().cones[size_t(cone)].limb;
}

const std::vector<std::string>& contourPointNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out = markerNames();
    for (const char* tip : {"l_hand_tip", "r_hand_tip", "l_foot_tip", "r_foot_tip", "head_top"})
      out.push_back(tip);
    return out;
  }();
  return names;
}

size_t endOfLimb(ContourLimb::Id limb) {
  constexpr size_t kEnds[ContourLimb::kCount] = {1, 2, 5, 8, 11, 14};
  return kEnds[limb];
}

void poseJacobian(const ContourFrames& frames, int segment, const Vector3d& at,
                  Eigen::Ref<Eigen::Matrix<double, 3, kContourDof>, 0, Eigen::OuterStride<>> J) {
  const uint64_t dof_mask = contourKinematicTree().segments[size_t(segment)].dof_mask;
  J.leftCols<3>().setIdentity();
  for (int dof = 3; dof < kContourDof; ++dof) {
    if (dof_mask >> dof & 1)
      J.col(dof) = frames.axis.col(dof).cross(at - frames.pivot.col(dof));
    else
      J.col(dof).setZero();
  }
}

void shapeJacobian(
    const ContourFrames& frames, const AttachedPoint& point,
    Eigen::Ref<Eigen::Matrix<double, 3, kShapeParameterCount>, 0, Eigen::OuterStride<>> J) {
  J.setZero();
  const auto add = [&](const ShapeDependentPoint& local, const Matrix3d& R) {
    for (const ShapeDependentPoint::Term& term : local.terms) J.col(term.size) += R * term.along;
  };
  add(point.local, frames.R[point.segment]);
  const ContourKinematicTree& tree = contourKinematicTree();
  for (int s = point.segment; tree.segments[size_t(s)].parent >= 0;) {
    const int parent = tree.segments[size_t(s)].parent;
    add(tree.segments[size_t(s)].joint, frames.R[size_t(parent)]);
    s = parent;
  }
}

}  // namespace markerless_mocap
