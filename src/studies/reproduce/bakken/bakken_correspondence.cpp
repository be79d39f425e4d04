#include "studies/reproduce/bakken/bakken_correspondence.h"

#include <opencv2/imgproc.hpp>
#include <optional>

#include "evaluation/label_error.h"
#include "skeleton/labelling.h"
#include "skeleton/plausibility_checks.h"
#include "skeleton/thinner.h"
#include "studies/common/bakken_variants.h"
#include "studies/reproduce/bakken/bakken_film.h"
#include "studies/reproduce/bakken/bakken_pictures.h"
#include "tools/common/tree_labels.h"

namespace markerless_mocap {
namespace {

constexpr int kQuality = 85;
const TreeColors kFollowed = {{{150, 150, 150},
                               {0, 170, 220},
                               {60, 60, 60},
                               {220, 120, 0},
                               {0, 140, 255},
                               {150, 70, 0},
                               {0, 90, 170}}};  // first arm and leg blue, second orange

/// A frame that is labelled right.
struct Followed {
  size_t frame;
  PoseTree tree;
  cv::Mat picture;
  bool first_arm_is_left, first_leg_is_left;
};

/// Nodes coloured by the labels that follow the last frame, in place of the sides.
TreeColors colorsOf(const Followed& now) {
  TreeColors colors = kFollowed;
  if (!now.first_arm_is_left)
    std::swap(colors[size_t(TreePart::kLeftArm)], colors[size_t(TreePart::kRightArm)]);
  if (!now.first_leg_is_left)
    std::swap(colors[size_t(TreePart::kLeftLeg)], colors[size_t(TreePart::kRightLeg)]);
  return colors;
}

/// Whether the labelled extremity is the one that ended up as this one.
bool isAt(const PreviousExtremities& labelled, UnsidedExtremity end, const PoseTree& tree,
          Extremity extremity) {
  return (*labelled)[size_t(end)] == tree.extremity(extremity).skeleton_end;
}

JointTrack frameOf(const JointTrack& truth, size_t frame) {
  JointTrack one;
  one.names = truth.names;
  one.add(truth.stamps_ns[frame], truth.positions[frame]);
  return one;
}

/// The frames of a capture, one after another.
class Follower {
 public:
  explicit Follower(const PoseTreeOptions& options)
      : options_(options), model_(PoseTreeModel::standard()), thinner_(options.persistence) {}

  /// The frame, if it is labelled right.
  std::optional<Followed> add(size_t frame, const VisualHull& hull, const JointTrack& truth) {
    PreviousExtremities labelled;
    if (rejectHull(hull)) {
      last_.reset();
      return std::nullopt;
    }
    Followed now{frame,
                 Labelling(options_, model_, hull, thinner_.thin(hull)).run(last_, &labelled),
                 {},
                 false,
                 false};
    last_ = labelled;
    if (!now.tree.valid() || !labelErrors(truth, {labelsOf(now.tree)}).verdicts.front().right)
      return std::nullopt;
    now.first_arm_is_left =
        isAt(labelled, UnsidedExtremity::kHand1, now.tree, Extremity::kLeftHand);
    now.first_leg_is_left =
        isAt(labelled, UnsidedExtremity::kFoot1, now.tree, Extremity::kLeftFoot);
    return now;
  }

 private:
  PoseTreeOptions options_;
  PoseTreeModel model_;
  Thinner thinner_;
  PreviousExtremities last_;
};

const BakkenVariant& variant(const std::string& id) {
  for (const BakkenVariant& one : bakkenVariants())
    if (one.id == id) return one;
  throw std::invalid_argument("there is no variant " + id);
}

}  // namespace

Json followLabels(const Capture& capture, int edge) {
  const JointTrack truth = labelTruth(capture);
  const CameraRig rig = rigOf(capture);
  HullCarver carver(rig, cubeAround(truth, publishedBakkenOptions(edge).hull));
  Follower follower(optionsOf(variant("prune08"), publishedBakkenYaml()));
  std::optional<Followed> last;
  int pairs = 0, exchanged = 0;
  Json result;
  forEachFrame(capture, truth, [&](size_t frame, const std::vector<HullView>& views) {
    const VisualHull hull = carver.carve(views);
    std::optional<Followed> now = follower.add(frame, hull, frameOf(truth, frame));
    if (now) now->picture = drawTree(rig[0], hull, now->tree, colorsOf(*now));
    if (now && last && last->frame + 1 == frame) {
      ++pairs;
      const bool change = now->first_arm_is_left != last->first_arm_is_left ||
                          now->first_leg_is_left != last->first_leg_is_left;
      exchanged += change;
      if (change && !result.contains("jpeg")) {
        cv::Mat picture;
        cv::hconcat(last->picture, now->picture, picture);
        result["jpeg"] = packedJpeg(picture, kQuality);
        result["frame"] = last->frame;
      }
    }
    last = std::move(now);
  });
  result["pairs"] = pairs;
  result["exchanged"] = exchanged;
  return result;
}

}  // namespace markerless_mocap
