#include "studies/label_samples/limb_shares.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kStraight = 0.06;   // of a limb's end, which gives its direction, metres
constexpr double kMostBeyond = 0.2;  // from a leaf to the surface, metres

/// Where the foot of the perpendicular from a point lies on a line of points: path length from its
/// beginning, metres, and position.
struct Foot {
  double length = 0.0;
  Vector3d position;
};

Foot footOn(const NodePath& path, const Vector3d& point) {
  Foot best{0.0, path.front()};
  double length = 0.0;
  for (size_t i = 1; i < path.size(); ++i) {
    const Vector3d step = path[i] - path[i - 1];
    const double along = nearestFraction(point, path[i - 1], step);
    const Vector3d at = path[i - 1] + along * step;
    if ((at - point).norm() < (best.position - point).norm())
      best = {length + along * step.norm(), at};
    length += step.norm();
  }
  return best;
}

/// The path of an extremity, continued to the hull's surface.
NodePath fromSurface(const TreeVolume& volume, NodePath path) {
  const NodePath last = pathSection(path, 0.0, kStraight);
  const Vector3d out = (last.front() - last.back()).stableNormalized();
  const double beyond =
      volume.distanceToSurface(path.front(), out, kMostBeyond) + 0.5 * volume.pitch();
  path.insert(path.begin(), path.front() + beyond * out);
  return path;
}

}  // namespace

std::vector<std::pair<std::string, double>> limbShares(const Labelling& labelling,
                                                       const PoseTree& tree,
                                                       const JointTrack& truth) {
  std::vector<std::pair<std::string, double>> shares;
  const auto at = [&](const std::string& name) -> Vector3d {
    return truth.positions.front().col(truth.indexOf(name));
  };
  const auto add = [&](const char* name, double metres) {
    shares.emplace_back(name, metres / labelling.choice().longest);
  };
  const auto limb = [&](Extremity extremity) {
    return fromSurface(labelling.volume(), pathUp(tree, tree.extremity(extremity).node));
  };
  NodePath trunk = pathUp(tree, tree.extremity(Extremity::kLeftFoot).node);  // from the head down
  std::reverse(trunk.begin(), trunk.end());
  add("kHeadBack", footOn(fromSurface(labelling.volume(), trunk), at("head")).length);
  for (const bool left : {true, false}) {
    const std::string side = left ? "l_" : "r_";
    const NodePath arm = limb(left ? Extremity::kLeftHand : Extremity::kRightHand);
    const NodePath leg = limb(left ? Extremity::kLeftFoot : Extremity::kRightFoot);
    const double hand = footOn(arm, at(side + "hand")).length;
    const double foot = footOn(leg, at(side + "foot")).length;
    add("kHandBack", hand);
    add("kFootBack", foot);
    add("kWrist", footOn(arm, at(side + "wrist")).length - hand);
    add("kElbow", footOn(arm, at(side + "elbow")).length - hand);
    add("kAnkle", footOn(leg, at(side + "ankle")).length - foot);
    add("kKnee", footOn(leg, at(side + "knee")).length - foot);
  }
  add("kNeckDown", footOn(trunk, at("thorax")).length);
  const Vector3d up = tree.forward.cross(tree.left);
  const auto beside = [&](const std::string& joint, const char* down, const char* out,
                          const char* above) {
    const Vector3d left = at("l_" + joint), right = at("r_" + joint);
    const Foot on_trunk = footOn(trunk, 0.5 * (left + right));
    add(down, on_trunk.length);
    add(out, 0.5 * tree.left.dot(left - right));
    add(above, up.dot(0.5 * (left + right) - on_trunk.position));
  };
  beside("shoulder", "kShouldersDown", "kShoulderOut", "kShoulderUp");
  beside("hip", "kHipsDown", "kHipOut", "kHipUp");
  return shares;
}

}  // namespace markerless_mocap
