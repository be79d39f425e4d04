#include "evaluation/body_points.h"

#include <algorithm>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kKnuckles = 0.53;  // fraction of the distance from the wrist to the finger tips
constexpr double kBall = 0.72;      // fraction of the foot's length from the heel

/// The two ends of a shape along its longest cone, in the link's frame.
struct Ends {
  Eigen::Vector3d near, far;  ///< near and far from the link's origin
};

Ends longestEnds(const BodyModel& model, int link, const std::string& name) {
  const RoundCone* longest = nullptr;
  for (const RoundCone& cone : model.shape())
    if (cone.link == link &&
        (!longest || (cone.a - cone.b).norm() > (longest->a - longest->b).norm()))
      longest = &cone;
  if (!longest || longest->a == longest->b)
    throw std::invalid_argument("link " + name + " of body " + model.id() +
                                " has no shape with two ends");
  const Eigen::Vector3d along = (longest->b - longest->a).normalized();
  const Eigen::Vector3d a = longest->a - longest->radius_a * along;
  const Eigen::Vector3d b = longest->b + longest->radius_b * along;
  return a.norm() < b.norm() ? Ends{a, b} : Ends{b, a};
}

/// The highest point of the head's shape in its link's frame.
Eigen::Vector3d crown(const BodyModel& model, int link) {
  Eigen::Vector3d top(0.0, 0.0, -1e9);
  for (const RoundCone& cone : model.shape()) {
    if (cone.link != link) continue;
    for (const auto& end : {std::make_pair(cone.a, cone.radius_a), {cone.b, cone.radius_b}}) {
      const Eigen::Vector3d point = end.first + end.second * Eigen::Vector3d::UnitZ();
      if (point.z() > top.z()) top = point;
    }
  }
  if (top.z() < -1e8)
    throw std::invalid_argument("link head of body " + model.id() + " has no shape");
  return top;
}

}  // namespace

const std::vector<std::string>& tipNames() {
  static const std::vector<std::string> names{"l_hand",     "l_hand_tip", "l_foot",
                                              "l_foot_tip", "r_hand",     "r_hand_tip",
                                              "r_foot",     "r_foot_tip", "head_top"};
  return names;
}

std::vector<std::string> bodyPointNames() {
  std::vector<std::string> names = markerNames();
  names.insert(names.end(), tipNames().begin(), tipNames().end());
  return names;
}

Eigen::Matrix3Xd bodyPoints(const BodyModel& model, const LinkPoses& T_world_link) {
  std::vector<Eigen::Vector3d> points = markerPositions(model, T_world_link);
  for (const std::string side : {"l_", "r_"}) {
    const int wrist = model.linkIndex(side + "wrist"), ankle = model.linkIndex(side + "ankle");
    const Ends hand = longestEnds(model, wrist, side + "wrist");
    const Ends foot = longestEnds(model, ankle, side + "ankle");
    const Eigen::Vector3d ball = foot.near + kBall * (foot.far - foot.near);
    points.push_back(T_world_link[wrist] * (kKnuckles * hand.far));
    points.push_back(T_world_link[wrist] * hand.far);
    points.push_back(T_world_link[ankle] * ball);
    points.push_back(T_world_link[ankle] * foot.far);
  }
  const int head = model.linkIndex("head");
  points.push_back(T_world_link[head] * crown(model, head));
  Eigen::Matrix3Xd out(3, points.size());
  for (size_t i = 0; i < points.size(); ++i) out.col(i) = points[i];
  return out;
}

Eigen::Vector2d soleHeights(const BodyModel& model, const LinkPoses& T_world_link) {
  Eigen::Vector2d heights;
  for (int side = 0; side < 2; ++side) {
    const std::string name = side == 0 ? "l_ankle" : "r_ankle";
    const int link = model.linkIndex(name);
    std::vector<double> lows;
    for (const RoundCone& cone : model.shape())
      if (cone.link == link)
        for (const auto& [end, radius] :
             {std::pair{cone.a, cone.radius_a}, {cone.b, cone.radius_b}})
          lows.push_back((T_world_link[link] * end).z() - radius);
    if (lows.empty())
      throw std::invalid_argument("link " + name + " of body " + model.id() + " has no shape");
    heights[side] = *std::min_element(lows.begin(), lows.end());
  }
  return heights;
}

}  // namespace markerless_mocap
