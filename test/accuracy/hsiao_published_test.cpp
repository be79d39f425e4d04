// Small versions of what Hsiao 2008 says, with config/as_published/hsiao.yaml; `reproduce hsiao`
// has the large ones.
#include <gtest/gtest.h>

#include <functional>
#include <iostream>
#include <memory>

#include "accuracy/filmed_capture.h"
#include "evaluation/body_points.h"
#include "evaluation/joint_error.h"
#include "evaluation/part_error.h"

namespace markerless_mocap {
namespace {

const int kBackgroundFrames = 12;

StudioOptions studioOf(const char* motion) {
  StudioOptions studio;
  studio.motion = motion;
  studio.motion_start = 2.0;
  studio.duration = 1.2;
  studio.fps = 10;
  studio.width = 320;
  studio.height = 240;
  studio.background_frames = kBackgroundFrames;
  return studio;
}

PipelineOptions published(double stature) {
  YAML::Node root =
      YAML::LoadFile(std::string(MOCAP_SOURCE_DIR) + "/config/as_published/hsiao.yaml");
  root["silhouette"]["background_frames"] = kBackgroundFrames;
  root["pose_fitting"]["stature"] = stature;
  return loadPipelineOptions(root);
}

class HsiaoAsPublished : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const StudioOptions studio = studioOf("push_luggage");
    capture_ = std::make_unique<FilmedCapture>(studio);
    options_ = published(studio.character.stature);
    Pipeline pipeline(capture_->rig(), PersonResources::standard(), options_);
    for (const FrameSet& frame_set : capture_->frameSets()) {
      PipelineResult result = pipeline.process(frame_set.stamp_ns, frame_set.frames);
      if (!result.learning && frame_set.stamp_ns >= capture_->truth().stamps_ns.front())
        results_.push_back(std::move(result));
    }
    ASSERT_EQ(results_.size(), capture_->truth().frames());
  }
  static void TearDownTestSuite() {
    capture_.reset();
    results_.clear();
  }

  static std::unique_ptr<FilmedCapture> capture_;
  static PipelineOptions options_;
  static std::vector<PipelineResult> results_;
};
std::unique_ptr<FilmedCapture> HsiaoAsPublished::capture_;
PipelineOptions HsiaoAsPublished::options_;
std::vector<PipelineResult> HsiaoAsPublished::results_;

// Chapter 4.
TEST_F(HsiaoAsPublished, FollowsAPersonWithoutMarkersOrHelp) {
  JointTrack found;
  found.names = markerNames();
  for (size_t f = 0; f < results_.size(); ++f) {
    Eigen::Matrix3Xd markers = Eigen::Matrix3Xd::Constant(3, markerNames().size(), NAN);
    const BodyPose& pose = results_[f].pose;
    if (pose.status != PoseStatus::kLost) {
      LinkPoses T_world_link;
      results_[f].body->model->forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
      markers = bodyPoints(*results_[f].body->model, T_world_link).leftCols(markers.cols());
    }
    found.add(capture_->truth().stamps_ns[f], markers);
  }
  const JointErrors errors = jointErrors(capture_->truth().select(markerNames()), found);
  RecordProperty("median_mm", int(errors.D_spread.median));
  EXPECT_LE(errors.fraction_without_estimate, 0.1);
  EXPECT_LT(errors.D_spread.median, 120.0);
  EXPECT_LE(errors.swaps.all, 0.1);  // 3.2.1.2: it spins to the right orientation
}

/// How well parts match the truth, mean over the frames.
struct PartShares {
  double correct = 0.0;  ///< voxels
  double torso = 0.0;    ///< frames in which the torso overlaps the true one by more than half
};

/// \param parts of the hull of a result
PartShares sharesOf(const JointTrack& points, const std::vector<PipelineResult>& results,
                    const std::function<BodyParts(const PipelineResult&)>& parts) {
  const JointTrack truth = points.select(partTruthNames());
  PartShares shares;
  for (size_t f = 0; f < results.size(); ++f) {
    const VisualHull& hull = results[f].hull;
    SegmentedHull segmented;
    segmented.pitch = hull.lattice.pitch;
    segmented.voxels.resize(3, Eigen::Index(hull.voxels.size()));
    for (size_t v = 0; v < hull.voxels.size(); ++v)
      segmented.voxels.col(Eigen::Index(v)) = hull.lattice.center(hull.voxels[v].index);
    segmented.labels = parts(results[f]).labels;
    const PartEvaluation part = evaluateParts(truth.positions[f], segmented);
    shares.correct += part.fraction_correct / double(results.size());
    shares.torso += (part.overlap[0] > 0.5) / double(results.size());
  }
  return shares;
}

// 3.1.4 and 3.1.5: parts without a model, and a curve in each.
TEST_F(HsiaoAsPublished, CutsTheHullIntoParts) {
  const PartShares shares =
      sharesOf(capture_->truth(), results_, [](const PipelineResult& now) { return now.parts; });
  RecordProperty("correct_percent", int(100 * shares.correct));
  EXPECT_GT(shares.correct, 0.75);
  EXPECT_GT(shares.torso, 0.9);
}

// Figure 3-15.
TEST_F(HsiaoAsPublished, ModifiedLaplacianSegmentsBetterThanTheOriginal) {
  SegmentationOptions original = options_.segmentation;
  original.walk_stop = "outliers";
  original.shrink_weight = 0.0;
  original.use_color_votes = false;
  const auto cutBy = [](const SegmentationOptions& options) {
    return [segmenter = std::make_shared<BodySegmenter>(options)](const PipelineResult& now) {
      return segmenter->segment(now.hull);
    };
  };
  const PartShares before = sharesOf(capture_->truth(), results_, cutBy(original)),
                   after = sharesOf(capture_->truth(), results_, cutBy(options_.segmentation));
  std::cout << "voxels right: original " << before.correct << ", modified " << after.correct
            << std::endl;
  EXPECT_GT(after.correct, before.correct + 0.03);
}

// Figure 3-8.
TEST_F(HsiaoAsPublished, FourOfEightCamerasLeaveArtifacts) {
  double eight = 0.0, four = 0.0;
  for (size_t f = 0; f < results_.size(); ++f) {
    CameraRig rig;
    std::vector<HullView> views;
    for (const size_t camera : {0, 2, 4, 6}) {
      rig.push_back(capture_->rig()[camera]);
      views.push_back({results_[f].masks[camera], cv::Mat()});
    }
    eight += results_[f].hull.litres();
    four += HullCarver(rig, options_.hull).carve(views).litres();
  }
  EXPECT_GT(four, 1.15 * eight);
}

}  // namespace
}  // namespace markerless_mocap
