#pragma once

#include <Eigen/Core>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

class Thinner;

/// Writes what the pose tree's models of ends and of validity are fitted to: one hull after another
/// with what is true of it. scripts/fit_pose_tree reads it. Lines of words:
///   validity_features <their names>, once at the beginning
///   frame <number of ends> <longest way> <lowest z> <highest z> <1: with a limb cut off>
///   end <x y z> <direction x y z> <extent> <tip radius> <limb radius> <branch> <cut> <what it is>
///   tree_path_lengths, shortest_path_lengths <a number for each pair of ends>
///   label <status> <kinds right> <sides right> <all right> [<ValidityFeatures>]
/// Metres; what an end is: the sum of 1 << i over the true ends i (extremityNames()) within reach.
class LabelSampleWriter {
 public:
  /// \param names of the true points, labelTruthNames() among them
  LabelSampleWriter(std::vector<std::string> names, std::ostream* out);
  ~LabelSampleWriter();

  /// \param points by the names, world metres \param limb_cut see withLimbCut()
  void add(const VisualHull& hull, const std::vector<Eigen::Vector3d>& points, bool limb_cut);

 private:
  std::vector<std::string> names_;
  std::unique_ptr<Thinner> thinner_;
  std::ostream& out_;
};

}  // namespace markerless_mocap
