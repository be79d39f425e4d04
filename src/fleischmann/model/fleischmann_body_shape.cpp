#include "fleischmann/model/fleischmann_body_shape.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "body/zero_pose.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

/// Heights at which widths are measured, as fractions of the axis.
constexpr double kLowHeight = 0.25, kHighHeight = 0.75;

/// Where a cone is measured.
struct ConePlan {
  FleischmannSegment segment;
  std::vector<const char*> links;
  Vector3d a, b;        ///< zero pose, world
  double length = 1.0;  ///< of the cone relative to b - a
};

/// Geometry of the model in the zero pose.
class ZeroShape {
 public:
  explicit ZeroShape(const BodyModel& model) : model_(model), links_(zeroPose(model)) {}

  Vector3d at(const char* link) const { return links_[model_.linkIndex(link)].translation(); }

  /// Half the width along `direction` of the links' round cones in a plane through `point`.
  double halfWidth(const std::vector<const char*>& links, const Vector3d& point,
                   const Vector3d& axis, const Vector3d& direction) const {
    double low = HUGE_VAL, high = -HUGE_VAL;
    forEachBall(links, [&](const Vector3d& center, double radius) {
      const double away = axis.dot(center - point);
      if (std::abs(away) >= radius) return;
      const double reach = std::sqrt(radius * radius - away * away);
      low = std::min(low, direction.dot(center - point) - reach);
      high = std::max(high, direction.dot(center - point) + reach);
    });
    if (low > high)
      throw std::invalid_argument("body " + model_.id() + ": link " + links.front() +
                                  " has no geometry where a cone is measured");
    return (high - low) / 2.0;
  }

  /// Minimum and maximum z of the links' geometry.
  std::array<double, 2> heights(const std::vector<const char*>& links) const {
    std::array<double, 2> z = {HUGE_VAL, -HUGE_VAL};
    forEachBall(links, [&](const Vector3d& center, double radius) {
      z = {std::min(z[0], center.z() - radius), std::max(z[1], center.z() + radius)};
    });
    return z;
  }

 private:
  template <class Visit>
  void forEachBall(const std::vector<const char*>& links, const Visit& visit) const {
    constexpr int kBalls = 40;
    for (const RoundCone& cone : model_.shape())
      for (const char* link : links) {
        if (cone.link != model_.linkIndex(link)) continue;
        const Eigen::Isometry3d& T = links_[size_t(cone.link)];
        for (int i = 0; i <= kBalls; ++i) {
          const double t = double(i) / kBalls;
          visit(T * Vector3d(cone.a + t * (cone.b - cone.a)),
                cone.radius_a + t * (cone.radius_b - cone.radius_a));
        }
      }
  }

  const BodyModel& model_;
  LinkPoses links_;
};

/// The cross-sections at the two heights, where limbs are not rounded, determine the scale of the
/// ends; both have the same shape.
FleischmannCone measured(const ZeroShape& shape, const ConePlan& plan, const Vector3d& origin) {
  const Vector3d along = plan.b - plan.a, axis = along.normalized();
  const Vector3d side = Vector3d(0, 1, 0) - axis.y() * axis, forward = side.cross(axis);
  const Vector3d v = side.normalized(), u = forward.normalized();
  double width[2], depth[2];
  const double heights[2] = {kLowHeight, kHighHeight};
  for (int i = 0; i < 2; ++i) {
    const Vector3d point = plan.a + heights[i] * along;
    width[i] = shape.halfWidth(plan.links, point, axis, v);
    depth[i] = shape.halfWidth(plan.links, point, axis, u);
  }
  const double low = width[0] + depth[0], high = width[1] + depth[1], both = low + high;
  FleischmannCone cone;
  cone.segment = plan.segment;
  cone.a = plan.a - origin;
  cone.b = cone.a + plan.length * along;
  cone.v = v * (width[0] + width[1]) * low / both;
  cone.u = u * (depth[0] + depth[1]) * low / both;
  cone.taper = high / low;
  return cone;
}

