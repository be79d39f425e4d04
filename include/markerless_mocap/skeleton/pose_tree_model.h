#pragma once

#include <memory>
#include <string>

namespace markerless_mocap {

struct ExtremityLabelModel;
struct ValidityModel;

/// The text of a model file.
struct ModelText {
  std::string yaml;
  std::string where;  ///< name for error messages, for example "models/pose_tree_validity.yaml"
};

/// The learned models of the pose tree: the labels of the extremities, and the probability that a
/// labelling is correct. Immutable; copies share the data.
class PoseTreeModel {
 public:
  /// The models of models/pose_tree_extremities.yaml and models/pose_tree_validity.yaml, which are
  /// built into the library and parsed at the first call.
  static const PoseTreeModel& standard();
  /// \param extremities, validity in the format that scripts/fit_pose_tree writes
  /// Throws std::invalid_argument with a message that names the file, the key and the expected
  /// value: if a text is no YAML map, a key is missing, unknown or repeated, a number is not
  /// finite, there are fewer than two knots, or a range does not ascend.
  static PoseTreeModel fromYaml(const ModelText& extremities, const ModelText& validity);

  const ExtremityLabelModel& extremities() const { return *extremities_; }
  const ValidityModel& validity() const { return *validity_; }

 private:
  PoseTreeModel() = default;

  std::shared_ptr<const ExtremityLabelModel> extremities_;
  std::shared_ptr<const ValidityModel> validity_;
};

}  // namespace markerless_mocap
