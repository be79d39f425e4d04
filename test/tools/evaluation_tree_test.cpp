#include "tools/evaluate/evaluation_tree.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "pages/page_reader.h"
#include "tools/evaluate/evaluation_json.h"
#include "tools/evaluate/evaluation_page.h"
#include "tools/evaluate/evaluation_table.h"
#include "tools/evaluation_fixture.h"

namespace markerless_mocap {
namespace {

constexpr double kSameTree_mm = 1e-6;

/// Trees that know the truth but for a change.
class EvaluationTreeTest : public EvaluationTest {
 protected:
  using TreeChange = std::function<void(int frame, PoseTree* tree)>;

  EvaluationTreeTest() { request_.images = false; }

  PoseTree treeOf(int frame) const {
    const Eigen::Matrix3Xd points = bodyPoints(model_, linksOf(poseOf(frame)));
    const auto point = [&](const std::string& name) -> Eigen::Vector3d {
      const std::vector<std::string> names = bodyPointNames();
      return points.col(std::find(names.begin(), names.end(), name) - names.begin());
    };
    PoseTree tree;
    tree.status = TreeStatus::kOk;
    tree.validity = 0.9;
    const char* ends[] = {"head", "l_hand", "r_hand", "l_foot", "r_foot"};
    for (int i = 0; i < kExtremityCount; ++i) {
      tree.nodes.push_back({point(ends[i]), i - 1, TreePart::kNone});
      tree.extremities[size_t(i)] = {i, point(ends[i]), point(ends[i])};
    }
    for (int i = 0; i < kTreeJointCount; ++i) {
      const std::string name = toString(TreeJoint(i));
      tree.joints[size_t(i)] = point(name == "neck" ? "thorax" : name);
    }
    return tree;
  }

