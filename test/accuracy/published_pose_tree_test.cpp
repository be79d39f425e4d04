// The claims of Bakken & Hilton 2012, section 4, over a few frames of a whirling dance. `reproduce
// bakken` has all of them.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "capture/ground_truth.h"
#include "capture/studio_fixture.h"
#include "capture/virtual_studio.h"
#include "evaluation/label_error.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "markerless_mocap/skeleton/pose_tree_builder.h"

namespace markerless_mocap {
namespace {

PipelineOptions published() {
  return loadPipelineOptions(
      YAML::LoadFile(std::string(MOCAP_SOURCE_DIR) + "/config/as_published/bakken.yaml"));
}

/// Hulls of a motion in the published cube, and the true points.
struct Motion {
  std::vector<VisualHull> coarse, fine;
  JointTrack truth;
};

/// \param frames at even distances over the motion
Motion filmed(StudioOptions studio, int frames) {
  studio.character.stature = 1.62;
  studio.width = 400;
  studio.height = 300;
  studio.background_frames = 0;
  const VirtualStudio stage(studio, packageFiles(), "person1");
  HullOptions fine = published().hull, coarse = fine;
  coarse.pitch = 2.0 / 64.0;
  for (HullOptions* options : {&fine, &coarse}) {
    options->volume = "explicit";
    options->volume_min = {-1.25, -1.25, 0.0};  // room for all of the dance
    options->volume_max = {1.25, 1.25, 2.2};
  }
  HullCarver carve_fine(stage.rig(), fine), carve_coarse(stage.rig(), coarse);
  Motion out;
  out.truth.names = groundTruthNames();
  for (int i = 0; i < frames; ++i) {
    const StudioFrameSet now = stage.render(i * stage.frameSetCount() / frames);
    std::vector<HullView> views;
    for (const cv::Mat& mask : now.masks) views.push_back({mask, {}});
    out.fine.push_back(carve_fine.carve(views));
    out.coarse.push_back(carve_coarse.carve(views));
    out.truth.add(now.time_ns, Eigen::Map<const Eigen::Matrix3Xd>(now.points.front().data(), 3,
                                                                  Eigen::Index(now.points.size())));
  }
  return out;
}

const Motion& dance() {
  static const Motion dance = [] {
    StudioOptions studio;
    studio.motion = "whirling_dance";
    return filmed(studio, 24);
  }();
  return dance;
}

LabelledExtremities labelsOf(const PoseTree& tree) {
  LabelledExtremities labels;
  labels.valid = tree.valid();
  labels.validity = tree.validity;
  for (int i = 0; i < kExtremityCount; ++i) {
    const TreeExtremity& extremity = tree.extremities[size_t(i)];
    if (extremity.node < 0) continue;
    labels.positions.col(i) = extremity.position;
    std::vector<Eigen::Vector3d> limb;
    const TreePart part = tree.nodes[size_t(extremity.node)].part;
    for (int32_t at = extremity.node; at >= 0 && tree.nodes[size_t(at)].part == part;
         at = tree.nodes[size_t(at)].parent)
      limb.push_back(tree.nodes[size_t(at)].position);
    labels.limbs[size_t(i)] =
        Eigen::Map<const Eigen::Matrix3Xd>(limb.front().data(), 3, Eigen::Index(limb.size()));
  }
  return labels;
}

LabelErrors judged(const JointTrack& truth, const std::vector<VisualHull>& hulls,
                   const PoseTreeOptions& options) {
  PoseTreeBuilder builder(options);
  std::vector<LabelledExtremities> labels;
  for (const VisualHull& hull : hulls) labels.push_back(labelsOf(builder.build(hull)));
  return labelErrors(truth, labels);
}

LabelErrors judged(const std::vector<VisualHull>& hulls, const PoseTreeOptions& options) {
  return judged(dance().truth, hulls, options);
}

/// The published options for frames that are half a second apart, with another least length.
PoseTreeOptions ranking(double prune_ratio) {
  PoseTreeOptions options = published().pose_tree;
  options.follow_labels = false;
  options.prune_ratio = prune_ratio;
  return options;
}

double handsAndFeet(const LabelErrors& errors) {
  return 0.5 * (errors.hands_if_correct_mm.mean + errors.feet_if_correct_mm.mean);
}

void tell(const char* what, const LabelErrors& errors) {
  std::cout << what << ": " << 100.0 * errors.fraction_correct_and_valid << " % right, "
            << 100.0 * errors.fraction_wrong_but_valid << " % wrong but valid, hands and feet "
            << handsAndFeet(errors) << " mm" << std::endl;
}

TEST(PublishedPoseTree, BranchesAsShortAsAHeadMustStay) {
  const LabelErrors arm = judged(dance().fine, ranking(0.274)),
                    head = judged(dance().fine, ranking(0.08));
  tell("pruned below an arm", arm);
  tell("pruned below 0.08", head);
  EXPECT_GT(head.fraction_correct_and_valid, arm.fraction_correct_and_valid + 0.2);
  EXPECT_LE(arm.fraction_wrong_but_valid, 0.05) << "frames must fail gracefully";
}

TEST(PublishedPoseTree, MostFramesOfADanceAreLabelledRightAtBothResolutions) {
  const LabelErrors fine = judged(dance().fine, ranking(0.08)),
                    coarse = judged(dance().coarse, ranking(0.08));
  tell("64", coarse);
  EXPECT_GE(fine.fraction_correct_and_valid, 0.85);
  EXPECT_GE(coarse.fraction_correct_and_valid, 0.75);
}

TEST(PublishedPoseTree, LeavesAreWithinThePublishedErrors) {
  EXPECT_LT(handsAndFeet(judged(dance().fine, ranking(0.08))), 46.8);
  EXPECT_LT(handsAndFeet(judged(dance().coarse, ranking(0.08))), 53.2);
}

// 42.6 % in the paper; others are not valid.
TEST(PublishedPoseTree, SomeFramesOfRunCrouchJumpAreLabelledRightAndFewWrongly) {
  StudioOptions studio;
  studio.motion = "run_crouch_jump";
  studio.motion_start = 0.5;
  studio.duration = 108.0 / 25.0;
  const Motion jump = filmed(studio, 18);
  const LabelErrors errors = judged(jump.truth, jump.fine, ranking(0.274));
  tell("run-crouch-jump", errors);
  EXPECT_GE(errors.fraction_correct_and_valid, 0.426);
  EXPECT_LE(errors.fraction_wrong_but_valid, 0.12);
}

TEST(PublishedPoseTree, LearnedLabellingIsNoWorseAndNearer) {
  PoseTreeOptions learned;
  learned.min_validity = 0.0;
  const LabelErrors default_labels = judged(dance().fine, learned),
                    published_labels = judged(dance().fine, ranking(0.08));
  tell("learned", default_labels);
  EXPECT_GE(default_labels.fraction_correct, published_labels.fraction_correct - 0.05);
  EXPECT_LT(handsAndFeet(default_labels), 40.0);
  const ExtremityLabelError& head = default_labels.ends.front();
  std::cout << head.name << ' ' << head.error_mm.mean << " mm" << std::endl;
  EXPECT_LT(head.error_mm.mean, 25.0) << "of its centre, not of the crown";
}

}  // namespace
}  // namespace markerless_mocap
