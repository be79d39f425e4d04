#include "motion/bone_names.h"

#include <algorithm>
#include <stdexcept>

#include "motion/retarget/joint_name.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

/// Names of a bone, the most specific first. "shoulder" can be the clavicle or the upper arm,
/// depending on the other joints.
struct BoneWords {
  Bone left;
  std::vector<const char*> words;
};

// The order matters, as each joint is assigned once: "shoulder" is the upper arm only if there is
// no "arm", else the clavicle.
const std::vector<BoneWords>& sidedWords() {
  static const std::vector<BoneWords> rows{
      {Bone::kLeftThigh, {"thigh", "upleg", "upperleg", "legupper", "femur", "hip"}},
      {Bone::kLeftShank,
       {"shank", "shin", "calf", "lowerleg", "loleg", "lowleg", "leglower", "tibia", "knee",
        "leg"}},
      {Bone::kLeftFoot, {"ankle", "foot"}},
      {Bone::kLeftToes, {"toebase", "toes", "toe", "ball", "foot"}},
      {Bone::kLeftUpperArm,
       {"upperarm", "uparm", "uarm", "armupper", "humerus", "arm", "shldr", "shoulder"}},
      {Bone::kLeftForearm,
       {"forearm", "farm", "lowerarm", "loarm", "lowarm", "armlower", "radius", "elbow"}},
      {Bone::kLeftHand, {"wrist", "hand"}},
      {Bone::kLeftClavicle, {"clavicle", "collar", "collarbone", "shoulder", "scapula"}}};
  return rows;
}

class Mapper {
 public:
  Mapper(const std::vector<NamedJoint>& joints, const std::string& file)
      : joints_(joints), file_(file), taken_(joints.size(), false) {
    map_.joint.fill(-1);
    for (const NamedJoint& joint : joints) {
      parsed_.push_back(parseJointName(joint.name));
      depth_.push_back(joint.parent < 0 ? 0 : depth_[size_t(joint.parent)] + 1);
    }
  }

  BoneMap map() {
    for (const BoneWords& row : sidedWords()) {
      assign(row.left, find(row.words, 'l'));
      assign(mirrorOf(row.left), find(row.words, 'r'));
    }
    requireLimbs();
    mapTrunk();
    return map_;
  }

 private:
  void assign(Bone bone, int joint) {
    map_.joint[size_t(bone)] = joint;
    if (joint >= 0) taken_[size_t(joint)] = true;
  }

  int find(const std::vector<const char*>& words, char side) const {
    for (const char* word : words) {
      std::vector<int> found;
      for (size_t j = 0; j < joints_.size(); ++j)
        if (!taken_[j] && !parsed_[j].helper && parsed_[j].side == side && parsed_[j].word == word)
          found.push_back(int(j));
      if (!found.empty()) return nearestToRoot(found);
    }
    return -1;
  }

  /// Of five toes the middle one.
  int nearestToRoot(const std::vector<int>& joints) const {
    int min_depth = depth_[size_t(joints.front())];
    for (int j : joints) min_depth = std::min(min_depth, depth_[size_t(j)]);
    std::vector<std::pair<int, int>> nearest;
    for (int j : joints)
      if (depth_[size_t(j)] == min_depth) nearest.emplace_back(parsed_[size_t(j)].number, j);
    std::sort(nearest.begin(), nearest.end());
    return nearest[(nearest.size() - 1) / 2].second;
  }

  void requireLimbs() const {
    std::string missing, names;
    for (Bone left : {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftThigh, Bone::kLeftShank,
                      Bone::kLeftFoot})
      for (Bone bone : {left, mirrorOf(left)})
        if (!map_.has(bone)) addWord(&missing, boneName(bone));
    if (missing.empty()) return;
    constexpr size_t kMaxNames = 60;
    for (size_t j = 0; j < std::min(joints_.size(), kMaxNames); ++j)
      names += (j ? ", " : "") + joints_[j].name;
    if (joints_.size() > kMaxNames) names += ", ...";
    throw std::invalid_argument(file_ + ": no joint is named like " + missing +
                                "; the joints are " + (names.empty() ? "none" : names));
  }

  void mapTrunk() {
    const int hips = meeting(map_[Bone::kLeftThigh], map_[Bone::kRightThigh]);
    const int arms = meeting(map_[Bone::kLeftUpperArm], map_[Bone::kRightUpperArm]);
    if (hips < 0 || arms < 0)
      throw std::invalid_argument(file_ + ": no joint carries both " +
                                  (hips < 0 ? "legs" : "arms") +
                                  ", all joints have to hang together");
    assign(Bone::kHips, hips);
    map_.spine = between(meeting(hips, arms), arms);
    if (!map_.spine.empty()) assign(Bone::kChest, map_.spine.back());
    if (map_.spine.size() > 1) assign(Bone::kSpine, map_.spine[(map_.spine.size() - 1) / 2]);
    mapHead(arms);
  }

  void mapHead(int arms) {
    int head = find({"head"}, ' ');
    if (head < 0 || !carries(arms, head)) head = lastOfMiddle(arms);
    if (head < 0) return;
    map_.neck = between(arms, head);
    map_.neck.pop_back();
    // A single joint above the arms without the name of a head is a neck.
    if (map_.neck.empty() && parsed_[size_t(head)].word != "head") {
      map_.neck.push_back(head);
    } else {
      assign(Bone::kHead, head);
    }
    if (!map_.neck.empty()) assign(Bone::kNeck, map_.neck[(map_.neck.size() - 1) / 2]);
  }

  /// The last joint of the chain of neck or spine joints above the arms; -1 if there is none.
  int lastOfMiddle(int arms) const {
    int last = -1;
    for (size_t j = 0; j < joints_.size(); ++j) {
      const std::string& word = parsed_[j].word;
      const int from = last < 0 ? arms : last;
      if (joints_[j].parent == from && (word == "neck" || word == "spine")) last = int(j);
    }
    return last;
  }

  /// The lowest common ancestor of two joints, or one of them; -1 if there is none.
  int meeting(int a, int b) const {
    while (a != b && a >= 0 && b >= 0) {
      int& deeper = depth_[size_t(a)] >= depth_[size_t(b)] ? a : b;
      deeper = joints_[size_t(deeper)].parent;
    }
    return a == b ? a : -1;
  }

  bool carries(int above, int joint) const { return meeting(above, joint) == above; }

  /// Joints from the child of `from` down to `to`.
  std::vector<int> between(int from, int to) const {
    std::vector<int> path;
    for (; to != from; to = joints_[size_t(to)].parent) path.push_back(to);
    std::reverse(path.begin(), path.end());
    return path;
  }

  const std::vector<NamedJoint>& joints_;
  const std::string& file_;
  std::vector<JointName> parsed_;
  std::vector<int> depth_;
  std::vector<bool> taken_;
  BoneMap map_;
};

}  // namespace

BoneMap mapBones(const std::vector<NamedJoint>& joints, const std::string& file) {
  return Mapper(joints, file).map();
}

}  // namespace markerless_mocap
