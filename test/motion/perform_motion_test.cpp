#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "motion/motion_measures.h"
#include "motion/motion_script.h"

namespace markerless_mocap {
namespace {

struct Person {
  double stature, male;
};

std::vector<std::string> motionNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(MOCAP_SOURCE_DIR "/config/motions"))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

MotionScript scriptNamed(const std::string& name) {
  return readMotionScript(MOCAP_SOURCE_DIR "/config/motions/" + name + ".yaml");
}

class EveryMotion : public testing::TestWithParam<std::string> {};

TEST_P(EveryMotion, looksRightOnPeopleOfAllSizes) {
  const MotionScript script = scriptNamed(GetParam());
  EXPECT_GE(script.seconds, 5.0);
  EXPECT_LE(script.seconds, 26.0);
  for (const Person& who : {Person{1.5, 0.0}, Person{1.75, 0.5}, Person{1.95, 1.0}}) {
    SCOPED_TRACE(who.stature);
    const HumanSkeleton skeleton = HumanSkeleton::adult(who.stature, who.male);
    const MotionClip clip = performMotion(script, skeleton);
    EXPECT_NEAR(clip.duration(), script.seconds, 0.005);
    const MotionMeasures m = measure(clip, skeleton);
    EXPECT_LT(m.slide, 0.003);
    EXPECT_LT(m.sink, 0.003);
    EXPECT_LT(m.turn_speed, 16.0) << boneName(Bone(m.turn_bone)) << " at " << m.turn_time << " s";
    EXPECT_GT(m.feet_apart, 0.054 * who.stature) << "a shoe's width";
    EXPECT_GT(m.shanks_apart, 0.08);
    EXPECT_GT(m.bend_low, -0.01);
    EXPECT_LT(m.bend_high, 150.0 * M_PI / 180.0);
    EXPECT_GT(m.sign_jump, 0.98) << "successive quaternions lie side by side";
    EXPECT_LT(m.side, who.stature > 1.8 ? 1.45 : 1.35);
    EXPECT_LT(m.top, 1.26 * who.stature);
    if (GetParam() != "run_crouch_jump") {
      EXPECT_LT(m.lowest_rise, 0.002) << "a foot is down";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Config, EveryMotion, testing::ValuesIn(motionNames()),
                         [](const auto& info) { return info.param; });

TEST(PerformMotion, authorsAllMotionsOfTheStudies) {
  const std::vector<std::string> names = motionNames();
  for (const char* name :
       {"wave", "swing", "throw", "melee", "sit_couch", "look_out_door", "push_luggage", "walk",
        "lift_drop", "whirling_dance", "run_crouch_jump", "walk_spin", "walk_in_circle"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}

TEST(PerformMotion, repeatsItselfToTheBit) {
  const HumanSkeleton skeleton = HumanSkeleton::adult(1.7, 0.3);
  const MotionClip a = performMotion(scriptNamed("walk"), skeleton);
  const MotionClip b = performMotion(scriptNamed("walk"), skeleton);
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (size_t i = 0; i < a.poses.size(); ++i) {
    EXPECT_EQ(a.poses[i].hips, b.poses[i].hips);
    for (size_t k = 0; k < size_t(kBoneCount); ++k)
      EXPECT_EQ(a.poses[i].R_world_bone[k].coeffs(), b.poses[i].R_world_bone[k].coeffs());
  }
}

TEST(PerformMotion, standsStillFor1point7SecondsInTheCircle) {
  const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 1.0);
  const MotionClip clip = performMotion(scriptNamed("walk_in_circle"), skeleton);
  int still = 0, longest = 0;
  for (double t = 2.0; t < 9.0; t += 0.05) {
    const double speed = (clip.at(t + 0.05).hips - clip.at(t).hips).norm() / 0.05;
    still = speed < 0.15 ? still + 1 : 0;
    longest = std::max(longest, still);
  }
  EXPECT_GT(longest * 0.05, 1.5);
  EXPECT_LT(longest * 0.05, 1.9);
  for (double t = 1.5; t < 5.0; t += 0.5)
    EXPECT_NEAR(clip.at(t).hips.head<2>().norm(), 1.0, 0.08) << "on the circle at " << t;
}

TEST(PerformMotion, sitsAsHighAsTheCouchAndJumpsFreeOfTheFloor) {
  const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 1.0);
  const MotionClip sit = performMotion(scriptNamed("sit_couch"), skeleton);
  EXPECT_NEAR(sit.at(6.0).hips.z(), 0.42 + 0.09, 0.04);  // hip joints are above the seat
  const MotionClip jump = performMotion(scriptNamed("run_crouch_jump"), skeleton);
  EXPECT_GT(measure(jump, skeleton).lowest_rise, 0.15);
}

TEST(PerformMotion, followsAJumpAsGravityAllows) {
  const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 1.0);
  const MotionClip clip = performMotion(
      parseMotionScript("{seconds: 4, start: {}, path: [{stand: 1.5}, {jump: [0, 0], seconds: 0.4}"
                        "], tracks: {}}",
                        "jump"),
      skeleton);
  // Free fall while both feet are up: the second difference of the height is -g.
  const double h = 0.08;
  const double bend =
      (clip.at(1.7 - h).hips.z() - 2.0 * clip.at(1.7).hips.z() + clip.at(1.7 + h).hips.z()) /
      (h * h);
  EXPECT_NEAR(bend, -9.81, 0.6);
}

TEST(PerformMotion, refusesAnOddRate) {
  const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 1.0);
  EXPECT_THROW(performMotion(scriptNamed("wave"), skeleton, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