std::array<ConePlan, kFleischmannConeCount> plansOf(const ZeroShape& shape, double lower_limb) {
  const Vector3d hips = (shape.at("l_hip") + shape.at("r_hip")) / 2;
  const Vector3d neck = shape.at("r_head");
  const std::vector<const char*> trunk = {"body", "r_waist", "torso"};
  const std::vector<const char*> skull = {"p_head", "head"};
  // In an image, the upper edge of the shoulders extends to the neck.
  const Vector3d torso_top(neck.x(), 0, neck.z() + (neck.z() - shape.at("torso").z()) / 2);
  const std::array<double, 2> head = shape.heights({"head"});
  const Vector3d chin(shape.at("head").x(), 0, head[0]), crown(chin.x(), 0, head[1]);
  const auto limb = [&](FleischmannSegment segment, const char* upper, const char* lower,
                        double length) {
    return ConePlan{segment, {upper}, shape.at(upper), shape.at(lower), length};
  };
  return {{{kPelvisSegment, trunk, hips - Vector3d(0, 0, 0.06), torso_top, 1.0},
           limb(kLeftThigh, "l_hip", "l_knee", 1.0),
           limb(kLeftCalf, "l_knee", "l_ankle", lower_limb),
           limb(kRightThigh, "r_hip", "r_knee", 1.0),
           limb(kRightCalf, "r_knee", "r_ankle", lower_limb),
           limb(kLeftUpperArm, "l_shoulder", "l_elbow", 1.0),
           limb(kLeftLowerArm, "l_elbow", "l_wrist", lower_limb),
           limb(kRightUpperArm, "r_shoulder", "r_elbow", 1.0),
           limb(kRightLowerArm, "r_elbow", "r_wrist", lower_limb),
           {kSkullSegment, skull, chin, crown, 1.0}}};
}

/// Squared distance between two segments (Ericson, Real-Time Collision Detection, 5.1.9).
double squaredDistance(const Vector3d& p1, const Vector3d& d1, const Vector3d& p2,
                       const Vector3d& d2) {
  const Vector3d r = p1 - p2;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r),
               b = d1.dot(d2), denominator = a * e - b * b;
  double s = denominator > 1e-12 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  return (r + s * d1 - t * d2).squaredNorm();
}

/// Pairs of limbs that meet when people walk. Limbs that share a joint are left out.
constexpr FleischmannConeId kPairs[][2] = {
    {kLeftThighCone, kRightCalfCone},        {kRightThighCone, kLeftCalfCone},
    {kLeftCalfCone, kRightCalfCone},         {kLeftLowerArmCone, kTorsoCone},
    {kRightLowerArmCone, kTorsoCone},        {kLeftLowerArmCone, kRightLowerArmCone},
    {kLeftLowerArmCone, kRightUpperArmCone}, {kRightLowerArmCone, kLeftUpperArmCone},
    {kLeftLowerArmCone, kLeftThighCone},     {kLeftLowerArmCone, kRightThighCone},
    {kRightLowerArmCone, kLeftThighCone},    {kRightLowerArmCone, kRightThighCone},
    {kLeftLowerArmCone, kHeadCone},          {kRightLowerArmCone, kHeadCone}};

constexpr double kThighsMeet = 1.0 / 3.0;  // of their lengths, below the pelvis

bool shareJoint(int i, int j) {
  const auto onTorso = [](int cone) { return cone % 2 == 1; };  // thighs, upper arms, head
  if (i == kTorsoCone) return onTorso(j);
  return j == i + 1 && onTorso(i);
}

}  // namespace

std::vector<LimbCollision::Pair> LimbCollision::pairsOf(bool all) {
  std::vector<Pair> pairs;
  if (!all)
    for (const auto& pair : kPairs) pairs.push_back({pair[0], pair[1], 0.0});
  for (int i = 0; all && i < kFleischmannConeCount; ++i)
    for (int j = i + 1; j < kFleischmannConeCount; ++j)
      if (!shareJoint(i, j))
        pairs.push_back({FleischmannConeId(i), FleischmannConeId(j),
                         i == kLeftThighCone && j == kRightThighCone ? kThighsMeet : 0.0});
  return pairs;
}

