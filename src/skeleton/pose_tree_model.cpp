#include "markerless_mocap/skeleton/pose_tree_model.h"

#include "resources/resources.h"
#include "skeleton/labelling/extremity_label_model.h"
#include "skeleton/labelling/validity_model.h"

namespace markerless_mocap {

PoseTreeModel PoseTreeModel::fromYaml(const ModelText& extremities, const ModelText& validity) {
  PoseTreeModel model;
  model.extremities_ = std::make_shared<const ExtremityLabelModel>(
      ExtremityLabelModel::fromYaml(extremities.yaml, extremities.where));
  model.validity_ =
      std::make_shared<const ValidityModel>(ValidityModel::fromYaml(validity.yaml, validity.where));
  return model;
}

const PoseTreeModel& PoseTreeModel::standard() {
  static const PoseTreeModel model =
      fromYaml({poseTreeExtremitiesYaml(), "models/pose_tree_extremities.yaml"},
               {poseTreeValidityYaml(), "models/pose_tree_validity.yaml"});
  return model;
}

}  // namespace markerless_mocap
