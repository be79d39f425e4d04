#pragma once

#include "body/body_fixture.h"
#include "hsiao/fit/hsiao_skeleton_error.h"
#include "hsiao/model/hsiao_body_model.h"
#include "hsiao/model/hsiao_body_shape.h"
#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

inline double degrees(double value) {
  return value * M_PI / 180.0;
}

/// Upright at (1, 2), hips about 0.9 m high, facing `yaw`, arms hanging.
inline HsiaoVector standing(const HsiaoBodyModel& body_model, double yaw = 0.0) {
  HsiaoVector v = HsiaoVector::Zero();
  v.segment<3>(kHsiaoCenter) << 1.0, 2.0, 1.2;
  v.segment<3>(kHsiaoNeck) << 1.0, 2.0, 1.2 + body_model.halfTorso();
  v[kHsiaoSpin] = yaw;
  v[hsiaoTheta(3)] = -M_PI / 2;
  v[hsiaoTheta(4)] = M_PI / 2;
  return v;
}

/// Mid-step: arms half raised and bent, one knee bent.
inline HsiaoVector stepping(const HsiaoBodyModel& body_model, double yaw) {
  HsiaoVector v = standing(body_model, yaw);
  v[hsiaoTheta(3)] = degrees(-35);
  v[hsiaoTheta(4)] = degrees(50);
  v[hsiaoTheta(7)] = degrees(-25);
  v[hsiaoTheta(8)] = degrees(-15);
  v[hsiaoTheta(9)] = degrees(-50);
  v[hsiaoTheta(10)] = degrees(35);
  v[hsiaoTheta(11)] = degrees(8);
  v[hsiaoTheta(12)] = degrees(-8);
  v[hsiaoTheta(13)] = degrees(-35);
  v[hsiaoTheta(14)] = degrees(20);
  v[hsiaoTheta(15)] = degrees(20);
  v[hsiaoTheta(16)] = degrees(40);
  return v;
}

inline Eigen::Vector3d alongLine(const std::vector<Eigen::Vector3d>& line, double share) {
  double length = 0.0;
  for (size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  double left = share * length;
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    const double stretch = (line[i] - line[i - 1]).norm();
    if (left <= stretch) return line[i - 1] + left / stretch * (line[i] - line[i - 1]);
    left -= stretch;
  }
  const Eigen::Vector3d last = line.back() - line[line.size() - 2];
  return line[line.size() - 2] + left / last.norm() * last;
}

/// Part curves of a person in the pose `v`: its bones, arms without fingers as a hull shows them.
inline BodyParts curvesOf(const HsiaoBodyModel& body_model, const HsiaoVector& v) {
  HsiaoFrames frames;
  body_model.frames(v.data(), frames);
  BodyParts parts;
  parts.status = SegmentationStatus::kOk;
  for (int part = 0; part < kPartCount; ++part) {
    std::vector<Eigen::Vector3d> line;
    for (const HsiaoSegmentPoint& node : body_model.bones(PartLabel(part)))
      line.push_back(node.inWorld(frames));
    const bool arm = part == int(PartLabel::kArm1) || part == int(PartLabel::kArm2);
    PartCurve& curve = parts.parts[part];
    curve.seen = curve.whole = true;
    for (int k = 0; k <= 24; ++k) {
      curve.points.push_back(alongLine(line, (arm ? 1.0 - kFingerShare : 1.0) * k / 24.0));
      curve.site_values.push_back(k / 24.0);
    }
  }
  return parts;
}

/// Voxels of 30 mm inside the body's shape in the pose `v`.
inline VisualHull hullOf(const HsiaoBodyModel& body_model, const HsiaoBodyShape& shape,
                         const HsiaoVector& v) {
  HsiaoFrames frames;
  body_model.frames(v.data(), frames);
  std::vector<HsiaoWorldCone> cones;
  shape.inWorld(frames, cones);
  VisualHull hull;
  hull.status = HullStatus::kOk;
  hull.lattice.origin = {-0.5, 0.5, -0.3};
  hull.lattice.size = {100, 100, 80};
  for (uint32_t i = 0; i < hull.lattice.count(); ++i) {
    const Eigen::Vector3d center = hull.lattice.center(i);
    for (const HsiaoWorldCone& cone : cones) {
      if (cone.signedDistance(center) > 0.0) continue;
      HullVoxel voxel;
      voxel.index = i;
      hull.voxels.push_back(voxel);
      break;
    }
  }
  return hull;
}

}  // namespace markerless_mocap