FleischmannBodyShape::FleischmannBodyShape(const BodyModel& model,
                                           const FleischmannBodyModel& body_model,
                                           const FleischmannBodyOptions& options) {
  const ZeroShape shape(model);
  const std::array<ConePlan, kFleischmannConeCount> plans =
      plansOf(shape, options.lower_limb_length);
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const std::string link = model.links()[size_t(body_model.link(plans[i].segment))];
    const std::string base = link.substr(0, link.size() - model.id().size() - 1);
    cones_[i] = measured(shape, plans[i], shape.at(base.c_str()));
  }
  for (const FleischmannConeId thigh : {kLeftThighCone, kRightThighCone}) {
    cones_[thigh].u *= options.thigh_width;
    cones_[thigh].v *= options.thigh_width;
  }
}

FleischmannBodyShape FleischmannBodyShape::scaled(
    const std::array<FleischmannConeScale, kFleischmannConeCount>& scales) const {
  FleischmannBodyShape body = *this;
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    if (!(scales[i].width > 0 && scales[i].depth > 0 && scales[i].taper > 0))
      throw std::invalid_argument("scale factors of cone " + std::to_string(i) +
                                  " must be greater than 0");
    body.cones_[i].v *= scales[i].width;
    body.cones_[i].u *= scales[i].depth;
    body.cones_[i].taper *= scales[i].taper;
    body.cones_[i].a.x() += scales[i].forward;
    body.cones_[i].b.x() += scales[i].forward;
  }
  return body;
}

LimbCollision::LimbCollision(const FleischmannBodyShape& body,
                             const FleischmannBodyOptions& options)
    : torso_(body.cones()[kTorsoCone]),
      fraction_(options.collision_fraction),
      pairs_(pairsOf(options.collision_pairs == "all")) {
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const FleischmannCone& cone = body.cones()[i];
    const double smaller = std::min(cone.u.norm(), cone.v.norm());
    limbs_[i] = {cone.segment, cone.a, cone.b, smaller * (1.0 + cone.taper) / 2.0};
  }
}

bool LimbCollision::inTorso(const Vector3d& point, const FleischmannFrames& frames,
                            double radius) const {
  const Vector3d along = torso_.b - torso_.a;
  const Vector3d local =
      frames.R[torso_.segment].transpose() * (point - frames.p[torso_.segment]) - torso_.a;
  const double height = local.dot(along) / along.squaredNorm();
  if (height < 0.0 || height > 1.0) return false;
  const double size = 1.0 + height * (torso_.taper - 1.0);
  const double u = torso_.u.norm(), v = torso_.v.norm();
  const double x = local.dot(torso_.u) / u / (u * size + radius);
  const double y = local.dot(torso_.v) / v / (v * size + radius);
  return x * x + y * y < fraction_ * fraction_;
}

bool LimbCollision::operator()(const FleischmannFrames& frames) const {
  std::array<Vector3d, kFleischmannConeCount> start, along;
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const Limb& limb = limbs_[i];
    start[i] = frames.p[limb.segment] + frames.R[limb.segment] * limb.a;
    along[i] = frames.R[limb.segment] * (limb.b - limb.a);
  }
  for (const FleischmannConeId arm : {kLeftLowerArmCone, kRightLowerArmCone})
    for (const double at : {0.0, 0.5, 1.0})
      if (inTorso(start[arm] + at * along[arm], frames, limbs_[arm].radius)) return true;
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
    const int i = pair.a, j = pair.b;
    const double min_distance = fraction_ * (limbs_[i].radius + limbs_[j].radius);
    const double length = 1.0 - pair.from;
    return squaredDistance(start[i] + pair.from * along[i], length * along[i],
                           start[j] + pair.from * along[j],
                           length * along[j]) < min_distance * min_distance;
  });
}

}  // namespace markerless_mocap
