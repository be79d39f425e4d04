#include "exports/motion_description.h"

#include "capture/truth/body_retargeter.h"
#include "exports/export_fixture.h"
#include "motion/gait/gait_path.h"
#include "motion/gait/gait_steps.h"
#include "motion/motion_script.h"

namespace markerless_mocap {
namespace {

constexpr double kFps = 60.0;

/// The studio's person walks; the plan of its steps is the truth.
class StudioWalk {
 public:
  explicit StudioWalk(const MotionScript& script)
      : skeleton_(HumanSkeleton::adult(1.75, 0.5)),
        plan_(planGait(script, GaitPath(script, 120.0), skeleton_)),
        body_(std::make_shared<const BodyModel>(human(proportionsOf(skeleton_)))) {
    BodyRetargeter retargeter(body_, skeleton_);
    const MotionClip clip = performMotion(script, skeleton_, kFps);
    std::vector<PersonFrame> frames;
    for (const HumanPose& pose : clip.poses) {
      const BodyState state = retargeter.follow(pose);
      PersonFrame frame;
      frame.stamp_ns = kStart + std::llround(1e9 / kFps * double(frames.size()));
      body_->forwardKinematics(state.T_world_body, state.angles, frame.T_world_link);
      frame.part_sigma_m.fill(0.006);
      frames.push_back(frame);
    }
    motion_ = personMotion(body_, frames);
  }

  const PersonMotion& motion() const { return motion_; }
  const GaitPlan& plan() const { return plan_; }
  const BodyModel& body() const { return *body_; }

