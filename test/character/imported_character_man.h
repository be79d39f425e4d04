#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// A box about a joint and the place it leads to; world axes, metres.
struct Box {
  std::string name, parent;
  Eigen::Vector3d head, tail;
  double half_width;
  bool skin_colored = false;
  bool weighted = true;
};

/// A person of boxes, 1.8 m tall in a T-pose, standing on z = 0 and facing +x, and the file that
/// tells of it.
struct BoxMan {
  std::vector<Box> boxes;
  /// From world axes in metres to the file's axes and unit.
  Eigen::Matrix4d T_file_world = Eigen::Matrix4d::Identity();
  /// The root node's, from the axes that mesh and joints are told in to the scene's.
  Eigen::Matrix4d root = Eigen::Matrix4d::Identity();
  Eigen::Vector3f skin_color{0.9f, 0.7f, 0.6f}, cloth_color{0.1f, 0.2f, 0.7f};
  std::string cloth_texture;   ///< file name, "*0" for the embedded one
  std::string embedded_image;  ///< bytes of a PNG
  std::vector<Box> loose;      ///< without bones, on the node `parent`, in mirrored axes
  bool has_bones = true;
  bool inside_out = false;    ///< all triangles
  bool bind_is_lost = false;  ///< vertices told in their bone's axes, bind matrices identity
};

inline Eigen::Vector3d mirroredY(const Eigen::Vector3d& p) {
  return {p.x(), -p.y(), p.z()};
}

/// \param arms below the horizontal, radians \param sided makes a name of (bone, 'l' or 'r')
inline BoxMan boxMan(double arms, const std::function<std::string(const char*, char)>& sided,
                     bool complete) {
  BoxMan man;
  const auto add = [&](const std::string& name, const std::string& parent,
                       const Eigen::Vector3d& head, const Eigen::Vector3d& tail, double width,
                       bool skin = false) {
    man.boxes.push_back({name, parent, head, tail, width, skin});
  };
  const auto middle = [&](const char* bone) { return sided(bone, ' '); };
  add(middle("Hips"), "", {0, 0, 0.95}, {0, 0, 1.06}, 0.14);
  add(middle("Spine"), middle("Hips"), {0, 0, 1.06}, {0, 0, 1.22}, 0.12);
  std::string chest = middle("Spine");
  if (complete) {
    chest = middle("Spine1");
    add(chest, middle("Spine"), {0, 0, 1.22}, {0, 0, 1.50}, 0.14);
    add(middle("Neck"), chest, {0, 0, 1.50}, {0, 0, 1.60}, 0.05, true);
    add(middle("Head"), middle("Neck"), {0, 0, 1.60}, {0, 0, 1.80}, 0.08, true);
  } else {
    man.boxes.back().tail.z() = 1.80;
  }
  const Eigen::Vector3d along(0, std::cos(arms), -std::sin(arms));
  for (char side : {'l', 'r'}) {
    const auto limb = [&](const char* name, const std::string& parent, const Eigen::Vector3d& head,
                          const Eigen::Vector3d& tail, double width, bool skin = false) {
      const bool left = side == 'l';
      add(sided(name, side), parent, left ? head : mirroredY(head), left ? tail : mirroredY(tail),
          width, skin);
      return man.boxes.back().name;
    };
    const Eigen::Vector3d shoulder(0, 0.18, 1.45), elbow = shoulder + 0.30 * along,
                                                   wrist = elbow + 0.25 * along;
    std::string parent = chest;
    if (complete) parent = limb("Shoulder", chest, {0, 0.03, 1.45}, shoulder, 0.05);
    parent = limb("Arm", parent, shoulder, elbow, 0.05);
    parent = limb("ForeArm", parent, elbow, complete ? wrist : wrist + 0.19 * along, 0.04);
    if (complete) {
      parent = limb("Hand", parent, wrist, wrist + 0.10 * along, 0.04, true);
      limb("HandMiddle1", parent, wrist + 0.10 * along, wrist + 0.19 * along, 0.03, true);
    }
    // Feet apart and turned out.
    const Eigen::Vector3d hip(0, 0.10, 0.92), knee(0, 0.15, 0.50), ankle(0, 0.20, 0.08),
        toe(0.14, 0.26, 0.03), tip(0.21, 0.29, 0.03);
    parent = limb("UpLeg", middle("Hips"), hip, knee, 0.07);
    parent = limb("Leg", parent, knee, ankle, 0.05);
    parent = limb("Foot", parent, ankle, complete ? toe : tip, 0.03);
    if (complete) limb("ToeBase", parent, toe, tip, 0.03);
  }
  return man;
}

/// Mixamo's names, y up, facing z, centimetres, arms 45 degrees down.
inline BoxMan mixamoMan() {
  BoxMan man = boxMan(
      M_PI / 4,
      [](const char* bone, char side) {
        return std::string("mixamorig:") +
               (side == 'l'   ? "Left"
                : side == 'r' ? "Right"
                              : "") +
               bone;
      },
      true);
  man.T_file_world.topLeftCorner<3, 3>() << 0, 100, 0, 0, 0, 100, 100, 0, 0;
  return man;
}

/// Blender's names, z up, facing -y, arms straight out; without chest, neck, head, collar bones,
/// hands and toes.
inline BoxMan plainMan() {
  BoxMan man = boxMan(
      0.0,
      [](const char* bone, char side) {
        const std::vector<std::pair<std::string, std::string>> words{
            {"UpLeg", "thigh"}, {"Leg", "shin"},        {"Foot", "foot"},  {"Arm", "upper_arm"},
            {"Hips", "hips"},   {"ForeArm", "forearm"}, {"Spine", "spine"}};
        const auto word = std::find_if(words.begin(), words.end(),
                                       [&](const auto& pair) { return pair.first == bone; });
        return word->second + (side == 'l' ? ".L" : side == 'r' ? ".R" : "");
      },
      false);
  man.T_file_world.topLeftCorner<3, 3>() << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  return man;
}

}  // namespace markerless_mocap
