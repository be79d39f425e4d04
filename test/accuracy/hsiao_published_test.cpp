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
    results_ = resultsWith(options_);
    ASSERT_EQ(results_.size(), capture_->truth().frames());
  }
  static void TearDownTestSuite() {
    capture_.reset();
    results_.clear();
  }

  static std::vector<PipelineResult> resultsWith(const PipelineOptions& options) {
    Pipeline pipeline(capture_->rig(), PersonResources::standard(), options);
    std::vector<PipelineResult> results;
    for (const FrameSet& frame_set : capture_->frameSets()) {
      PipelineResult result = pipeline.process(frame_set.stamp_ns, frame_set.frames);
      if (!result.learning && frame_set.stamp_ns >= capture_->truth().stamps_ns.front())
        results.push_back(std::move(result));
    }
    return results;
  }

  static std::unique_ptr<FilmedCapture> capture_;
  static PipelineOptions options_;
  static std::vector<PipelineResult> results_;
};
std::unique_ptr<FilmedCapture> HsiaoAsPublished::capture_;
PipelineOptions HsiaoAsPublished::options_;
std::vector<PipelineResult> HsiaoAsPublished::results_;

JointTrack foundBy(const std::vector<PipelineResult>& results, const JointTrack& truth) {
  JointTrack found;
  found.names = markerNames();
  for (size_t f = 0; f < results.size(); ++f) {
    Eigen::Matrix3Xd markers = Eigen::Matrix3Xd::Constant(3, markerNames().size(), NAN);
    const BodyPose& pose = results[f].pose;
    if (pose.status != PoseStatus::kLost) {
      LinkPoses T_world_link;
      results[f].body->model->forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
      markers = bodyPoints(*results[f].body->model, T_world_link).leftCols(markers.cols());
    }
    found.add(truth.stamps_ns[f], markers);
  }
  return found;
}

/// Mean second difference of the markers, mm.
double jitterOf(const JointTrack& track) {
  std::vector<double> steps;
  for (size_t f = 2; f < track.frames(); ++f)
    steps.push_back(1e3 *
                    (track.positions[f] - 2.0 * track.positions[f - 1] + track.positions[f - 2])
                        .colwise()
                        .norm()
                        .mean());
  return summaryStatistics(steps).mean;
}

// Chapter 4.
TEST_F(HsiaoAsPublished, FollowsAPersonWithoutMarkersOrHelp) {
  const JointTrack truth = capture_->truth().select(markerNames());
  const JointErrors errors = jointErrors(truth, foundBy(results_, truth));
  std::cout << "D " << errors.D_spread.median << " mm" << std::endl;
  EXPECT_LE(errors.fraction_without_estimate, 0.1);
  EXPECT_LT(errors.D_spread.median, 120.0);
  EXPECT_LE(errors.swaps.all, 0.1);  // 3.2.1.2: it spins to the right orientation
}

// 3.2.2.5.
TEST_F(HsiaoAsPublished, TheTemporalSwarmIsConsistentAndDoesNotPassErrorsOn) {
  PipelineOptions basic_only = options_;
  basic_only.fitting.hsiao.max_pose_age = 0.0;  // the last pose is always too old
  const JointTrack truth = capture_->truth().select(markerNames());
  const JointTrack temporal = foundBy(results_, truth),
                   basic = foundBy(resultsWith(basic_only), truth);
  const double near = jointErrors(truth, temporal).D_spread.mean,
               far = jointErrors(truth, basic).D_spread.mean;
  std::cout << "jitter: temporal " << jitterOf(temporal) << ", basic " << jitterOf(basic)
            << " mm; D " << near << " and " << far << " mm" << std::endl;
  EXPECT_LT(jitterOf(temporal), 0.8 * jitterOf(basic));
  EXPECT_LT(near, far);
}

/// \param parts of the hull of a result
PartErrors partsOf(const JointTrack& points, const std::vector<PipelineResult>& results,
                   const std::function<BodyParts(const PipelineResult&)>& parts) {
  std::vector<SegmentedHull> hulls(results.size());
  for (size_t f = 0; f < results.size(); ++f) {
    const VisualHull& hull = results[f].hull;
    const BodyParts cut = parts(results[f]);
    SegmentedHull& segmented = hulls[f];
    segmented.pitch = hull.lattice.pitch;
    segmented.voxels.resize(3, Eigen::Index(hull.voxels.size()));
    for (size_t v = 0; v < hull.voxels.size(); ++v)
      segmented.voxels.col(Eigen::Index(v)) = hull.lattice.center(hull.voxels[v].index);
    segmented.labels = cut.labels;
    for (size_t part = 0; part < cut.parts.size(); ++part) {
      const std::vector<Eigen::Vector3d>& curve = cut.parts[part].points;
      if (!curve.empty())
        segmented.curves[part] =
            Eigen::Map<const Eigen::Matrix3Xd>(curve.front().data(), 3, Eigen::Index(curve.size()));
    }
  }
  return partErrors(points.select(partTruthNames()), hulls);
}

