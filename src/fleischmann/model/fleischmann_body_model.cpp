#include "fleischmann/fleischmann_body_model.h"

#include <algorithm>
#include <cmath>

#include "body/rotations.h"
#include "body/zero_pose.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct SegmentPlan {
  FleischmannSegment parent;
  const char* link;
};

constexpr std::array<SegmentPlan, kFleischmannSegments> kSegments = {{
    {kPelvisSegment, "body"},
    {kPelvisSegment, "r_waist"},
    {kChestSegment, "p_head"},
    {kChestSegment, "l_r_clavicle"},
    {kChestSegment, "r_r_clavicle"},
    {kLeftClavicleSegment, "l_shoulder"},
    {kRightClavicleSegment, "r_shoulder"},
    {kLeftUpperArm, "l_elbow"},
    {kRightUpperArm, "r_elbow"},
    {kPelvisSegment, "l_hip"},
    {kPelvisSegment, "r_hip"},
    {kLeftThigh, "l_knee"},
    {kRightThigh, "r_knee"},
}};

/// Indices of the joints of one side, and the sign that mirrors angles.
struct Side {
  int hip, knee, clavicle, shoulder, elbow;
  double sign;
};
constexpr std::array<Side, 2> kSides = {
    {{kLeftHip, kLeftKnee, kLeftClavicle, kLeftShoulder, kLeftElbow, 1.0},
     {kRightHip, kRightKnee, kRightClavicle, kRightShoulder, kRightElbow, -1.0}}};

/// Segments of the fifteen markers, in the order of markerNames().
constexpr std::array<FleischmannSegment, 15> kMarkerSegments = {
    kPelvisSegment, kSkullSegment,  kSkullSegment,  kLeftUpperArm,  kLeftLowerArm,
    kLeftLowerArm,  kRightUpperArm, kRightLowerArm, kRightLowerArm, kLeftThigh,
    kLeftCalf,      kLeftCalf,      kRightThigh,    kRightCalf,     kRightCalf};

/// Rx(x) Ry(y) Rz(z), expanded.
Matrix3d rotXYZ(double x, double y, double z) {
  const double cx = std::cos(x), sx = std::sin(x), cy = std::cos(y), sy = std::sin(y),
               cz = std::cos(z), sz = std::sin(z);
  return (Matrix3d() << cy * cz, -cy * sz, sy,                       //
          cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy,  //
          sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy)
      .finished();
}

/// Angles t with R = Rx(t0) Ry(t1) Rz(t2), nearest to `near`. In gimbal lock, the last angle keeps
/// its value.
Vector3d anglesXYZ(const Matrix3d& R, const Vector3d& near) {
  const double sine = std::clamp(R(0, 2), -1.0, 1.0);
  if (std::abs(sine) > 1.0 - 1e-12) {
    const double sign = sine > 0.0 ? 1.0 : -1.0;
    const double sum = std::atan2(R(1, 0), R(1, 1));
    return {nearestTurn(sign * (sum - near[2]), near[0]), nearestTurn(sign * M_PI / 2, near[1]),
            near[2]};
  }
  const Vector3d first(std::atan2(-R(1, 2), R(2, 2)), std::asin(sine),
                       std::atan2(-R(0, 1), R(0, 0)));
  const Vector3d second(first[0] + M_PI, M_PI - first[1], first[2] + M_PI);
  Vector3d best = first;
  double best_distance = HUGE_VAL;
  for (Vector3d t : {first, second}) {
    for (int i = 0; i < 3; ++i) t[i] = nearestTurn(t[i], near[i]);
    if ((t - near).squaredNorm() >= best_distance) continue;
    best_distance = (t - near).squaredNorm();
    best = t;
  }
  return best;
}

/// Lowest and highest angles of the joints, rad, in the order of their parameters.
struct JointRanges {
  using Range = std::array<double, 2>;
  Range hip[3], knee, clavicle[2], shoulder[3], elbow, spine[2], head[3];
};

FleischmannLimits limitsOf(const JointRanges& ranges) {
  FleischmannLimits limits;
  limits.lower.setConstant(-HUGE_VAL);
  limits.upper.setConstant(HUGE_VAL);
  const auto set = [&](int first, const JointRanges::Range* own, int count) {
    for (int i = 0; i < count; ++i) {
      limits.lower[first + i] = own[i][0];
      limits.upper[first + i] = own[i][1];
    }
  };
  for (const Side& side : kSides) {
    set(side.hip, ranges.hip, 3);
    set(side.knee, &ranges.knee, 1);
    set(side.clavicle, ranges.clavicle, 2);
    set(side.shoulder, ranges.shoulder, 3);
    set(side.elbow, &ranges.elbow, 1);
  }
  set(kSpine, ranges.spine, 2);
  set(kHeadTurn, ranges.head, 3);
  return limits;
}

}  // namespace

FleischmannLimits FleischmannLimits::walking() {
  return limitsOf({{{-0.3, 0.9}, {-0.7, 2.2}, {-0.3, 0.6}},
                   {0.0, 2.6},
                   {{-0.3, 0.3}, {-0.2, 0.5}},
                   {{-0.2, 3.0}, {-1.1, 3.2}, {-1.4, 1.4}},
                   {0.0, 2.6},
                   {{-0.5, 1.2}, {-0.6, 0.6}},
                   {{-0.8, 0.8}, {-1.0, 1.0}, {-1.4, 1.4}}});
}

