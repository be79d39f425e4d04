#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/skeleton/pose_tree_options.h"
#include "tools/common/studio_settings.h"

namespace markerless_mocap {

/// A way to label skeletons: the published one with changes, or the product's.
struct BakkenVariant {
  std::string id, name;
  Overrides changes = {};  ///< of the section pose_tree
  bool product = false;    ///< changes of the defaults in place of the published options
};
const std::vector<BakkenVariant>& bakkenVariants();
/// Throws std::invalid_argument if there is none with this id.
const BakkenVariant& bakkenVariant(const std::string& id);

/// Text of config/as_published/bakken.yaml.
std::string publishedBakkenYaml();

/// Options of a variant. Throws std::invalid_argument as loadPipelineOptions().
/// \param published publishedBakkenYaml()
PoseTreeOptions optionsOf(const BakkenVariant& variant, const std::string& published);

}  // namespace markerless_mocap
