#pragma once

#include <array>
#include <string>

#include "skeleton/labelling/piecewise_linear.h"
#include "skeleton/labelling/validity_features.h"

namespace markerless_mocap {

/// An additive model of the log-odds that a labelled tree is correct. It was fitted to other people
/// than ExtremityLabelModel.
struct ValidityModel {
  double intercept = 0.0;
  std::array<PiecewiseLinear, kValidityFeatureCount> curves;

  /// Probability that all labels and both sides are correct.
  double probability(const ValidityFeatures& features) const;
  /// Reads models/pose_tree_validity.yaml. Throws as PoseTreeModel::fromYaml().
  static ValidityModel fromYaml(const std::string& yaml, const std::string& where);
};

}  // namespace markerless_mocap