FleischmannLimits FleischmannLimits::full() {
  return limitsOf({{{-0.55, 0.9}, {-0.7, 2.2}, {-0.8, 0.8}},
                   {0.0, 2.6},
                   {{-0.5, 0.5}, {-0.3, 0.8}},
                   {{-0.9, 3.2}, {-1.1, 3.2}, {-1.6, 1.6}},
                   {0.0, 2.7},
                   {{-0.6, 1.5}, {-0.7, 0.7}},
                   {{-0.8, 0.8}, {-1.0, 1.0}, {-1.4, 1.4}}});
}

FleischmannBodyModel::FleischmannBodyModel(const BodyModel& model) {
  const LinkPoses zero = uprightZeroPose(model);
  for (int s = 0; s < kFleischmannSegments; ++s) {
    link_[s] = model.linkIndex(kSegments[s].link);
    joint_[s] = zero[link_[s]].translation() - zero[link_[kSegments[s].parent]].translation();
  }
  const std::vector<Vector3d> positions = markerPositions(model, zero);
  for (size_t m = 0; m < positions.size(); ++m)
    markers_.push_back(
        {kMarkerSegments[m], positions[m] - zero[link_[kMarkerSegments[m]]].translation()});
}

void FleischmannBodyModel::frames(const double* v, FleischmannFrames& out) const {
  out.R[kPelvisSegment] = rotXYZ(-v[0], -v[1], -v[2]).transpose();
  out.p[kPelvisSegment] = Eigen::Map<const Vector3d>(v + kPelvisPosition);
  const auto place = [&](int segment, const Matrix3d& R) {
    const int parent = kSegments[segment].parent;
    out.R[segment].noalias() = out.R[parent] * R;
    out.p[segment] = out.p[parent] + out.R[parent] * joint_[segment];
  };
  place(kChestSegment, rotY(v[kSpine]) * rotX(v[kSpine + 1]));
  place(kSkullSegment, rotXYZ(v[kHeadTurn], v[kHeadTurn + 1], v[kHeadTurn + 2]));
  for (int i = 0; i < 2; ++i) {
    const Side& at = kSides[i];
    const double s = at.sign;
    const auto joint = [&](int first) {
      return rotXYZ(s * v[first], -v[first + 1], s * v[first + 2]);
    };
    place(kLeftClavicleSegment + i,
          rotXYZ(-s * v[at.clavicle + 1], 0.0, s * v[at.clavicle]).transpose());
    place(kLeftUpperArm + i, joint(at.shoulder));
    place(kLeftLowerArm + i, rotY(-v[at.elbow]));
    place(kLeftThigh + i, joint(at.hip));
    place(kLeftCalf + i, rotY(v[at.knee]));
  }
}

FleischmannVector FleischmannBodyModel::parametersOf(const LinkPoses& T_world_link,
                                                     const FleischmannVector& near) const {
  const auto relative = [&](int segment) -> Matrix3d {
    return T_world_link.at(link_[kSegments[segment].parent]).linear().transpose() *
           T_world_link.at(link_[segment]).linear();
  };
  FleischmannVector v;
  const Eigen::Isometry3d& pelvis = T_world_link.at(link_[kPelvisSegment]);
  v.segment<3>(kPelvisOrientation) =
      -anglesXYZ(pelvis.linear().transpose(), -near.segment<3>(kPelvisOrientation));
  v.segment<3>(kPelvisPosition) = pelvis.translation();
  const Matrix3d spine = relative(kChestSegment);
  v[kSpine] = std::atan2(-spine(2, 0), spine(0, 0));
  v[kSpine + 1] = std::atan2(-spine(1, 2), spine(1, 1));
  v.segment<3>(kHeadTurn) = anglesXYZ(relative(kSkullSegment), near.segment<3>(kHeadTurn));
  for (int i = 0; i < 2; ++i) {
    const Side& at = kSides[i];
    const Vector3d mirror(at.sign, -1.0, at.sign);
    const auto joint = [&](int segment, int first) {
      v.segment<3>(first) = mirror.cwiseProduct(
          anglesXYZ(relative(segment), mirror.cwiseProduct(near.segment<3>(first))));
    };
    const auto hinge = [&](int segment, double sign) {
      const Matrix3d R = relative(segment);
      return sign * std::atan2(R(0, 2), R(2, 2));
    };
    const Matrix3d clavicle = relative(kLeftClavicleSegment + i);
    v[at.clavicle] = -at.sign * std::atan2(clavicle(1, 0), clavicle(0, 0));
    v[at.clavicle + 1] = at.sign * std::atan2(clavicle(2, 1), clavicle(2, 2));
    joint(kLeftUpperArm + i, at.shoulder);
    v[at.elbow] = hinge(kLeftLowerArm + i, -1.0);
    joint(kLeftThigh + i, at.hip);
    v[at.knee] = hinge(kLeftCalf + i, 1.0);
  }
  return v;
}

std::vector<Vector3d> FleischmannBodyModel::markers(const FleischmannFrames& frames) const {
  std::vector<Vector3d> positions;
  for (const Marker& marker : markers_)
    positions.push_back(frames.p[marker.segment] + frames.R[marker.segment] * marker.offset);
  return positions;
}

}  // namespace markerless_mocap
