#include "studies/reproduce/bakken/bakken_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "evaluation/label_error.h"
#include "markerless_mocap/skeleton/pose_tree_builder.h"
#include "skeleton/thinner.h"
#include "studies/reproduce/bakken/bakken_film.h"
#include "tools/common/tree_labels.h"

namespace markerless_mocap {
namespace {

using Clock = std::chrono::steady_clock;

double tenths(double value) {
  return std::round(value * 10.0) / 10.0;
}

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Length of the part of an extremity, and of the whole path from it to the root, metres.
struct Lengths {
  double own = 0.0, to_root = 0.0;
};

Lengths lengthsFrom(const PoseTree& tree, Extremity extremity) {
  Lengths lengths;
  int32_t node = tree.extremity(extremity).node;
  const TreePart part = tree.nodes[size_t(node)].part;
  bool own = true;
  for (int32_t up; (up = tree.nodes[size_t(node)].parent) >= 0; node = up) {
    own = own && tree.nodes[size_t(up)].part == part;
    const double step =
        (tree.nodes[size_t(up)].position - tree.nodes[size_t(node)].position).norm();
    lengths.to_root += step;
    if (own) lengths.own += step;
  }
  return lengths;
}

/// Fractions of the longest path from a hand to a foot: the shorter arm, and the neck.
void addShares(const PoseTree& tree, Json* result) {
  const Lengths arms[] = {lengthsFrom(tree, Extremity::kLeftHand),
                          lengthsFrom(tree, Extremity::kRightHand)};
  double leg = 0.0, neck = 1e9, arm = 0.0;
  for (const Extremity foot : {Extremity::kLeftFoot, Extremity::kRightFoot})
    leg = std::max(leg, lengthsFrom(tree, foot).to_root);
  for (const Lengths& one : arms) {
    neck = std::min(neck, one.to_root - one.own);
    arm = std::max(arm, one.own);
  }
  const double longest = arm + leg - neck;
  (*result)["arm"].push_back(std::round(1e3 * std::min(arms[0].own, arms[1].own) / longest) / 1e3);
  (*result)["neck"].push_back(std::round(1e3 * neck / longest) / 1e3);
}

/// One variant over a capture.
class Labeller {
 public:
  explicit Labeller(const BakkenVariant& variant)
      : id(variant.id), options_(optionsOf(variant, publishedBakkenYaml())), builder_(options_) {
    for (const char* key : {"right", "correct", "valid", "rank", "arm", "neck"})
      result[key] = Json::array();
  }

  void add(const VisualHull& hull, std::map<double, CurveSkeleton>* skeletons,
           const JointTrack& truth) {
    auto skeleton = skeletons->find(options_.persistence);
    if (skeleton == skeletons->end())
      skeleton =
          skeletons->emplace(options_.persistence, Thinner(options_.persistence).thin(hull)).first;
    const PoseTree tree = builder_.build(hull, skeleton->second);
    const LabelEvaluation verdict = labelErrors(truth, {labelsOf(tree)}).verdicts.front();
    const bool right = verdict.right && tree.valid();
    result["right"].push_back(int(right));
    result["correct"].push_back(int(verdict.right));
    result["valid"].push_back(int(tree.valid()));
    result["rank"].push_back(tree.rank);
    for (size_t i = 0; i < kLabelledExtremityCount; ++i)
      result[extremityNames()[i]].push_back(tree.valid() ? tenths(verdict.error_mm[i]) : NAN);
    if (right) addShares(tree, &result);
  }

  std::string id;
  Json result = Json::object();

 private:
  PoseTreeOptions options_;
  PoseTreeBuilder builder_;
};

bool contains(const HullOptions& cube, const Eigen::Matrix3Xd& points) {
  return (points.rowwise().minCoeff().array() >= cube.volume_min.array()).all() &&
         (points.rowwise().maxCoeff().array() <= cube.volume_max.array()).all();
}

/// Whether the thinned hull's top-most voxel may be a hand's.
bool handAboveHead(const JointTrack& truth, size_t frame) {
  const auto height = [&](const char* name) {
    return truth.positions[frame](2, truth.indexOf(name));
  };
  return std::max(height("l_hand"), height("r_hand")) > height("head");
}

}  // namespace

Json labelCapture(const Capture& capture, int edge, Volume volume) {
  const JointTrack truth = labelTruth(capture);
  const CameraRig rig = rigOf(capture);
  HullOptions cube = cubeAround(truth, publishedBakkenOptions(edge).hull);
  if (volume == Volume::kStudio) {
    cube.volume_min = {-2.0, -2.0, 0.0};
    cube.volume_max = {2.0, 2.0, 2.5};
  }
  cube.min_views = std::min(cube.min_views, int(rig.size()));
  HullCarver carver(rig, cube);
  std::vector<Labeller> labellers;
  for (const BakkenVariant& variant : bakkenVariants()) labellers.emplace_back(variant);
  Json result{{"seconds", Json::array()}, {"raised", Json::array()}};
  forEachFrame(capture, truth, [&](size_t frame, const std::vector<HullView>& views) {
    if (!contains(cube, truth.positions[frame])) return;
    result["seconds"].push_back(1e-9 * double(truth.stamps_ns[frame] - truth.stamps_ns[0]));
    result["raised"].push_back(int(handAboveHead(truth, frame)));
    const VisualHull hull = carver.carve(views);
    std::map<double, CurveSkeleton> skeletons;
    for (Labeller& labeller : labellers) labeller.add(hull, &skeletons, frameOf(truth, frame));
  });
  for (Labeller& labeller : labellers) result[labeller.id] = std::move(labeller.result);
  return result;
}

Json timeCapture(const Capture& capture, int edge) {
  const JointTrack truth = labelTruth(capture);
  HullCarver carver(rigOf(capture), cubeAround(truth, publishedBakkenOptions(edge).hull));
  const PoseTreeOptions options = optionsOf(bakkenVariants().front(), publishedBakkenYaml());
  Thinner thinner(options.persistence);
  PoseTreeBuilder builder(options);
  Json result{{"hull", Json::array()}, {"thinning", Json::array()}, {"tree", Json::array()}};
  const auto timed = [&](const char* stage, const auto& work) {
    const Clock::time_point start = Clock::now();
    auto product = work();
    result[stage].push_back(millisecondsSince(start));
    return product;
  };
  forEachFrame(capture, truth, [&](size_t, const std::vector<HullView>& views) {
    const VisualHull hull = timed("hull", [&] { return carver.carve(views); });
    const CurveSkeleton skeleton = timed("thinning", [&] { return thinner.thin(hull); });
    timed("tree", [&] { return builder.build(hull, skeleton); });
  });
  return result;
}

}  // namespace markerless_mocap
