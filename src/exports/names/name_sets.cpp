#include "exports/names/name_sets.h"

namespace markerless_mocap {
namespace {

using Points = std::vector<NamedPoint>;

/// Both sides of a row, first the one of `first`.
void addSides(const std::string& left, const std::string& right, const std::string& point,
              bool left_first, Points* points) {
  const NamedPoint l{left, "l_" + point, "", 0.0}, r{right, "r_" + point, "", 0.0};
  points->push_back(left_first ? l : r);
  points->push_back(left_first ? r : l);
}

Points package() {
  Points points;
  for (const char* name :
       {"pelvis",     "waist",      "torso",   "thorax",    "head",       "head_top",
        "l_clavicle", "l_shoulder", "l_elbow", "l_wrist",   "l_hand",     "l_hand_tip",
        "r_clavicle", "r_shoulder", "r_elbow", "r_wrist",   "r_hand",     "r_hand_tip",
        "l_hip",      "l_knee",     "l_ankle", "l_foot",    "l_foot_tip", "r_hip",
        "r_knee",     "r_ankle",    "r_foot",  "r_foot_tip"})
    points.push_back({name, name, "", 0.0});
  return points;
}

Points motionbuilder() {
  Points points{{"Hips", "pelvis", "", 0},
                {"Spine", "waist", "", 0},
                {"Spine1", "torso", "", 0},
                {"Neck", "thorax", "", 0},
                {"Head", "head", "", 0}};
  for (const auto& [name, point] : {std::pair{"Shoulder", "clavicle"},
                                    {"Arm", "shoulder"},
                                    {"ForeArm", "elbow"},
                                    {"Hand", "wrist"},
                                    {"UpLeg", "hip"},
                                    {"Leg", "knee"},
                                    {"Foot", "ankle"},
                                    {"ToeBase", "foot"}})
    addSides(std::string("Left") + name, std::string("Right") + name, point, true, &points);
  return points;
}

/// Joints of the model of Rajagopal et al. 2016.
Points opensim() {
  Points points{{"ground_pelvis", "pelvis", "", 0},
                {"back", "waist", "", 0},
                {"neck", "thorax", "", 0},
                {"head", "head", "", 0}};
  for (const auto& [name, point] : {std::pair{"hip", "hip"},
                                    {"walker_knee", "knee"},
                                    {"ankle", "ankle"},
                                    {"mtp", "foot"},
                                    {"acromial", "shoulder"},
                                    {"elbow", "elbow"},
                                    {"radius_hand", "wrist"}})
    addSides(std::string(name) + "_l", std::string(name) + "_r", point, false, &points);
  return points;
}

/// The 17 joints of Human3.6M in the usual order (Martinez et al. 2017).
Points h36m() {
  Points points{{"Hip", "pelvis", "", 0}};
  for (const std::string side : {"R", "L"})
    for (const auto& [name, point] : {std::pair{"Hip", "hip"}, {"Knee", "knee"}, {"Foot", "ankle"}})
      points.push_back({side + name, (side == "R" ? "r_" : "l_") + std::string(point), "", 0});
  points.push_back({"Spine", "pelvis", "torso", 0.5});
  points.push_back({"Thorax", "torso", "", 0});
  points.push_back({"Neck/Nose", "head", "", 0});
  points.push_back({"Head", "head_top", "", 0});
  for (const std::string side : {"L", "R"})
    for (const auto& [name, point] :
         {std::pair{"Shoulder", "shoulder"}, {"Elbow", "elbow"}, {"Wrist", "wrist"}})
      points.push_back({side + name, (side == "R" ? "r_" : "l_") + std::string(point), "", 0});
  return points;
}

/// The 24 joints of SMPL (Loper et al. 2015). The body's trunk has one joint: spine2 and spine3 are
/// on the line from it to the shoulders.
Points smpl() {
  Points points{{"pelvis", "pelvis", "", 0}};
  addSides("left_hip", "right_hip", "hip", true, &points);
  points.push_back({"spine1", "waist", "", 0});
  addSides("left_knee", "right_knee", "knee", true, &points);
  points.push_back({"spine2", "waist", "torso", 0.35});
  addSides("left_ankle", "right_ankle", "ankle", true, &points);
  points.push_back({"spine3", "waist", "torso", 0.5});
  addSides("left_foot", "right_foot", "foot", true, &points);
  points.push_back({"neck", "thorax", "", 0});
  addSides("left_collar", "right_collar", "clavicle", true, &points);
  points.push_back({"head", "head", "", 0});
  for (const char* point : {"shoulder", "elbow", "wrist", "hand"})
    addSides(std::string("left_") + point, std::string("right_") + point, point, true, &points);
  return points;
}

/// The 17 keypoints of COCO. The body has no face.
Points coco() {
  Points points;
  for (const char* name : {"nose", "left_eye", "right_eye", "left_ear", "right_ear"})
    points.push_back({name, "", "", 0});
  for (const char* point : {"shoulder", "elbow", "wrist", "hip", "knee", "ankle"})
    addSides(std::string("left_") + point, std::string("right_") + point, point, true, &points);
  return points;
}

}  // namespace

const std::vector<NameSet>& allNameSets() {
  static const std::vector<NameSet> sets{{"package", package()}, {"motionbuilder", motionbuilder()},
                                         {"opensim", opensim()}, {"h36m", h36m()},
                                         {"smpl", smpl()},       {"coco", coco()}};
  return sets;
}

}  // namespace markerless_mocap
