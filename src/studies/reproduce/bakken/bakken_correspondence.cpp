#include "studies/reproduce/bakken/bakken_correspondence.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

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

/// Every n-th frame of a capture, one after another.
class Follower {
 public:
  Follower(const PoseTreeOptions& options, size_t step) : step(step), options_(options) {}

  void add(size_t frame, const Camera& camera, const VisualHull& hull,
           const CurveSkeleton& skeleton, const JointTrack& truth) {
    if (frame % step != 0) return;
    std::optional<Followed> now = label(frame, hull, skeleton, truth);
    if (now && exchanged == 0) now->picture = drawTree(camera, hull, now->tree, colorsOf(*now));
    if (now && before_ && before_->frame + step == frame) count(*now);
    before_ = std::move(now);
  }

  size_t step;
  int pairs = 0, exchanged = 0;
  int longest_astray = 0;  ///< successive frames that are valid, but wrong
  cv::Mat picture;         ///< the first exchange
  size_t picture_frame = 0;

 private:
  /// The frame, if it is labelled right.
  std::optional<Followed> label(size_t frame, const VisualHull& hull, const CurveSkeleton& skeleton,
                                const JointTrack& truth) {
    PreviousExtremities labelled;
    const PreviousExtremities last = std::exchange(last_, std::nullopt);
    const int astray = std::exchange(astray_, 0);
    if (rejectHull(hull)) return std::nullopt;
    Followed now{
        frame, Labelling(options_, model_, hull, skeleton).run(last, &labelled), {}, false, false};
    last_ = labelled;
    if (!now.tree.valid()) return std::nullopt;
    if (!labelErrors(truth, {labelsOf(now.tree)}).verdicts.front().right) {
      astray_ = astray + 1;
      longest_astray = std::max(longest_astray, astray_);
      return std::nullopt;
    }
    now.first_arm_is_left =
        isAt(labelled, UnsidedExtremity::kHand1, now.tree, Extremity::kLeftHand);
    now.first_leg_is_left =
        isAt(labelled, UnsidedExtremity::kFoot1, now.tree, Extremity::kLeftFoot);
    return now;
  }
  void count(const Followed& now) {
    ++pairs;
    if (now.first_arm_is_left == before_->first_arm_is_left &&
        now.first_leg_is_left == before_->first_leg_is_left)
      return;
    if (exchanged++ > 0) return;
    cv::hconcat(before_->picture, now.picture, picture);
    picture_frame = before_->frame;
  }

  PoseTreeOptions options_;
  PoseTreeModel model_ = PoseTreeModel::standard();
  PreviousExtremities last_;
  int astray_ = 0;
  std::optional<Followed> before_;
};

}  // namespace

Json followLabels(const Capture& capture, int edge) {
  const JointTrack truth = labelTruth(capture);
  const CameraRig rig = rigOf(capture);
  HullCarver carver(rig, cubeAround(truth, publishedBakkenOptions(edge).hull));
  const PoseTreeOptions options = optionsOf(bakkenVariant("prune08"), publishedBakkenYaml());
  Thinner thinner(options.persistence);
  std::vector<Follower> followers;
  for (const size_t step : {1, 2, 4}) followers.emplace_back(options, step);
  forEachFrame(capture, truth, [&](size_t frame, const std::vector<HullView>& views) {
    const VisualHull hull = carver.carve(views);
    const CurveSkeleton skeleton = thinner.thin(hull);
    for (Follower& follower : followers)
      follower.add(frame, rig[0], hull, skeleton, frameOf(truth, frame));
  });
  Json result;
  for (const Follower& follower : followers) {
    result["every"].push_back({{"step", follower.step},
                               {"pairs", follower.pairs},
                               {"exchanged", follower.exchanged},
                               {"astray", follower.longest_astray}});
    if (follower.exchanged == 0 || result.contains("jpeg")) continue;
    result["jpeg"] = packedJpeg(follower.picture, kQuality);
    result["frame"] = follower.picture_frame;
    result["step"] = follower.step;
  }
  return result;
}

}  // namespace markerless_mocap
