#include "tools/evaluate/evaluation_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>

#include "error_text_of.h"
#include "markerless_mocap/camera/rig_file.h"
#include "tools/evaluation_fixture.h"

namespace markerless_mocap {
namespace {

constexpr double kNoise_px = 0.2;  // of images of 80 x 60 pixels

/// Marks with known noise on a person whom a tracker knows but for a change.
class EvaluationMarksTest : public EvaluationTest {
 protected:
  using Marks = std::map<std::string, std::map<std::string, Eigen::Vector2d>>;  // [camera][name]
  using MarkChange = std::function<void(int frame, Marks* marks)>;

  static void asTheyAre(int, Marks*) {}

  Marks marksOf(int frame) {
    const std::vector<std::string> names = bodyPointNames();
    const Eigen::Matrix3Xd points = bodyPoints(model_, linksOf(poseOf(frame)));
    std::normal_distribution<double> noise(0.0, kNoise_px);
    Marks marks;
    for (const Camera& camera : rig_)
      for (size_t i = 0; i < names.size(); ++i)
        if (const auto pixel = camera.projectInside(points.col(long(i)))) {
          const Eigen::Vector2d mark = *pixel + Eigen::Vector2d(noise(random_), noise(random_));
          if (mark.minCoeff() >= 0.0 && mark.x() < camera.width() - 1.0 &&
              mark.y() < camera.height() - 1.0)
            marks[camera.name()][names[i]] = mark;
        }
    return marks;
  }

  void writeMarks(const MarkChange& change) {
    std::ofstream file(path("marks.yaml"));
    file << "sigma_px: " << kNoise_px << "\nframes:\n";
    for (const int frame : {0, 10, 20, 30}) {
      Marks marks = marksOf(frame);
      change(frame, &marks);
      file << "- time: " << double(frame * kStep) * 1e-9 << "\n  marks:\n";
      for (const auto& [camera, points] : marks) {
        file << "    " << camera << ":\n";
        for (const auto& [name, pixel] : points)
          file << "      " << name << ": [" << pixel.x() << ", " << pixel.y() << "]\n";
      }
    }
  }

  MarksEvaluation judgedByMarks() const {
    std::vector<CameraCalibration> rig;
    for (const Camera& camera : rig_) rig.push_back(camera.calibration());
    writeRig(path("rig.yaml"), rig);
    return evaluateMarks(request_.results, "", path("marks.yaml"), path("rig.yaml"));
  }

  std::string errorOf(const std::string& text) const {
    std::ofstream(path("marks.yaml")) << text;
    return errorTextOf([&] { judgedByMarks(); });
  }

  std::mt19937 random_{7};
};

TEST_F(EvaluationMarksTest, TruthIsAsFarOffAsTheMarksAreSaidToBe) {
  writeMarks(asTheyAre);
  writeResults(nothing);
  const MarksEvaluation judged = judgedByMarks();
  EXPECT_TRUE(judged.marks.disagreements.empty());
  EXPECT_EQ(judged.frames_with_pose, 4u);
  EXPECT_LT(judged.D_mm.mean, 1.5 * judged.marks.sigma_mm);
  EXPECT_GT(judged.D_mm.mean, 0.5 * judged.marks.sigma_mm);
  EXPECT_EQ(judged.arms_exchanged + judged.legs_exchanged, 0u);
}

TEST_F(EvaluationMarksTest, PoseThatIsOffIsOffByThatMuch) {
  writeMarks(asTheyAre);
  writeResults([](int, BodyPose* pose) { pose->T_world_body.translation().x() += 0.3; });
  EXPECT_NEAR(judgedByMarks().D_mm.mean, 300.0, 15.0);
}

TEST_F(EvaluationMarksTest, FrameWithoutAPoseIsNotJudgedByItsNeighbour) {
  writeMarks(asTheyAre);
  writeResults([](int frame, BodyPose* pose) {
    if (frame == 10) pose->status = PoseStatus::kLost;
  });
  EXPECT_EQ(judgedByMarks().frames_with_pose, 3u);
}

TEST_F(EvaluationMarksTest, MarkOnTheWrongSideIsNamedAndLeftOut) {
  const std::string camera = rig_[1].name();
  writeMarks([&](int frame, Marks* marks) {
    if (frame == 20) std::swap((*marks)[camera]["l_wrist"], (*marks)[camera]["r_wrist"]);
  });
  writeResults(nothing);
  const MarksEvaluation judged = judgedByMarks();
  ASSERT_EQ(judged.marks.disagreements.size(), 2u);
  EXPECT_NE(judged.marks.disagreements[0].find("l_wrist in " + camera), std::string::npos);
  EXPECT_NE(judged.marks.disagreements[1].find("r_wrist in " + camera), std::string::npos);
  EXPECT_LT(judged.D_mm.max, 2.0 * judged.marks.sigma_mm);
}

TEST_F(EvaluationMarksTest, MarkOnAnotherPersonIsNamed) {
  const std::string camera = rig_[2].name();
  writeMarks([&](int frame, Marks* marks) {
    if (frame == 0) (*marks)[camera]["head"] = Eigen::Vector2d(3, 3);
  });
  writeResults(nothing);
  const MarksEvaluation judged = judgedByMarks();
  ASSERT_EQ(judged.marks.disagreements.size(), 1u);
  EXPECT_NE(judged.marks.disagreements[0].find("head in " + camera), std::string::npos);
}

TEST_F(EvaluationMarksTest, CamerasWithoutMarksAreNoLoss) {
  writeMarks([&](int, Marks* marks) { marks->erase(rig_[3].name()); });
  writeResults(nothing);
  const MarksEvaluation judged = judgedByMarks();
  EXPECT_EQ(judged.frames_with_pose, 4u);
  EXPECT_LT(judged.D_mm.mean, 1.5 * judged.marks.sigma_mm);
}

TEST_F(EvaluationMarksTest, BadFilesAreNamedInOneSentence) {
  writeResults(nothing);
  EXPECT_NE(errorOf("frames: []").find("has no frames"), std::string::npos);
  EXPECT_NE(errorOf("frames: [{time: 0, marks: {c: {nose: [1, 2]}}}]")
                .find("marks, c: key 'nose' is unknown"),
            std::string::npos);
  EXPECT_NE(errorOf("frames: [{time: 0, marks: {c: {head: [1]}}}]")
                .find("'head' has 1 numbers, wanted are 2: [u, v] in pixels"),
            std::string::npos);
  EXPECT_NE(errorOf("frames: [{time: 0, marks: {c: {head: [1, 2]}}}]").find("not in the rig"),
            std::string::npos);
  EXPECT_NE(errorOf("? [a, b]\n: 1").find("has a key that is no name"), std::string::npos);
  EXPECT_NE(errorOf("frames: [{time: 0, marks: {? [c] : {head: [1, 2]}}}]")
                .find("frame 1, marks: this has a key that is no name"),
            std::string::npos);
  EXPECT_NE(errorOf("frames: [").find("is no YAML"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
