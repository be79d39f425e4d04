#include "studies/common/bakken_variants.h"

#include <yaml-cpp/yaml.h>

#include <stdexcept>

#include "markerless_mocap/pipeline/pipeline.h"
#include "ros/package_files.h"

namespace markerless_mocap {

const std::vector<BakkenVariant>& bakkenVariants() {
  static const std::vector<BakkenVariant> kVariants = {
      {"published", "as published"},
      {"prune20", "pruned below 0.20 of the longest path", {{"prune_ratio", "0.20"}}},
      {"prune16", "pruned below 0.16", {{"prune_ratio", "0.16"}}},
      {"prune12", "pruned below 0.12", {{"prune_ratio", "0.12"}}},
      {"prune08", "pruned below 0.08", {{"prune_ratio", "0.08"}}},
      {"prune05", "pruned below 0.05", {{"prune_ratio", "0.05"}}},
      {"printed08", "0.08, Eq. 2 as printed", {{"prune_ratio", "0.08"}, {"leg_rank", "printed"}}},
      {"alone08",
       "0.08, frames labelled independently",
       {{"prune_ratio", "0.08"}, {"follow_labels", "false"}}},
      {"paths08",
       "0.08, smoothed shortest paths",
       {{"prune_ratio", "0.08"}, {"tree_paths", "shortest"}, {"smoothing", "0.03"}}},
      {"surface08",
       "0.08, extremities before the surface",
       {{"prune_ratio", "0.08"}, {"extremities", "surface"}}},
      {"learned", "learned labelling (default)", {}, true},
      {"learned_leaf",
       "learned labelling, extremities at the leaves",
       {{"extremities", "leaf"}},
       true},
  };
  return kVariants;
}

const BakkenVariant& bakkenVariant(const std::string& id) {
  for (const BakkenVariant& one : bakkenVariants())
    if (one.id == id) return one;
  throw std::invalid_argument("there is no variant " + id);
}

std::string publishedBakkenYaml() {
  return readText(packageFile("config/as_published/bakken.yaml"));
}

PoseTreeOptions optionsOf(const BakkenVariant& variant, const std::string& published) {
  YAML::Node root;
  if (!variant.product) root = YAML::Load(published);
  for (const auto& [key, value] : variant.changes) root["pose_tree"][key] = value;
  return loadPipelineOptions(root).pose_tree;
}

}  // namespace markerless_mocap