 private:
  HumanSkeleton skeleton_;
  GaitPlan plan_;
  std::shared_ptr<const BodyModel> body_;
  PersonMotion motion_;
};

MotionScript straight() {
  return parseMotionScript(
      "{seconds: 7, start: {x: -2, heading: 0, width: 0.09}, path: [{stand: 1}, {go: 4.5, seconds: "
      "4}], tracks: {}}",
      "straight");
}

MotionScript circle() {
  return readMotionScript(MOCAP_SOURCE_DIR "/config/motions/walk_in_circle.yaml");
}

/// Length and width of a planned step, as Step defines them.
Eigen::Vector2d planned(const GaitPlan& plan, size_t index) {
  const GaitStep& step = plan.steps[index];
  Eigen::Vector2d other = (step.left ? plan.right_start : plan.left_start).position;
  for (size_t i = 0; i < index; ++i)
    if (plan.steps[i].left != step.left) other = plan.steps[i].to.position;
  const Eigen::Vector2d along = (step.to.position - step.from.position).normalized();
  const Eigen::Vector2d offset = step.to.position - other;
  const double left = Eigen::Vector2d(-along.y(), along.x()).dot(offset);
  return {along.dot(offset), step.left ? left : -left};
}

/// Planned steps that are strides of more than the least one.
std::vector<size_t> plannedSteps(const GaitPlan& plan) {
  std::vector<size_t> out;
  for (size_t i = 0; i < plan.steps.size(); ++i)
    if ((plan.steps[i].to.position - plan.steps[i].from.position).norm() >= kMinStride_m)
      out.push_back(i);
  return out;
}

class Walks : public ::testing::TestWithParam<MotionScript (*)()> {};

TEST_P(Walks, StepsAreThoseOfThePlan) {
  const StudioWalk walk(GetParam()());
  const std::vector<Step> steps = stepsOf(walk.motion());
  const std::vector<size_t> wanted = plannedSteps(walk.plan());
  ASSERT_EQ(steps.size(), wanted.size());
  for (size_t i = 0; i < steps.size(); ++i) {
    const GaitStep& truth = walk.plan().steps[wanted[i]];
    const Eigen::Vector2d place = planned(walk.plan(), wanted[i]);
    EXPECT_EQ(steps[i].left, truth.left) << i;
    EXPECT_NEAR(steps[i].seconds, truth.land, 0.06) << i;
    EXPECT_NEAR(steps[i].length_m.value, place.x(), 0.02) << i;
    EXPECT_NEAR(steps[i].width_m.value, place.y(), 0.02) << i;
  }
}

TEST_P(Walks, ContactLastsUntilThePlanLiftsTheFoot) {
  const StudioWalk walk(GetParam()());
  const std::vector<Step> steps = stepsOf(walk.motion());
  const std::vector<size_t> wanted = plannedSteps(walk.plan());
  ASSERT_EQ(steps.size(), wanted.size());
  size_t compared = 0;
  for (size_t i = 0; i < steps.size(); ++i)
    for (size_t next = wanted[i] + 1; next < walk.plan().steps.size(); ++next) {
      if (walk.plan().steps[next].left != steps[i].left) continue;
      const double truth = walk.plan().steps[next].lift - walk.plan().steps[wanted[i]].land;
      EXPECT_NEAR(steps[i].contact_s.value, truth, 0.1) << i;
      ++compared;
      break;
    }
  EXPECT_GE(compared + 2, steps.size());
}

INSTANTIATE_TEST_SUITE_P(Studio, Walks, ::testing::Values(&straight, &circle));

TEST(Description, CadenceIsThatOfThePlan) {
  const StudioWalk walk(straight());
  const MotionDescription out = describe(walk.motion());
  const auto& steps = walk.plan().steps;
  const double truth = 60.0 * double(steps.size() - 1) / (steps.back().land - steps.front().land);
  EXPECT_NEAR(out.cadence_per_min.mean, truth, 3.0);
  EXPECT_NEAR(out.seconds, 7.0, 0.02);
  EXPECT_EQ(out.frames, out.frames_with_pose);
}

TEST(Description, ErrorsAreCarriedThrough) {
  const StudioWalk walk(straight());
  const MotionDescription out = describe(walk.motion());
  const double along_axis = 0.006 / std::sqrt(3.0);
  EXPECT_NEAR(out.length_m.error, std::sqrt(2.0) * along_axis, 1e-9);
  EXPECT_NEAR(out.steps[0].width_m.error, std::sqrt(2.0) * along_axis, 1e-9);
  const double landing = std::hypot(1.0 / kFps / std::sqrt(12.0), along_axis / 0.15);
  EXPECT_NEAR(out.steps[1].contact_s.error, std::sqrt(2.0) * landing, 1e-6);
  for (const JointRange& range : out.ranges)
    if (range.joint == "l_knee") {
      // The ankle is 0.43 m from the knee.
      const double error = std::sqrt(2.0) * along_axis / 0.43 * 180.0 / M_PI;
      EXPECT_NEAR(range.range_deg.error, error, 0.05 * error);
    }
}

TEST(Description, UnknownErrorsStayUnknown) {
  PersonMotion motion = StudioWalk(straight()).motion();
  for (PersonFrame& frame : motion.frames) frame.part_sigma_m.fill(NAN);
  const MotionDescription out = describe(motion);
  EXPECT_GT(out.length_m.count, 4u);
  EXPECT_TRUE(std::isnan(out.length_m.error));
  EXPECT_TRUE(std::isnan(out.lean.forward.error));
}

TEST(Description, FootThatIsNotSeenGivesNoStep) {
  const StudioWalk walk(straight());
  PersonMotion motion = walk.motion();
  const size_t whole = stepsOf(motion).size();
  const size_t ankle = size_t(walk.body().linkIndex("l_ankle"));
  for (PersonFrame& frame : motion.frames) frame.T_world_link[ankle].matrix().setConstant(NAN);
  EXPECT_EQ(stepsOf(motion).size(), 0u);
  EXPECT_GT(whole, 4u);
}

using Ranges = MovingPerson;

TEST_F(Ranges, AreThoseOfTheAngles) {
  std::vector<PersonFrame> all;
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(body_->angleCount());
  for (int f = 0; f < 1001; ++f) {
    angles[body_->angleIndex("r_elbow")] = 0.4 + 0.8 * f / 1000.0;
    angles[body_->angleIndex("waist")] = 0.2;
    PersonFrame frame = frameAt(f);
    body_->forwardKinematics(Eigen::Isometry3d::Identity(), angles, frame.T_world_link);
    all.push_back(frame);
  }
  const MotionDescription out = describe(personMotion(body_, all));
  for (const JointRange& range : out.ranges) {
    const bool elbow = range.joint == "r_elbow";
    EXPECT_NEAR(range.range_deg.value, elbow ? 0.98 * 0.8 * 180 / M_PI : 0.0, 1e-4) << range.joint;
  }
  // The trunk bends at 0.3 of its length.
  const double up = 0.3 + 0.7 * std::cos(0.2), forward = 0.7 * std::sin(0.2);
  EXPECT_NEAR(out.lean.forward.mean, std::atan2(forward, up) * 180 / M_PI, 1e-6);
  EXPECT_NEAR(out.lean.left.mean, 0.0, 1e-9);
}

TEST_F(Ranges, LeanIsSeenFromWhereThePersonFaces) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(body_->angleCount());
  angles[body_->angleIndex("r_waist")] = 0.3;
  Eigen::Isometry3d T_world_root = Eigen::Isometry3d::Identity();
  T_world_root.rotate(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ()));
  PersonFrame frame = frameAt(0);
  body_->forwardKinematics(T_world_root, angles, frame.T_world_link);
  const TrunkLean lean = trunkLean(personMotion(body_, {frame}));
  EXPECT_NEAR(lean.forward.mean, 0.0, 1e-6);
  EXPECT_LT(lean.left.mean, -5.0) << "a positive turn about x leans to the right";
}

}  // namespace
}  // namespace markerless_mocap
