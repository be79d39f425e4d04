#include "skeleton/labelling/extremity_label_model.h"

#include <iterator>

#include "files/yaml_text.h"
#include "skeleton/labelling/model_curves.h"

namespace markerless_mocap {

const char* toString(ExtremityFeature feature) {
  constexpr const char* kNames[] = {"end_up",     "end_down",       "end_direction",
                                    "end_extent", "end_tip_radius", "end_limb_radius",
                                    "end_branch", "end_cut",        "end_reach"};
  static_assert(std::size(kNames) == kExtremityFeatureCount);
  return kNames[feature];
}

const char* toString(BodyFeature feature) {
  constexpr const char* kNames[] = {"head_hand_path",   "head_hand_tree_path",
                                    "hand_hand_path",   "hand_hand_tree_path",
                                    "hand_foot_path",   "hand_foot_tree_path",
                                    "foot_foot_path",   "foot_foot_tree_path",
                                    "head_feet_metres", "feet_unlike",
                                    "foot_foot_gap",    "hand_hand_gap",
                                    "neck_length",      "torso_length",
                                    "hands_unlike",     "head_up",
                                    "foot_up",          "feet_unevenness",
                                    "hand_up",          "head_tip_radius",
                                    "head_limb_radius", "hand_tip_radius",
                                    "hand_limb_radius", "foot_tip_radius",
                                    "foot_limb_radius", "head_branch",
                                    "hand_branch",      "foot_branch",
                                    "head_cut",         "hand_cut",
                                    "foot_cut",         "head_extent",
                                    "hand_extent",      "foot_extent",
                                    "head_direction",   "hand_direction",
                                    "foot_direction",   "feet_together",
                                    "arm_path",         "arm_tree_path",
                                    "head_hand_gap",    "hand_foot_gap"};
  static_assert(std::size(kNames) == kBodyFeatureCount);
  return kNames[feature];
}

ExtremityLabelModel ExtremityLabelModel::fromYaml(const std::string& yaml,
                                                  const std::string& where) {
  constexpr const char* kRoles[] = {"head", "hand", "foot"};
  ExtremityLabelModel model;
  YamlMap file(yamlFrom(yaml, where), where);
  YamlMap extremities = file.map("extremities");
  for (size_t role = 0; role < std::size(kRoles); ++role) {
    YamlMap extremity = extremities.map(kRoles[role]);
    model.extremities[role].constant = extremity.number("constant");
    model.extremities[role].curves =
        curvesIn<ExtremityFeature, kExtremityFeatureCount>(extremity.map("curves"));
    extremity.finish();
  }
  extremities.finish();
  YamlMap body = file.map("body");
  model.no_body_log_odds = body.number("no_body_log_odds");
  model.body.curves = curvesIn<BodyFeature, kBodyFeatureCount>(body.map("curves"));
  body.finish();
  file.finish();
  return model;
}

}  // namespace markerless_mocap
