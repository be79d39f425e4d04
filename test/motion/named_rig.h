#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "motion/bone_names.h"

namespace markerless_mocap {

/// A rig from lines "name parent", "-" for none; "~" in a name is a blank.
inline std::vector<NamedJoint> rig(const std::string& lines) {
  std::vector<NamedJoint> joints;
  std::map<std::string, int> index{{"-", -1}};
  std::istringstream text(lines);
  for (std::string name, parent; text >> name >> parent;) {
    index[name] = int(joints.size());
    NamedJoint joint{name, index.at(parent)};
    std::replace(joint.name.begin(), joint.name.end(), '~', ' ');
    joints.push_back(joint);
  }
  return joints;
}

/// A piece of a rig for both sides: "<" becomes the first word, then the second.
inline std::string bothSides(const std::string& lines, const std::string& left,
                             const std::string& right) {
  std::string both;
  for (const std::string& side : {left, right})
    for (char c : lines) both += c == '<' ? side : std::string(1, c);
  return both;
}

class Mapped {
 public:
  explicit Mapped(std::vector<NamedJoint> joints)
      : joints_(std::move(joints)), map_(mapBones(joints_, "rig.bvh")) {}

  std::string name(int joint) const { return joint < 0 ? "" : joints_[size_t(joint)].name; }
  std::string operator[](Bone bone) const { return name(map_[bone]); }
  std::string names(const std::vector<int>& chain) const {
    std::string all;
    for (int joint : chain) all += (all.empty() ? "" : " ") + name(joint);
    return all;
  }
  std::string spine() const { return names(map_.spine); }
  std::string neck() const { return names(map_.neck); }

  /// \param limbs clavicle, upper arm, forearm, hand, thigh, shank, foot, toes with "<" for the
  /// side and "-" for a bone that is missing
  void expectLimbs(const std::string& limbs, const std::string& left,
                   const std::string& right) const {
    std::istringstream words(limbs);
    std::string word;
    for (int b = int(Bone::kLeftClavicle); b <= int(Bone::kLeftToes); ++b) {
      words >> word;
      for (const auto& [bone, side] :
           {std::make_pair(Bone(b), left), std::make_pair(mirrorOf(Bone(b)), right)}) {
        std::string wanted = word == "-" ? "" : word;
        const size_t mark = wanted.find('<');
        if (mark != std::string::npos) wanted.replace(mark, 1, side);
        std::replace(wanted.begin(), wanted.end(), '~', ' ');
        EXPECT_EQ((*this)[bone], wanted) << boneName(bone);
      }
    }
  }
  void expectTrunk(const std::string& hips, const std::string& spine, const std::string& neck,
                   const std::string& head) const {
    EXPECT_EQ((*this)[Bone::kHips], hips);
    EXPECT_EQ(this->spine(), spine);
    EXPECT_EQ(this->neck(), neck);
    EXPECT_EQ((*this)[Bone::kHead], head);
  }

 private:
  std::vector<NamedJoint> joints_;
  BoneMap map_;
};

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace markerless_mocap
