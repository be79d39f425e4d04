#pragma once

#include <memory>
#include <string>

namespace markerless_mocap {

struct ExtremityLabelModel;
struct ValidityModel;

/// The text of a model file.
struct ModelText {
  std::string yaml;
  std::string where;  ///< what errors call it, say "models/pose_tree_validity.yaml"
};

/// The learned numbers of the pose tree: how the ends of a skeleton are named, and how likely a
/// labelling is right. Never changes; copies share the numbers.
class PoseTreeModel {
 public:
  /// models/pose_tree_extremities.yaml and models/pose_tree_validity.yaml, built into the library
  /// and read at the first call.
  static const PoseTreeModel& standard();
  /// \param extremities, validity as scripts/fit_pose_tree writes them
  /// Throws std::invalid_argument in one sentence that names the file, the key and what is
  /// expected: no YAML map, a key missing, unknown or doubled, a number that is not finite, fewer
  /// than two knots, a range that does not ascend.
  static PoseTreeModel fromYaml(const ModelText& extremities, const ModelText& validity);

  const ExtremityLabelModel& extremities() const { return *extremities_; }
  const ValidityModel& validity() const { return *validity_; }

 private:
  PoseTreeModel() = default;

  std::shared_ptr<const ExtremityLabelModel> extremities_;
  std::shared_ptr<const ValidityModel> validity_;
};

}  // namespace markerless_mocap
