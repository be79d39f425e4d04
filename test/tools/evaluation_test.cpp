#include "tools/evaluate/evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "error_text_of.h"
#include "markerless_mocap/camera/rig_file.h"
#include "pages/page_reader.h"
#include "tools/evaluate/evaluation_json.h"
#include "tools/evaluate/evaluation_page.h"
#include "tools/evaluate/evaluation_table.h"
#include "tools/evaluation_fixture.h"

namespace markerless_mocap {
namespace {

constexpr double kSameTransforms_mm = 1e-6;  // what remains of the way through quaternions

TEST_F(EvaluationTest, TruthAgainstItselfIsPerfectThroughBothBags) {
  writeTruth();
  writeResults(nothing);
  const Evaluation found = judged();
  EXPECT_EQ(found.body_id, "person1");
  EXPECT_EQ(found.joints.frames_estimated, size_t(kFrames));
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
  EXPECT_EQ(found.joints.swaps.all, 0.0);
  EXPECT_EQ(found.record.tracked, size_t(kFrames));
  EXPECT_NEAR(found.delay.seconds, 0.0, 1e-3);
  for (const ExtremityError& part : found.extremities) {
    EXPECT_LT(part.error_mm.max, kSameTransforms_mm) << part.name;
    EXPECT_EQ(part.fraction_correct, 1.0) << part.name;
  }
  ASSERT_EQ(found.angles.size(), size_t(model_.angleCount()));
  for (const AngleError& angle : found.angles) EXPECT_EQ(angle.error_deg.max, 0.0) << angle.joint;
  EXPECT_EQ(found.latency_ms.count, 0u);
  EXPECT_TRUE(found.notes.empty());
}

TEST_F(EvaluationTest, SilhouettesBodyAndHullOfTheTruthOverlapWholly) {
  writeTruth();
  writeResults(nothing);
  const ImageMetrics images = judged().images;
  EXPECT_EQ(images.frame_sets.size(), size_t(kFrames));
  ASSERT_EQ(images.cameras.size(), 4u);
  for (size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(images.mask_iou[c].mean, 1.0) << c;
    EXPECT_EQ(images.body_iou[c].mean, 1.0) << c;
    EXPECT_NEAR(images.person_iou[c].mean, shareOfPersons(c), 1e-9) << c;
  }
  EXPECT_EQ(images.hull_iou.count, size_t(kFrames));
  EXPECT_EQ(images.hull_iou.mean, 1.0);
}

// The run that is judged took a rig that had been moved along with all that stands on it.
TEST_F(EvaluationTest, TheBodyIsDrawnWithTheRigOfTheRun) {
  writeTruth();
  std::vector<CameraCalibration> moved;
  for (const Camera& camera : rig_) {
    moved.push_back(camera.calibration());
    moved.back().T_world_camera.translation().z() += 0.1;
  }
  rig_.clear();
  for (const CameraCalibration& camera : moved) rig_.emplace_back(camera);
  writeResults([](int, BodyPose* pose) { pose->T_world_body.translation().z() += 0.1; });
  EXPECT_LT(meanOfMeans(judged().images.body_iou), 0.9);
  request_.rig = path("rig.yaml");
  writeRig(request_.rig, moved);
  EXPECT_EQ(meanOfMeans(judged().images.body_iou), 1.0);
  request_.rig = path("no_rig.yaml");
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { judged(); }),
            "cannot read the rig " + request_.rig + ": there is no such file");
}

TEST_F(EvaluationTest, AShiftComesBackAndCostsOverlapOfTheBodyOnly) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->T_world_body.translation().z() += 0.1; });
  const Evaluation found = judged();
  EXPECT_NEAR(found.joints.D_spread.mean, 100.0, kSameTransforms_mm);
  EXPECT_NEAR(found.joints.D_mean_unbiased, 0.0, kSameTransforms_mm);
  EXPECT_LT(meanOfMeans(found.images.body_iou), 0.9);
  EXPECT_EQ(meanOfMeans(found.images.mask_iou), 1.0);
}

TEST_F(EvaluationTest, LostFramesHaveNoEstimateEvenIfTfStandsStill) {
  writeTruth();
  writeResults([](int f, BodyPose* pose) {
    if (f >= 10 && f < 15) pose->status = PoseStatus::kLost, pose->reason = "nobody is there";
    if (f == 15) pose->status = PoseStatus::kReinitialized;
  });
  {
    rosbag::Bag bag(request_.results, rosbag::bagmode::Append);  // somebody repeats the last frame
    tf2_msgs::TFMessage still;
    still.transforms.push_back(cameraTransform(rig_[0]));
    still.transforms[0].header.stamp = rosTime(stampOf(12));
    still.transforms[0].child_frame_id = "body_person1";
    bag.write("/tf", rosTime(stampOf(12)), still);
  }
  const Evaluation found = judged();
  EXPECT_EQ(found.joints.frames_estimated, size_t(kFrames - 5));
  EXPECT_EQ(found.record.lost, 5u);
  EXPECT_EQ(found.record.reinitialized, 1u);
  ASSERT_EQ(found.record.losses.size(), 1u);
  EXPECT_NEAR(found.record.losses[0].seconds, 0.2, 1e-9);
  EXPECT_EQ(found.reasons[12], "nobody is there");
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
}

