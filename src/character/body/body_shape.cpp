#include "character/body/body_shape.h"

#include "character/body/signed_distance.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr LoftAxes kUpwards{2, 1, 0}, kSideways{1, 2, 0}, kForwards{0, 1, 2};
constexpr double kLegGap = 0.009;  ///< distance of each leg from the middle plane, metres

}  // namespace

BodyShape::BodyShape(const HumanSkeleton& skeleton, const BodyBuild& build)
    : skeleton_(skeleton),
      build_(build),
      torso_(kUpwards, torsoSections(build), 0.35, scaled(0.02)),
      neck_(kUpwards, neckSections(build), 0.0, scaled(0.02)),
      head_(kUpwards, headSections(build), 0.1, scaled(0.005)),
      leg_(kUpwards, legSections(build), 0.0, scaled(0.02)),
      arm_(kSideways, armSections(build), 0.0, scaled(0.02)),
      hand_(kSideways, handSections(build), 0.5, scaled(0.008)),
      foot_(kForwards, footSections(build), 0.6, scaled(0.012)) {}

double BodyShape::torso(const Vector3d& p) const {
  const auto at = [this](double x, double y, double z) -> Vector3d {
    return Vector3d(x, y, z) * scaled(1.0);
  };
  const double womanly = 1.0 - build_.male, fat = build_.fatness;
  const double neck = skeleton_.headOf(Bone::kNeck).z();
  const Vector3d shoulder = skeleton_.headOf(Bone::kLeftUpperArm);
  double d = torso_.distance(p);
  // Trapezius and shoulder blade, from the side of the neck to the top of the shoulder.
  d = smoothUnion(d,
                  taperedCapsule(p, Vector3d(0, 0, neck + scaled(0.030)) + at(-.035, .030, 0),
                                 shoulder + at(-.012, -.010, .020), scaled(.034), scaled(.032)),
                  scaled(0.05));
  const double chest = build_.length(1.282, 1.208), seat = build_.length(.872, .826);
  const double breast = womanly * (1.0 + 0.5 * std::max(fat, -0.6));
  // Breast or chest muscle.
  d = smoothUnion(d,
                  ellipsoid(p,
                            Vector3d(scaled(.050 + .013 * breast), build_.length(.080, .076),
                                     chest - scaled(.012 * breast)),
                            at(.058 + .017 * breast, .072 - .004 * breast, .058 + .008 * breast)),
                  scaled(0.03));
  // Buttock.
  const double round = 1.0 + 0.25 * fat;
  return smoothUnion(d,
                     ellipsoid(p, Vector3d(scaled(-.058), build_.length(.074, .077), seat),
                               at(.076, .078, .084) * round),
                     scaled(0.03));
}

double BodyShape::head(const Vector3d& p) const {
  const auto at = [this](double x, double y, double z) {
    return Vector3d(build_.length(x, .955 * x), build_.length(y, .955 * y),
                    z * build_.stature / 1.75);
  };
  double d = smoothUnion(head_.distance(p), neck_.distance(p), scaled(0.025));
  if (p.z() < scaled(1.5)) return d;
  // Nose, eye socket, ear.
  d = smoothUnion(
      d, taperedCapsule(p, at(.092, 0, 1.636), at(.107, 0, 1.604), scaled(.007), scaled(.011)),
      scaled(0.012));
  d = smoothIntersection(d, -ellipsoid(p, at(.101, .033, 1.640), at(.014, .020, .012)),
                         scaled(0.02));
  return smoothUnion(d, ellipsoid(p, at(-.008, .078, 1.622), at(.020, .010, .032)), scaled(0.008));
}

double BodyShape::hand(const Vector3d& q) const {
  const auto at = [this](double x, double y, double z) {
    return Vector3d(build_.length(x, .86 * x), build_.length(y, .86 * y),
                    build_.length(z, .86 * z));
  };
  const double thickness = build_.length(1.0, 0.86);
  double d = hand_.distance(q);
  const Vector3d ball = at(.034, .040, -.008), knuckle = at(.054, .072, -.012);
  const double thumb = smoothUnion(
      taperedCapsule(q, at(.020, .018, -.004), knuckle, .017 * thickness, .0125 * thickness),
      taperedCapsule(q, knuckle, at(.060, .105, -.015), .0125 * thickness, .010 * thickness),
      scaled(.006));
  d = smoothUnion(d, thumb, scaled(.010));
  return smoothUnion(d, ellipsoid(q, ball, at(.016, .026, .014)), scaled(.012));
}

PartDistances BodyShape::parts(const Vector3d& p) const {
  const Vector3d wrist = skeleton_.headOf(Bone::kLeftHand);
  const Vector3d shoulder = skeleton_.headOf(Bone::kLeftUpperArm);
  const Vector3d ankle = skeleton_.headOf(Bone::kLeftFoot);
  PartDistances parts;
  parts.torso = torso(p);
  parts.arm = arm_.distance(p - shoulder);
  parts.hand = hand(p - wrist);
  // Thighs touch, but their surfaces must not, so that they can separate in a stride.
  parts.leg = smoothIntersection(leg_.distance(p), scaled(kLegGap) - p.y(), scaled(.008));
  parts.foot = foot_.distance(p - Vector3d(ankle.x(), ankle.y(), 0.0));
  parts.head = head(p);
  return parts;
}

double BodyShape::torsoAndArm(const PartDistances& parts) const {
  return smoothUnion(parts.torso, parts.arm, scaled(0.05));
}

double BodyShape::torsoAndLeg(const PartDistances& parts) const {
  return smoothUnion(smoothUnion(parts.torso, parts.leg, scaled(0.035)), parts.foot, scaled(0.02));
}

double BodyShape::whole(const PartDistances& parts) const {
  const double upper = smoothUnion(torsoAndArm(parts), parts.head, scaled(0.03));
  return std::min(smoothUnion(upper, parts.hand, scaled(0.012)), torsoAndLeg(parts));
}

}  // namespace markerless_mocap
