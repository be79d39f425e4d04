#include "studies/label_samples/label_sampler.h"

#include <algorithm>
#include <map>
#include <utility>

#include "evaluation/label_error.h"
#include "markerless_mocap/skeleton/pose_tree_builder.h"
#include "skeleton/label_template.h"
#include "skeleton/labelling.h"
#include "skeleton/plausibility_checks.h"
#include "skeleton/thinner.h"
#include "studies/label_samples/limb_shares.h"
#include "tools/common/tree_labels.h"

namespace markerless_mocap {
namespace {

constexpr double kReach = 0.15, kHeadReach = 0.25;  // metres; the same tolerances as in the
                                                    // evaluation of labels

/// The true extremities near an end of the skeleton, by its own position or by the point where it
/// leaves the hull.
int trueEndsAt(const ExtremityCandidate& end, const Eigen::Matrix3Xd& truth) {
  int ends = 0;
  for (const Eigen::Vector3d& p :
       {end.position, Eigen::Vector3d(end.position + end.extent * end.direction)})
    for (int i = 0; i < kLabelledExtremityCount; ++i)
      if ((truth.middleCols<2>(2 * i).colwise() - p).colwise().norm().minCoeff() <
          (i == 0 ? kHeadReach : kReach))
        ends |= 1 << i;
  return ends;
}

void writeEnds(const TreeGraph& graph, const TreeVolume& volume, const Eigen::Matrix3Xd& truth,
               bool limb_cut, std::ostream& out) {
  if (graph.size() < 2) {
    out << "frame 0 0 0 0 " << limb_cut << '\n';
    return;
  }
  const ExtremityCandidates ends = extremityCandidates(graph, volume);
  const auto [low, high] = std::minmax_element(
      graph.positions.begin(), graph.positions.end(),
      [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.z() < b.z(); });
  out << "frame " << ends.extremities.size() << ' ' << ends.longest << ' ' << low->z() << ' '
      << high->z() << ' ' << limb_cut << '\n';
  for (const ExtremityCandidate& end : ends.extremities)
    out << "end " << end.position.transpose() << ' ' << end.direction.transpose() << ' '
        << end.extent << ' ' << end.end_radius << ' ' << end.limb_radius << ' ' << end.branch << ' '
        << end.cut << ' ' << trueEndsAt(end, truth) << '\n';
  for (const auto& [name, ways] :
       {std::make_pair("tree_path_lengths", &ends.tree_path_lengths),
        std::make_pair("shortest_path_lengths", &ends.shortest_path_lengths)}) {
    out << name;
    for (const double way : *ways) out << ' ' << way;
    out << '\n';
  }
}

}  // namespace

/// A published labelling.
struct LabelSampleWriter::Ranking {
  explicit Ranking(const BakkenVariant& variant)
      : id(variant.id), options(optionsOf(variant, publishedBakkenYaml())), builder(options) {}
  std::string id;
  PoseTreeOptions options;
  PoseTreeBuilder builder;
};

std::vector<BakkenVariant> rankedVariants() {
  std::vector<BakkenVariant> ranked{
      {"defaults", "ranking, all else as the defaults", {{"labelling", "ranking"}}, true}};
  for (const BakkenVariant& variant : bakkenVariants())
    if (variant.id == "published" || variant.id == "prune08" || variant.id == "paths08")
      ranked.push_back(variant);
  for (BakkenVariant& variant : ranked) variant.changes.emplace_back("follow_labels", "false");
  return ranked;
}

LabelSampleWriter::LabelSampleWriter(std::vector<std::string> names, std::ostream* out)
    : names_(std::move(names)),
      thinner_(std::make_unique<Thinner>(PoseTreeOptions().persistence)),
      out_(*out) {
  for (const BakkenVariant& variant : rankedVariants()) rankings_.emplace_back(variant);
  out_ << "validity_features";
  for (int i = 0; i < kValidityFeatureCount; ++i) out_ << ' ' << toString(ValidityFeature(i));
  out_ << '\n';
}
LabelSampleWriter::~LabelSampleWriter() = default;

void LabelSampleWriter::add(const VisualHull& hull, const std::vector<Eigen::Vector3d>& points,
                            bool limb_cut) {
  JointTrack truth;
  truth.names = names_;
  truth.add(
      0, Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, Eigen::Index(points.size())));
  const JointTrack all = truth;
  truth = truth.select(labelTruthNames());
  PoseTreeOptions options;
  options.min_validity = 0.0;
  const bool nobody = rejectHull(hull).has_value();
  Labelling labelling(options, PoseTreeModel::standard(), hull,
                      nobody ? CurveSkeleton() : thinner_->thin(hull));
  PreviousExtremities ends;
  const PoseTree tree = labelling.run({}, &ends);
  writeEnds(labelling.graph(), labelling.volume(), truth.positions.front(), limb_cut, out_);
  const LabelEvaluation verdict = labelErrors(truth, {labelsOf(tree)}).verdicts.front();
  out_ << "label " << toString(tree.status) << ' ' << verdict.kinds_correct << ' '
       << verdict.sides_correct << ' ' << verdict.right;
  if (labelling.features())
    for (const double feature : *labelling.features()) out_ << ' ' << feature;
  out_ << '\n';
  if (verdict.right && tree.valid() && !limb_cut) {
    out_ << "shares";
    for (const auto& [name, share] : limbShares(labelling, tree, all))
      out_ << ' ' << name << ' ' << share;
    out_ << '\n';
  }
  writeRankings(hull, truth);
}

void LabelSampleWriter::writeRankings(const VisualHull& hull, const JointTrack& truth) {
  std::map<double, CurveSkeleton> skeletons;  // by persistence
  for (Ranking& ranking : rankings_) {
    const double persistence = ranking.options.persistence;
    if (!skeletons.count(persistence)) skeletons[persistence] = Thinner(persistence).thin(hull);
    const PoseTree tree = ranking.builder.build(hull, skeletons[persistence]);
    const LabelEvaluation verdict = labelErrors(truth, {labelsOf(tree)}).verdicts.front();
    out_ << "ranking " << ranking.id << ' ' << verdict.kinds_correct << ' ' << verdict.right
         << '\n';
  }
}

}  // namespace markerless_mocap