TEST_F(EvaluationTest, PartsThatAreNotSeenAreMissingMarkers) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->part_seen[size_t(PartLabel::kArm1)] = false; });
  const Evaluation found = judged();
  EXPECT_NEAR(found.joints.fraction_markers_missing, 3.0 / 15, 1e-12);
  EXPECT_NEAR(found.extremities[0].fraction_correct, 0.5, 1e-12);
  ASSERT_EQ(found.limbs.size(), 5u);
  EXPECT_EQ(found.limbs[1].limb, "left_arm");
  EXPECT_EQ(found.limbs[1].not_published, size_t(kFrames));
  EXPECT_EQ(found.limbs[2].fraction_lost, 0.0);
  EXPECT_NE(evaluationJson(found).find("\"frames_not_published\": 40"), std::string::npos);
}

TEST_F(EvaluationTest, ExpectedErrorsAreHeldAgainstThoseMade) {
  writeTruth();
  writeResults([](int, BodyPose* pose) {
    pose->T_world_body.translation().z() += 0.03;
    pose->part_sigma_m[size_t(PartLabel::kHead)] = 0.02;
    pose->part_sigma_m[size_t(PartLabel::kLeg2)] = 0.01;
  });
  const Evaluation found = judged();
  ASSERT_EQ(found.deviations.size(), 2u);
  EXPECT_EQ(found.deviations[0].point, "head");
  EXPECT_NEAR(found.deviations[0].expected_mm, 20.0, 1e-9);
  EXPECT_NEAR(found.deviations[0].actual_mm, 30.0, kSameTransforms_mm);
  EXPECT_EQ(found.deviations[0].fraction_within_two_sigma, 1.0);
  EXPECT_EQ(found.deviations[1].point, "r_ankle");
  EXPECT_EQ(found.deviations[1].fraction_within_two_sigma, 0.0);
  EXPECT_EQ(partUnder(contentOf(evaluationPage(found)), "Estimated and actual errors",
                      "table")["rows"][0][2],
            "30");
}

TEST_F(EvaluationTest, FeetAreJudgedByTheFloorAndTheTruth) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->T_world_body.translation().z() -= 0.05; });
  const Evaluation found = judged();
  const double sole = soleHeights(model_, linksOf(poseOf(0)))[0] - 0.05;
  ASSERT_LT(sole, -0.011);
  for (const FootEvaluation& foot : found.feet) {
    EXPECT_EQ(foot.sole.frames, size_t(kFrames));
    EXPECT_EQ(foot.sole.fraction_below, 1.0);
    EXPECT_NEAR(foot.sole.deepest_mm, -1e3 * sole, 1e-6);
    EXPECT_EQ(foot.ball.truth, foot.ball.estimate);
    EXPECT_NEAR(foot.ball_mm[7], foot.true_ball_mm[7] - 50.0, kSameTransforms_mm);
  }
  EXPECT_NE(evaluationJson(found).find("\"fraction_below_10_mm\": 1"), std::string::npos);
  EXPECT_TRUE(
      hasPart(contentOf(evaluationPage(found)), "Feet and the floor, against the truth", "bands"));
}

TEST_F(EvaluationTest, DelayComesBack) {
  writeTruth();
  writeResults([this](int f, BodyPose* pose) { *pose = poseAt(f * kStep * 1e-9 - 0.06); });
  EXPECT_NEAR(judged().delay.seconds, 0.06, 0.002);
}

TEST_F(EvaluationTest, AnglesAreComparedByName) {
  writeTruth();
  writeResults(
      [this](int, BodyPose* pose) { pose->angles[model_.angleIndex("r_knee")] = M_PI / 6; });
  for (const AngleError& angle : judged().angles)
    EXPECT_NEAR(angle.error_deg.mean, angle.joint == "r_knee" ? 30.0 : 0.0, 1e-9) << angle.joint;
}

TEST_F(EvaluationTest, SkippedSecondsAreLeftOut) {
  writeTruth();
  writeResults([](int f, BodyPose* pose) {
    if (f < 10) pose->T_world_body.translation().x() += 1.0;
  });
  request_.skip = 0.4;  // ten frames
  const Evaluation found = judged();
  EXPECT_EQ(found.joints.frames, size_t(kFrames - 10));
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
  request_.skip = 60;
  EXPECT_EQ(errorTextOf<std::exception>([&] { judged(); }),
            "nothing is left to evaluate: the ground truth is shorter than the time to skip");
}

TEST_F(EvaluationTest, AResultThatIsLostThroughoutIsAResult) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->status = PoseStatus::kLost; });
  const Evaluation found = judged();
  EXPECT_EQ(found.joints.fraction_without_estimate, 1.0);
  EXPECT_TRUE(std::isnan(found.joints.D_spread.mean));
  EXPECT_NE(evaluationJson(found).find("\"D_mean\": null"), std::string::npos);
  EXPECT_TRUE(says(contentOf(evaluationPage(found)), "40 lost"));
}

