#include "contour/model/contour_kinematics.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using S = ContourSegment;
using B = SphericalJoint;
using A = RevoluteJoint;
using L = BodyLength;
using C = BodyCone;

// Fractions of the URDF body in urdf/human.urdf.in: position of the waist, roots of the clavicles,
// centre of the head, and offset of the head.
constexpr double kWaist = 0.3, kClavicleRoot = 0.1, kHeadMiddle = 0.71, kHeadForward = 0.026;
constexpr double kHeel = 0.24, kToes = 0.76;

ShapeDependentPoint sized(std::initializer_list<ShapeDependentPoint::Term> terms) {
  return {std::vector<ShapeDependentPoint::Term>(terms)};
}
Vector3d up(double fraction) {
  return {0, 0, fraction};
}
Vector3d left(double fraction) {
  return {0, fraction, 0};
}
Vector3d forward(double fraction) {
  return {fraction, 0, 0};
}

KinematicSegment sphericalSegment(int parent, int spherical_joint, ShapeDependentPoint joint) {
  return {parent, spherical_joint, -1, {}, std::move(joint), 0};
}
KinematicSegment onAxes(int parent, int first_angle, std::vector<Vector3d> axes,
                        ShapeDependentPoint joint) {
  return {parent, -1, first_angle, std::move(axes), std::move(joint), 0};
}

void addLimbs(bool right, std::array<KinematicSegment, S::kCount>& s) {
  const double y = right ? -1 : 1;
  const int side = right ? 1 : 0;
  const std::vector<Vector3d> bend = {-Vector3d::UnitY()};
  s[S::kLeftClavicle + side] =
      onAxes(S::kChest, right ? A::kRightClavicleYaw : A::kLeftClavicleYaw,
             {-y * Vector3d::UnitZ(), y * Vector3d::UnitX()},
             sized({{L::kTorso, up(1 - kWaist)}, {L::kShoulderWidth, left(y * kClavicleRoot)}}));
  s[S::kLeftUpperArm + side] =
      sphericalSegment(S::kLeftClavicle + side, B::kLeftShoulder + side,
                       sized({{L::kShoulderWidth, left(y * (0.5 - kClavicleRoot))}}));
  s[S::kLeftForearm + side] =
      onAxes(S::kLeftUpperArm + side, A::kLeftElbow + side, bend, sized({{L::kUpperArm, up(-1)}}));
  s[S::kLeftThigh + side] =
      sphericalSegment(S::kPelvis, B::kLeftHip + side, sized({{L::kHipWidth, left(y * 0.5)}}));
  s[S::kLeftShank + side] =
      onAxes(S::kLeftThigh + side, A::kLeftKnee + side, bend, sized({{L::kThigh, up(-1)}}));
  s[S::kLeftFoot + side] =
      onAxes(S::kLeftShank + side, A::kLeftAnkle + side, bend, sized({{L::kShank, up(-1)}}));
}

uint64_t bitsFrom(int first, int count) {
  return ((uint64_t(1) << count) - 1) << first;
}

std::array<KinematicSegment, S::kCount> segments() {
  std::array<KinematicSegment, S::kCount> s;
  s[S::kPelvis] = sphericalSegment(-1, B::kRoot, {});
  s[S::kChest] =
      onAxes(S::kPelvis, A::kSpinePitch, {Vector3d::UnitY(), Vector3d::UnitX(), Vector3d::UnitZ()},
             sized({{L::kTorso, up(kWaist)}}));
  s[S::kHead] = sphericalSegment(S::kChest, B::kNeck,
                                 sized({{L::kTorso, up(1 - kWaist)}, {L::kNeck, up(1)}}));
  for (const bool right : {false, true}) addLimbs(right, s);
  for (KinematicSegment& segment : s) {
    segment.dof_mask = segment.parent < 0 ? bitsFrom(0, 3) : s[size_t(segment.parent)].dof_mask;
    segment.dof_mask |= segment.spherical_joint >= 0
                            ? bitsFrom(sphericalDof(segment.spherical_joint), 3)
                            : bitsFrom(revoluteDof(segment.first_angle), int(segment.axes.size()));
  }
  return s;
}

/// The ends of a cone without the offsets of the shape.
struct Bones {
  BodyCone::Kind kind;
  ContourSegment::Id segment;  ///< of the left side
  ContourLimb::Id limb;
  bool paired;
  ShapeDependentPoint a, b;
};

