#pragma once

#include <Eigen/Core>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "evaluation/joint_track.h"
#include "markerless_mocap/products/visual_hull.h"
#include "studies/common/bakken_variants.h"

namespace markerless_mocap {

class Thinner;

/// Published labellings with which the learned one is compared: the ranking alone, as published,
/// pruned less, and with smoothed shortest paths, too. Each frame is labelled by itself.
std::vector<BakkenVariant> rankedVariants();

/// Writes training samples for the models of the pose tree: hulls with their ground truth.
/// scripts/fit_pose_tree reads them. Lines of words:
///   validity_features <their names>, once at the beginning
///   frame <number of ends> <longest path> <minimum z> <maximum z> <1: with a limb cut off>
///   end <x y z> <direction x y z> <extent> <tip radius> <limb radius> <branch> <cut> <true ends>
///   tree_path_lengths, shortest_path_lengths <a number for each pair of ends>
///   label <status> <kinds correct> <sides correct> <all correct> [<features by ValidityFeature>]
///   shares <names and values of limbShares()>, of what is labelled right without a limb cut off
///   ranking <id of a variant> <kinds correct> <all correct>, for each of rankedVariants()
/// Metres. <true ends> is the sum of 1 << i over the true extremities i (extremityNames()) that are
/// near the end.
class LabelSampleWriter {
 public:
  /// \param names of the true points; they contain labelTruthNames()
  LabelSampleWriter(std::vector<std::string> names, std::ostream* out);
  ~LabelSampleWriter();

  /// \param points one per name, in the world, metres \param limb_cut see withLimbCut()
  void add(const VisualHull& hull, const std::vector<Eigen::Vector3d>& points, bool limb_cut);

 private:
  struct Ranking;
  void writeRankings(const VisualHull& hull, const JointTrack& truth);

  std::vector<std::string> names_;
  std::unique_ptr<Thinner> thinner_;
  std::vector<Ranking> rankings_;
  std::ostream& out_;
};

}  // namespace markerless_mocap
