// How exactly the default options capture a person of whom nothing is known: from images of the
// virtual studio to joints in the world, as mocap_offline does it. The studio's person is a dressed
// skinned mesh that shares no code and no sizes with the tracker's body.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>

#include "accuracy/board_calibration.h"
#include "accuracy/filmed_capture.h"
#include "evaluation/body_points.h"
#include "evaluation/joint_error.h"
#include "evaluation/tracking_continuity.h"
#include "markerless_mocap/silhouette/recording_learner.h"
#include "markerless_mocap/tracking/pose_filter.h"

namespace markerless_mocap {
namespace {

/// A figure may grow by this factor. Another compiler changes less.
constexpr double kHeadroom = 1.3;

struct AccuracyCase {
  const char* name;
  const char* rig;
  const char* motion;
  double motion_start;  ///< seconds of the motion that are left out
  double stature;       ///< metres
  double male;          ///< 0..1
  const char* clothes;
  bool empty_room;  ///< the film begins with the empty room
  bool calibrated;  ///< the rig is found from a waved board
  /// Mean distance of the fifteen markers from the truth over all frames, of the version that last
  /// changed it, mm.
  double measured_mm;
};

constexpr AccuracyCase kCases[] = {
    {"WalkEightCameras", "ring8", "walk", 1.0, 1.70, 0.9, "tight", true, false, 7.50},
    {"WhirlEightCameras", "ring8", "whirling_dance", 1.0, 1.64, 0.1, "loose", true, false, 7.04},
    {"WalkFourCameras", "ring4", "walk", 1.0, 1.70, 0.9, "tight", true, false, 7.70},
    {"WhirlFourCameras", "ring4", "whirling_dance", 1.0, 1.64, 0.1, "loose", true, false, 7.87},
    {"WalkFourCamerasNoEmptyRoom", "ring4", "walk", 1.0, 1.70, 0.9, "tight", false, false, 7.85},
    {"WhirlEightCamerasNoEmptyRoom", "ring8", "whirling_dance", 1.0, 1.64, 0.1, "loose", false,
     false, 8.58},
    {"WalkCalibratedWideLenses", "wide6", "walk", 1.0, 1.70, 0.9, "tight", true, true, 9.71},
};

void PrintTo(const AccuracyCase& accuracy_case, std::ostream* out) {
  *out << accuracy_case.name;
}

StudioOptions studioFor(const AccuracyCase& accuracy_case) {
  StudioOptions options;
  options.rig = accuracy_case.rig;
  options.motion = accuracy_case.motion;
  options.motion_start = accuracy_case.motion_start;
  options.character.stature = accuracy_case.stature;
  options.character.male = accuracy_case.male;
  options.character.clothes = accuracy_case.clothes;
  options.width = 320;
  options.height = 240;
  options.fps = 20;
  options.duration = 5;
  options.seed = 1;
  if (!accuracy_case.empty_room) options.background_frames = 0;
  return options;
}

/// What comes out, in the world.
struct Captured {
  JointTrack joints;
  std::vector<FrameStatus> statuses;  ///< by frame of the truth
};

FrameStatus statusOf(PoseStatus status) {
  if (status == PoseStatus::kLost) return FrameStatus::kLost;
  return status == PoseStatus::kTracked ? FrameStatus::kTracked : FrameStatus::kReinitialized;
}

/// As mocap_offline has them after the pass that learns the backgrounds.
PipelineOptions optionsAfterLearning() {
  PipelineOptions options;
  options.silhouette.background = "first_images";
  return options;
}

/// First pass: the backgrounds. None if the film begins with the empty room.
std::vector<SharedBackground> learnedBackgrounds(const FilmedCapture& capture) {
  std::vector<RecordingLearner> learners;
  for (size_t i = 0; i < capture.rig().size(); ++i)
    learners.emplace_back(SilhouetteOptions(), int(capture.frameSets().size()));
  for (const FrameSet& frame_set : capture.frameSets())
    for (size_t i = 0; i < learners.size(); ++i) learners[i].add(frame_set.frames[i].image);
  return learnBackgrounds(learners);
}

/// Second pass: the sizes of the body; nothing if they could not be measured.
std::optional<ShapeParameters> measuredSizes(const FilmedCapture& capture,
                                             const std::vector<SharedBackground>& backgrounds) {
  Pipeline pipeline(capture.rig(), PersonResources::standard(), optionsAfterLearning());
  pipeline.useBackgrounds(backgrounds);
  std::atomic<bool> measured = false;
  const Pipeline::Source next = capture.reader();
  pipeline.processStream([&] { return measured ? std::nullopt : next(); },
                         [&](const FrameSet&, const PipelineResult& result) {
                           measured = measured || (result.body && result.body->shape_estimated);
                         });
  pipeline.estimateShapeNow();
  if (!pipeline.body()->shape_estimated) return std::nullopt;
  return pipeline.body()->shape;
}

/// Third pass: the poses of a body of these sizes, filtered.
Captured follow(const FilmedCapture& capture, const std::vector<SharedBackground>& backgrounds,
                const ShapeParameters& sizes) {
  PersonResources person = PersonResources::standard();
  person.known_shape = sizes;
  PipelineOptions options = optionsAfterLearning();
  options.fitting.person.measure = false;
  Pipeline pipeline(capture.rig(), person, options);
  pipeline.useBackgrounds(backgrounds);
  pipeline.followBack();
  const BodyModel& model = *pipeline.body()->model;
  std::optional<PoseFilter> filter = makePoseFilter(pipeline.body()->model, options.fitting.filter);
  Captured captured;
  captured.joints.names = bodyPointNames();
  const auto take = [&](const FrameSet& frame_set, const PipelineResult& result) {
    if (result.learning || frame_set.stamp_ns < capture.truth().stamps_ns.front()) return;
    captured.statuses.push_back(statusOf(result.pose.status));
    const BodyPose pose = filter->filtered(frame_set.stamp_ns, result.pose);
    if (pose.status == PoseStatus::kLost) return;
    LinkPoses T_world_link;
    model.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
    captured.joints.add(frame_set.stamp_ns, bodyPoints(model, T_world_link));
  };
  pipeline.processStream(capture.reader(), take);
  return captured;
}

std::string report(const AccuracyCase& accuracy_case, const JointErrors& errors) {
  char text[200];
  std::snprintf(text, sizeof text,
                "%s with %s%s: mean joint error %.2f mm, allowed are %.2f mm; worst frame %.1f mm",
                accuracy_case.motion, accuracy_case.rig,
                accuracy_case.empty_room ? "" : ", no empty room", errors.D_spread.mean,
                kHeadroom * accuracy_case.measured_mm, errors.D_spread.max);
  return text;
}

class AccuracyTest : public testing::TestWithParam<AccuracyCase> {};

TEST_P(AccuracyTest, EveryFrameHasAPoseAndJointsAreWhereTheTruthIs) {
  FilmedCapture capture(studioFor(GetParam()));
  if (GetParam().calibrated) capture.useRig(calibratedByBoard(capture.rig()));
  const std::vector<SharedBackground> backgrounds = learnedBackgrounds(capture);
  for (const SharedBackground& background : backgrounds)
    EXPECT_EQ(background == nullptr, GetParam().empty_room) << "is the empty room seen first?";
  const std::optional<ShapeParameters> sizes = measuredSizes(capture, backgrounds);
  ASSERT_TRUE(sizes) << "the body was not measured";
  const Captured captured = follow(capture, backgrounds, *sizes);

  const JointTrack truth = capture.truth().select(markerNames());
  const TrackingContinuity continuity = trackingContinuity(truth.stamps_ns, captured.statuses);
  EXPECT_EQ(continuity.seconds_to_first_pose, 0.0) << GetParam().name;
  EXPECT_EQ(continuity.losses.size(), 0u) << GetParam().name;

  const JointErrors errors = jointErrors(truth, alignedTo(truth, captured.joints));
  const std::string figures = report(GetParam(), errors);
  std::cout << figures << std::endl;
  EXPECT_LE(errors.D_spread.mean, kHeadroom * GetParam().measured_mm) << figures;
  EXPECT_EQ(errors.fraction_markers_missing, 0.0) << figures;
  EXPECT_EQ(errors.swaps.all, 0.0) << figures;
  EXPECT_EQ(errors.swaps.arms, 0.0) << figures;
  EXPECT_EQ(errors.swaps.legs, 0.0) << figures;
}

INSTANTIATE_TEST_SUITE_P(Studio, AccuracyTest, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace markerless_mocap