/// Share of the frames in which a part overlaps the true one by more than half.
double foundShare(const PartErrors& errors, size_t part) {
  double share = 0.0;
  for (const PartEvaluation& frame : errors.verdicts)
    share += (frame.overlap[part] > 0.5) / double(errors.verdicts.size());
  return share;
}

void tell(const char* what, const PartErrors& errors) {
  std::cout << what << ": voxels right " << errors.all.fraction_correct << ", all six "
            << errors.all.fraction_all_six << ", head " << foundShare(errors, 1)
            << "; curves, mm: torso " << errors.torso_mm.mean << ", arms " << errors.arms_mm.mean
            << ", legs " << errors.legs_mm.mean << std::endl;
}

std::function<BodyParts(const PipelineResult&)> cutBy(const SegmentationOptions& options) {
  return [segmenter = std::make_shared<BodySegmenter>(options)](const PipelineResult& now) {
    return segmenter->segment(now.hull);
  };
}

BodyParts ownParts(const PipelineResult& now) {
  return now.parts;
}

// 3.1.4 and 3.1.5: parts without a model, and a curve in each. One dimension suffices for limbs.
TEST_F(HsiaoAsPublished, CutsTheHullIntoPartsWithCurves) {
  const PartErrors parts = partsOf(capture_->truth(), results_, ownParts);
  tell("as published", parts);
  EXPECT_GT(parts.all.fraction_correct, 0.75);
  EXPECT_GT(foundShare(parts, 0), 0.9);
  EXPECT_LT(parts.arms_mm.mean, 40.0);
  EXPECT_LT(parts.legs_mm.mean, 40.0);
}

// Figure 3-15.
TEST_F(HsiaoAsPublished, ModifiedLaplacianSegmentsBetterThanTheOriginal) {
  SegmentationOptions original = options_.segmentation;
  original.walk_stop = "outliers";
  original.shrink_weight = 0.0;
  original.use_color_votes = false;
  const PartErrors before = partsOf(capture_->truth(), results_, cutBy(original)),
                   after = partsOf(capture_->truth(), results_, ownParts);
  tell("original", before);
  EXPECT_GT(after.all.fraction_correct, before.all.fraction_correct + 0.03);
}

// 3.1.4.2.
TEST_F(HsiaoAsPublished, ColourVotesKeepPartsApart) {
  SegmentationOptions grey = options_.segmentation;
  grey.use_color_votes = false;
  const PartErrors without = partsOf(capture_->truth(), results_, cutBy(grey)),
                   with = partsOf(capture_->truth(), results_, ownParts);
  tell("without colour votes", without);
  EXPECT_GT(foundShare(with, 1), foundShare(without, 1));  // the head
  EXPECT_GT(with.all.fraction_all_six, without.all.fraction_all_six);
  EXPECT_GT(with.all.fraction_correct, without.all.fraction_correct + 0.02);
}

// Figure 3-8.
TEST_F(HsiaoAsPublished, FourOfEightCamerasLeaveArtifacts) {
  CameraRig rig;
  for (const size_t camera : {0, 2, 4, 6}) rig.push_back(capture_->rig()[camera]);
  HullCarver carver(rig, options_.hull);
  double eight = 0.0, four = 0.0;
  for (const PipelineResult& now : results_) {
    std::vector<HullView> views;
    for (const size_t camera : {0, 2, 4, 6}) views.push_back({now.masks[camera], cv::Mat()});
    eight += now.hull.litres();
    four += carver.carve(views).litres();
  }
  EXPECT_GT(four, 1.15 * eight);
}

/// Mean volume of the hulls of somebody who waves, litres.
double litresSeenBy(const char* rig) {
  StudioOptions studio = studioOf("wave");
  studio.rig = rig;
  studio.background_frames = 0;
  const VirtualStudio stage(studio, packageFiles(), "person1");
  HullCarver carver(stage.rig(), published(studio.character.stature).hull);
  double litres = 0.0;
  for (int frame = 0; frame < stage.frameSetCount(); frame += 3) {
    std::vector<HullView> views;
    for (const cv::Mat& mask : stage.render(frame).masks) views.push_back({mask, cv::Mat()});
    litres += carver.carve(views).litres();
  }
  return litres;
}

// Figure 4-1.
TEST(HsiaoCameras, OneAboveGivesFewerArtifacts) {
  const double around = litresSeenBy("ring8"), above = litresSeenBy("ring7_overhead");
  std::cout << "around " << around << " l, one above " << above << " l" << std::endl;
  EXPECT_LT(above, 0.97 * around);
}

}  // namespace
}  // namespace markerless_mocap
