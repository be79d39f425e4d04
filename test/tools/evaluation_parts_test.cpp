#include "tools/evaluate/evaluation_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "error_text_of.h"
#include "pages/page_reader.h"
#include "tools/evaluate/evaluation_json.h"
#include "tools/evaluate/evaluation_page.h"
#include "tools/evaluate/evaluation_table.h"
#include "tools/evaluation_fixture.h"

namespace markerless_mocap {
namespace {

constexpr double kPitch = 0.05;

/// Segmented hulls that know the truth but for a change.
class EvaluationPartsTest : public EvaluationTest {
 protected:
  using PartsChange = std::function<void(int frame, BodyParts* parts)>;

  EvaluationPartsTest() { request_.images = false; }

  Eigen::Matrix3Xd groundTruthPoints(int frame) const {
    const Eigen::Matrix3Xd all = bodyPoints(model_, linksOf(poseOf(frame)));
    const std::vector<std::string> names = bodyPointNames();
    Eigen::Matrix3Xd points(3, Eigen::Index(partTruthNames().size()));
    for (size_t i = 0; i < partTruthNames().size(); ++i)
      points.col(Eigen::Index(i)) =
          all.col(std::find(names.begin(), names.end(), partTruthNames()[i]) - names.begin());
    return points;
  }

  /// The voxels within 8 cm of the body's points, labelled as the truth says.
  void segment(int frame, PipelineResult* result) const {
    const Eigen::Matrix3Xd points = groundTruthPoints(frame);
    const PartTruth truth(points);
    const Eigen::Vector3d low = points.rowwise().minCoeff() - Eigen::Vector3d::Constant(0.2);
    VisualHull& hull = result->hull;
    hull.lattice = {kPitch * (low / kPitch).array().floor().matrix(), kPitch, {50, 50, 50}};
    for (uint32_t index = 0; index < hull.lattice.count(); ++index) {
      const Eigen::Vector3d at = hull.lattice.center(index);
      if ((points.colwise() - at).colwise().norm().minCoeff() > 0.08) continue;
      HullVoxel voxel;
      voxel.index = index;
      hull.voxels.push_back(voxel);
      result->parts.labels.push_back(truth.partAt(at));
    }
    result->parts.status = SegmentationStatus::kOk;
    PartCurve& arm = result->parts.parts[size_t(PartLabel::kArm1)];
    arm.seen = true;
    arm.points = {points.col(5), points.col(6)};  // elbow and wrist
    arm.site_values = {0.0, 1.0};
  }

  void writeParts(const PartsChange& change, const std::string& world = "world") const {
    writeStages(
        [&](int frame, PipelineResult* result) {
          segment(frame, result);
          change(frame, &result->parts);
        },
        world);
  }
};

TEST_F(EvaluationPartsTest, TruthAsPartsIsPerfectThroughTheBag) {
  writeParts([](int, BodyParts*) {});
  const Evaluation found = judged();
  ASSERT_TRUE(found.parts);
  const PartErrors& errors = found.parts->errors;
  EXPECT_EQ(errors.all.frames, size_t(kFrames));
  EXPECT_EQ(errors.fraction_valid, 1.0);
  // Centres go through the bag as float32: one on a border may change sides.
  EXPECT_GT(errors.all.fraction_correct, 0.999);
  EXPECT_EQ(errors.all.fraction_all_six, 1.0);
  EXPECT_LT(errors.arms_mm.max, 1e-3);
  EXPECT_EQ(found.parts->status_counts, (std::map<std::string, size_t>{{"ok", kFrames}}));
}

TEST_F(EvaluationPartsTest, CountsWrongAndPartialHullsApart) {
  writeParts([](int f, BodyParts* parts) {
    if (f >= 10) return;  // 10 of 40 frames: a leg is an arm
    for (uint8_t& label : parts->labels) label = label == 2 ? 4 : label == 4 ? 2 : label;
    if (f >= 4) return;
    parts->status = SegmentationStatus::kPartial;
    parts->reason = "arm 2 not seen";
  });
  const Evaluation found = judged();
  ASSERT_TRUE(found.parts);
  const PartErrors& errors = found.parts->errors;
  EXPECT_NEAR(errors.fraction_valid, 36.0 / 40.0, 1e-12);
  EXPECT_NEAR(errors.all.fraction_all_six, 30.0 / 40.0, 1e-12);
  EXPECT_NEAR(errors.valid.fraction_all_six, 30.0 / 36.0, 1e-12);
  EXPECT_EQ(found.parts->reasons[0], "arm 2 not seen");
  std::ostringstream table;
  printEvaluation(found, table);
  EXPECT_NE(table.str().find("90.0 %   (36 ok, 4 partial)"), std::string::npos) << table.str();
  EXPECT_NE(evaluationJson(found).find("\"body_segmentation\""), std::string::npos);
  EXPECT_TRUE(hasPart(contentOf(evaluationPage(found)), "Body parts", "bands"));
}

TEST_F(EvaluationPartsTest, RefusesAnotherWorld) {
  writeParts([](int, BodyParts*) {});
  const PartsRecord record = readParts(request_.results);
  ASSERT_EQ(record.hulls.size(), size_t(kFrames));
  EXPECT_EQ(record.hulls[0].pitch, kPitch);
  const std::string sentence =
      errorTextOf<std::runtime_error>([&] { evaluateParts(JointTrack(), "map", record, 1); });
  EXPECT_EQ(sentence,
            "the segmented hulls are in the frame world, the ground truth in map: they cannot be "
            "compared");
}

}  // namespace
}  // namespace markerless_mocap