std::vector<Bones> bones() {
  const auto shoulder = [] { return sized({{L::kShoulderWidth, left(0.5 - kClavicleRoot)}}); };
  return {
      {C::kPelvis, S::kPelvis, ContourLimb::kTrunk, true, {}, sized({{L::kTorso, up(0.2)}})},
      {C::kChest, S::kChest, ContourLimb::kTrunk, true, {}, sized({{L::kTorso, up(0.5)}})},
      {C::kYoke, S::kLeftClavicle, ContourLimb::kTrunk, true, {}, shoulder()},
      {C::kNeck, S::kHead, ContourLimb::kHead, false, {}, sized({{L::kHead, up(0.4)}})},
      {C::kHead, S::kHead, ContourLimb::kHead, false, sized({{L::kHead, up(0.45)}}),
       sized({{L::kHead, up(0.7)}})},
      {C::kUpperArm,
       S::kLeftUpperArm,
       ContourLimb::kLeftArm,
       true,
       {},
       sized({{L::kUpperArm, up(-1)}})},
      {C::kForearm,
       S::kLeftForearm,
       ContourLimb::kLeftArm,
       true,
       {},
       sized({{L::kForearm, up(-1)}})},
      {C::kHand, S::kLeftForearm, ContourLimb::kLeftArm, true, sized({{L::kForearm, up(-1)}}),
       sized({{L::kForearm, up(-1)}, {L::kHand, up(-0.8)}})},
      {C::kThigh, S::kLeftThigh, ContourLimb::kLeftLeg, true, {}, sized({{L::kThigh, up(-1)}})},
      {C::kCalf, S::kLeftShank, ContourLimb::kLeftLeg, true, {}, sized({{L::kShank, up(-0.4)}})},
      {C::kShin, S::kLeftShank, ContourLimb::kLeftLeg, true, sized({{L::kShank, up(-0.4)}}),
       sized({{L::kShank, up(-1)}})},
      {C::kFoot, S::kLeftFoot, ContourLimb::kLeftLeg, true,
       sized({{L::kFoot, forward(0.1 - kHeel)}, {L::kAnkleHeight, up(-0.5)}}),
       sized({{L::kFoot, forward(kToes - 0.1)}, {L::kAnkleHeight, up(-0.7)}})}};
}

ShapeDependentPoint mirrored(ShapeDependentPoint point) {
  for (ShapeDependentPoint::Term& term : point.terms) term.along.y() = -term.along.y();
  return point;
}

KinematicCone coneOf(const Bones& bone, bool right) {
  KinematicCone cone;
  cone.kind = bone.kind;
  const bool limb = right && bone.limb >= ContourLimb::kLeftArm;
  cone.limb = ContourLimb::Id(bone.limb + (limb ? 1 : 0));
  const bool own_segment = right && bone.segment >= S::kLeftClavicle;
  const auto segment = ContourSegment::Id(bone.segment + (own_segment ? 1 : 0));
  for (int end = 0; end < 2; ++end) {
    ShapeDependentPoint point = end ? bone.b : bone.a;
    for (int axis = 0; axis < 3; ++axis)
      point.terms.push_back({offsetIndex(bone.kind, end) + axis, Vector3d::Unit(axis)});
    cone.ends[end] = {segment, right ? mirrored(std::move(point)) : std::move(point)};
    cone.radius[end] = radiusIndex(bone.kind, end);
  }
  return cone;
}

std::vector<AttachedPoint> ridden() {
  const auto wrist = [] { return sized({{L::kForearm, up(-1)}}); };
  const auto hand = [] { return sized({{L::kForearm, up(-1)}, {L::kHand, up(-1)}}); };
  const auto toes = [] { return sized({{L::kFoot, forward(kToes)}, {L::kAnkleHeight, up(-0.7)}}); };
  return {{S::kPelvis, {}},
          {S::kHead, {}},
          {S::kHead, sized({{L::kHead, up(kHeadMiddle) + forward(kHeadForward)}})},
          {S::kLeftUpperArm, {}},
          {S::kLeftForearm, {}},
          {S::kLeftForearm, wrist()},
          {S::kRightUpperArm, {}},
          {S::kRightForearm, {}},
          {S::kRightForearm, wrist()},
          {S::kLeftThigh, {}},
          {S::kLeftShank, {}},
          {S::kLeftFoot, {}},
          {S::kRightThigh, {}},
          {S::kRightShank, {}},
          {S::kRightFoot, {}},
          {S::kLeftForearm, hand()},
          {S::kRightForearm, hand()},
          {S::kLeftFoot, toes()},
          {S::kRightFoot, toes()},
          {S::kHead, sized({{L::kHead, up(1)}})}};
}

ContourKinematicTree grown() {
  ContourKinematicTree tree;
  tree.segments = segments();
  size_t cone = 0;
  for (const Bones& bone : bones()) {
    tree.cones[cone++] = coneOf(bone, false);
    if (bone.paired) tree.cones[cone++] = coneOf(bone, true);
  }
  tree.points = ridden();
  return tree;
}

}  // namespace

const ContourKinematicTree& contourKinematicTree() {
  static const ContourKinematicTree tree = grown();
  return tree;
}

}  // namespace markerless_mocap