  void writeTrees(const TreeChange& change, const std::string& world = "world") const {
    writeStages(
        [&](int frame, PipelineResult* result) {
          result->tree = treeOf(frame);
          change(frame, &result->tree);
        },
        world);
  }
};

TEST_F(EvaluationTreeTest, TruthAsATreeIsPerfectThroughTheBag) {
  writeTrees([](int, PoseTree*) {});
  const Evaluation found = judged();
  ASSERT_TRUE(found.trees);
  EXPECT_EQ(found.trees->labels.frames, size_t(kFrames));
  EXPECT_EQ(found.trees->labels.fraction_valid, 1.0);
  EXPECT_EQ(found.trees->labels.fraction_correct, 1.0);
  EXPECT_LT(found.trees->labels.hands_mm.max, kSameTree_mm);
  EXPECT_EQ(found.trees->status_counts, (std::map<std::string, size_t>{{"ok", kFrames}}));
  ASSERT_EQ(found.trees->joints.size(), size_t(kTreeJointCount));
  for (const SummaryStatistics& error : found.trees->joint_errors_mm) {
    EXPECT_EQ(error.count, size_t(kFrames));
    EXPECT_LT(error.max, kSameTree_mm);
  }
}

TEST_F(EvaluationTreeTest, WrongAndInvalidTreesAreCountedApart) {
  writeTrees([](int f, PoseTree* tree) {
    if (f < 4) std::swap(tree->extremities[1], tree->extremities[2]);  // 4 of 40 frames
    if (f < 10) tree->joints[size_t(TreeJoint::kLeftElbow)].reset();
    if (f < 20) *tree->joints[size_t(TreeJoint::kRightKnee)] += Eigen::Vector3d(0.03, 0, 0.04);
    if (f >= 30) tree->status = TreeStatus::kUncertain, tree->reason = "who knows";
  });
  const TreeEvaluation trees = *judged().trees;
  EXPECT_NEAR(trees.labels.fraction_valid, 0.75, 1e-12);
  EXPECT_NEAR(trees.labels.fraction_correct, 0.9, 1e-12);
  EXPECT_NEAR(trees.labels.fraction_wrong_but_valid, 0.1, 1e-12);
  EXPECT_NEAR(trees.labels.fraction_sides_correct, 26.0 / 30, 1e-12);
  EXPECT_EQ(trees.status_counts.at("uncertain"), 10u);
  EXPECT_EQ(trees.reasons[35], "who knows");
  EXPECT_EQ(trees.joint_errors_mm[size_t(TreeJoint::kLeftElbow)].count, 20u);
  EXPECT_NEAR(trees.joint_errors_mm[size_t(TreeJoint::kRightKnee)].mean, 50.0 * 20 / 30,
              kSameTree_mm);
}

TEST_F(EvaluationTreeTest, TableJsonAndPageCarryTheFigures) {
  writeTrees([](int f, PoseTree* tree) {
    if (f < 4) std::swap(tree->extremities[3], tree->extremities[4]);
  });
  const Evaluation found = judged();
  std::ostringstream table;
  printEvaluation(found, table);
  EXPECT_NE(table.str().find("wrong but valid 10.0 %"), std::string::npos) << table.str();
  const Json json = Json::parse(evaluationJson(found))["pose_tree"];
  EXPECT_NEAR(json["fraction_wrong_but_valid"], 0.1, 1e-12);
  EXPECT_NEAR(json["precision_recall_area"], 0.9, 1e-9);
  EXPECT_EQ(json["frames_validity_right"][0][0], 40);
  EXPECT_NEAR(json["frames_validity_right"][0][2], 0.9, 1e-12);
  const Json content = contentOf(evaluationPage(found));
  EXPECT_TRUE(says(content, "10.0 % wrong but valid"));
  const Json run = partUnder(content, "Pose tree", "bands")["bands"][0]["runs"][0];
  EXPECT_EQ(run, Json::parse(R"([0, 4, 1, "wrong: left_foot right_foot"])"));
  EXPECT_TRUE(hasPart(content, "Precision and recall by the threshold of validity", "lines"));
  EXPECT_EQ(partUnder(content, "Calibration of the validity", "table")["rows"][0],
            Json::parse(R"(["40", "0.90", "0.90"])"));
}

TEST_F(EvaluationTreeTest, InstantsWithoutATreeAreMissing) {
  writeTrees([](int, PoseTree*) {});
  request_.truth = path("longer.bag");
  {
    rosbag::Bag from(path("truth.bag")), to(request_.truth, rosbag::bagmode::Write);
    for (const rosbag::MessageInstance& entry : rosbag::View(from)) {
      const auto joints = entry.instantiate<JointPositions>();
      if (!joints) continue;
      to.write(entry.getTopic(), entry.getTime(), *joints);
      JointPositions later = *joints;
      later.header.stamp += ros::Duration(kFrames * kStep * 1e-9);
      to.write(entry.getTopic(), later.header.stamp, later);
    }
  }
  const TreeEvaluation trees = *judged().trees;
  EXPECT_EQ(trees.status_counts.at("missing"), size_t(kFrames));
  EXPECT_EQ(trees.labels.fraction_valid, 0.5);
}

TEST_F(EvaluationTreeTest, ResultsWithoutTreesHaveNoSection) {
  writeTrees([](int, PoseTree*) {});
  {
    rosbag::Bag from(request_.results), to(path("other.bag"), rosbag::bagmode::Write);
    for (const rosbag::MessageInstance& entry : rosbag::View(from))
      if (entry.getTopic() != "/pose_tree") to.write(entry.getTopic(), entry.getTime(), entry);
  }
  request_.results = path("other.bag");
  const Evaluation found = judged();
  EXPECT_FALSE(found.trees);
  EXPECT_FALSE(hasPart(contentOf(evaluationPage(found)), "Pose tree", "bands"));
  EXPECT_EQ(evaluationJson(found).find("pose_tree"), std::string::npos);
}

TEST_F(EvaluationTreeTest, TreesInAnotherFrameAreRefused) {
  writeTrees([](int, PoseTree*) {});
  TreeRecord trees = readTrees(request_.results);
  trees.world_frame = "map";
  EXPECT_EQ(
      errorTextOf<std::runtime_error>([&] { evaluateTrees(trees.joints, "world", trees, 0); }),
      "the pose trees are in the frame map, the ground truth in world: they cannot be compared");
}

}  // namespace
}  // namespace markerless_mocap