TEST_F(EvaluationTest, JsonAndPageCarryTheFigures) {
  writeTruth();
  writeResults([](int, BodyPose* pose) { pose->T_world_body.translation().z() += 0.1; });
  const Evaluation found = judged();
  const Json content = contentOf(evaluationPage(found));
  EXPECT_EQ(partUnder(content, "", "cards")["cards"][0]["value"], "100.0 mm");
  EXPECT_EQ(partUnder(content, "Error per joint", "table")["rows"][0][1], "100");
  EXPECT_EQ(Json::parse(evaluationJson(found))["swap_rate"], 0);
  std::ostringstream table;
  printEvaluation(found, table);
  EXPECT_NE(table.str().find("mean            100.0   (0.0 with"), std::string::npos)
      << table.str();
}

TEST_F(EvaluationTest, PlayerHasTheTruthBesideTheResult) {
  writeTruth();
  writeResults([](int f, BodyPose* pose) {
    pose->T_world_body.translation().z() += f >= 20 && f < 23 ? 0.4 : 0.1;
    if (f == 12) pose->status = PoseStatus::kLost;
    if (f == 12) pose->reason = "nobody is there";
  });
  request_.page = true;
  const Json player = partUnder(contentOf(evaluationPage(judged())), "", "player");
  const std::vector<float> poses = floatsOf(player["body"]["poses"]);
  const std::vector<float> truth = floatsOf(player["truth"]["points"]);
  const size_t links = player["body"]["parents"].size(), points = player["truth"]["count"];
  ASSERT_EQ(poses.size(), 7 * links * size_t(kFrames));
  ASSERT_EQ(truth.size(), 3 * points * size_t(kFrames));
  for (size_t f = 0; f < size_t(kFrames); ++f)  // link 0 and point 0 are the pelvis
    if (f == 12)
      EXPECT_TRUE(std::isnan(poses[7 * links * f]));
    else
      EXPECT_NEAR(poses[7 * links * f + 2] - truth[3 * points * f + 2],
                  f >= 20 && f < 23 ? 0.4 : 0.1, 1e-5);
  EXPECT_EQ(player["cameras"].size(), 4u);
  EXPECT_GE(player["views"].size(), 3u);
  std::map<std::string, Json> events;
  for (const Json& event : player["events"]) events[event["what"]] = event;
  ASSERT_EQ(events.count("no pose"), 1u);
  EXPECT_EQ(events["no pose"]["frame"], 12);
  EXPECT_EQ(events["no pose"]["frames"], 1);
  EXPECT_EQ(events["no pose"]["why"], "nobody is there");
  EXPECT_EQ(events["left_arm far off"]["frame"], 20);
  EXPECT_EQ(events["left_arm far off"]["frames"], 3);
  EXPECT_EQ(events["worst frame"]["why"], "D = 400 mm");
}

TEST_F(EvaluationTest, WithoutExactMasksJointsAreJudgedAndANoteSaysSo) {
  writeTruth("world", false);
  writeResults(nothing);
  const Evaluation found = judged();
  EXPECT_LT(found.joints.D_spread.max, kSameTransforms_mm);
  EXPECT_EQ(found.notes,
            std::vector<std::string>{"Silhouettes and hull are not evaluated: the ground truth "
                                     "has no exact masks."});
}

TEST_F(EvaluationTest, FaultsAreOneSentenceEach) {
  EXPECT_EQ(errorTextOf<std::exception>([&] { judged(); }), "there is no bag " + request_.truth);
  writeResults(nothing);
  request_.truth = request_.results;
  EXPECT_EQ(errorTextOf<std::exception>([&] { judged(); }),
            request_.results + " has no ground truth: no topic /ground_truth/joints");
  request_.truth = path("truth.bag");
  writeTruth();
  request_.results = request_.truth;
  EXPECT_EQ(errorTextOf<std::exception>([&] { judged(); }),
            request_.truth + " has no results: neither a frame body_<id> in tf nor /pose");
  request_.results = path("results.bag");
  request_.body_id = "person2";
  EXPECT_EQ(errorTextOf<std::exception>([&] { judged(); }),
            request_.results + " has no body person2, it has person1");
}

TEST_F(EvaluationTest, OtherWorldsAndOtherTimesAreRefused) {
  writeTruth();
  writeResults(nothing, "map");
  EXPECT_EQ(errorTextOf<std::exception>([&] { judged(); }),
            "the results are in the frame map, the ground truth in world: they cannot be compared");
  writeResults(nothing, "world", 3600 * int64_t(1000000000));
  EXPECT_EQ(errorTextOf<std::exception>([&] { judged(); })
                .rfind("ground truth and results do not overlap in time: the "
                       "ground truth lasts from 1600000000.00 s to "
                       "1600000001.56 s, the results from 16000036",
                       0),
            0u);
}

}  // namespace
}  // namespace markerless_mocap
