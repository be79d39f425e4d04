#include "contour/model/contour_body.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "body/body_fixture.h"
#include "contour/drawn_body.h"
#include "contour/model/contour_kinematics.h"
#include "contour/model/normal_equations.h"
#include "error_text_of.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {
namespace {

ShapeParameters plainSizes() {
  return ShapeStatistics::handMade().meanShape(1.75);
}

TEST(ContourPose, StepsLeadFromPoseToPose) {
  const ContourPose from = stride(), to = disturbed(from, 0.5, 0.2, 3);
  const ContourPose there = boxPlus(from, boxMinus(to, from));
  EXPECT_LT(boxMinus(there, to).norm(), 1e-12);
  EXPECT_LT(boxMinus(boxPlus(from, PoseIncrement::Zero()), from).norm(), 1e-12);
}

TEST(ContourPose, TurnsByItsVector) {
  const Eigen::Matrix3d R = expSO3({0, 0, M_PI / 2});
  EXPECT_TRUE((R * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_TRUE(logSO3(expSO3({0.3, -2.0, 1.5})).isApprox(Eigen::Vector3d(0.3, -2.0, 1.5), 1e-9));
  EXPECT_EQ(logSO3(Eigen::Matrix3d::Identity()), Eigen::Vector3d::Zero());
}

TEST(ContourBody, StandsAsTheUrdfDoes) {
  const ShapeParameters shape = plainSizes();
  const BodyModel urdf = human(proportionsOf(shape));
  LinkPoses T_world_link;
  urdf.forwardKinematics(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(urdf.angleCount()),
                         T_world_link);
  const auto markers = markerPositions(urdf, T_world_link);
  const Eigen::Matrix3Xd points = ContourBody(shape).points(ContourPose());
  ASSERT_EQ(size_t(points.cols()), contourPointNames().size());
  for (size_t i = 0; i < markers.size(); ++i)
    EXPECT_LT((points.col(Eigen::Index(i)) - markers[i]).norm(), 0.002) << markerNames()[i];
}

TEST(ContourBody, LimbsEndAtTheirLastJoints) {
  const auto name = [](ContourLimb::Id limb) { return contourPointNames()[endOfLimb(limb)]; };
  EXPECT_EQ(name(ContourLimb::kHead), "head");
  EXPECT_EQ(name(ContourLimb::kLeftArm), "l_wrist");
  EXPECT_EQ(name(ContourLimb::kRightArm), "r_wrist");
  EXPECT_EQ(name(ContourLimb::kLeftLeg), "l_ankle");
  EXPECT_EQ(name(ContourLimb::kRightLeg), "r_ankle");
}

TEST(ContourBody, MirrorsRightFromLeft) {
  ContourFrames frames;
  ContourWorldCones cones;
  ShapeParameters shape = plainSizes();
  shape[offsetIndex(BodyCone::kThigh, 1)] = 0.02;
  shape[offsetIndex(BodyCone::kThigh, 1) + 1] = 0.01;
  const ContourBody body(shape);
  body.place(ContourPose(), frames);
  body.place(frames, cones);
  const auto& cone_facts = contourKinematicTree().cones;
  for (int c = 0; c + 1 < kContourCones; ++c) {
    if (cone_facts[size_t(c)].kind != cone_facts[size_t(c) + 1].kind) continue;
    const Eigen::Vector3d mirror(1, -1, 1);
    EXPECT_LT((cones[size_t(c)].a.cwiseProduct(mirror) - cones[size_t(c) + 1].a).norm(), 1e-12);
    EXPECT_LT((cones[size_t(c)].b.cwiseProduct(mirror) - cones[size_t(c) + 1].b).norm(), 1e-12);
  }
}

TEST(ContourBody, DerivativesByPoseAreThoseOfDifferences) {
  const ContourBody body(plainSizes());
  const ContourPose pose = stride();
  ContourFrames frames;
  body.place(pose, frames);
  const auto& points = contourKinematicTree().points;
  for (size_t i = 0; i < points.size(); ++i) {
    Eigen::Matrix<double, 3, kContourDof> J;
    const Eigen::Vector3d at = body.points(pose).col(Eigen::Index(i));
    poseJacobian(frames, points[i].segment, at, J);
    for (int dof = 0; dof < kContourDof; ++dof) {
      const PoseIncrement step = 1e-5 * PoseIncrement::Unit(dof);
      const Eigen::Vector3d difference = (body.points(boxPlus(pose, step)).col(Eigen::Index(i)) -
                                          body.points(boxPlus(pose, -step)).col(Eigen::Index(i))) /
                                         2e-5;
      EXPECT_LT((J.col(dof) - difference).norm(), 1e-6) << i << " by " << dof;
    }
  }
}

TEST(ContourBody, EquationsOfThePoseAreThoseOfAllDerivatives) {
  const ContourBody body(plainSizes());
  ContourFrames frames;
  ContourWorldCones cones;
  body.place(disturbed(stride(), 0.3, 0.1, 5), frames);
  body.place(frames, cones);
  AllConeNormalEquations sums;
  PoseNormalEquations equations, expected;
  equations.clear();
  expected.clear();
  for (size_t c = 0; c < kContourCones; ++c) {
    for (int i = 0; i < 5; ++i) {
      const double u[4] = {0.3 * i - 0.5, 0.2 + 0.1 * double(c), 0.4 - 0.2 * i, i % 2 ? -1.0 : 1.0};
      sums[c].add(0.2 * i, u, 0.01 * i - 0.03, 1.0 + i);
    }
    Eigen::Matrix<double, 8, kContourDof> J = Eigen::Matrix<double, 8, kContourDof>::Zero();
    const int segment = contourKinematicTree().cones[c].ends[0].segment;
    poseJacobian(frames, segment, cones[c].a, J.topRows<3>());
    poseJacobian(frames, segment, cones[c].b, J.middleRows<3>(4));
    expected.H += J.transpose() * sums[c].hessian() * J;
    expected.g += J.transpose() * sums[c].gradient();
  }
  accumulatePoseEquations(sums, frames, cones, equations);
  EXPECT_TRUE(equations.H.isApprox(expected.H, 1e-12));
  EXPECT_TRUE(equations.g.isApprox(expected.g, 1e-12));
}

TEST(ContourBody, DerivativesBySizesAreThoseOfDifferences) {
  const ShapeParameters shape = plainSizes();
  const ContourPose pose = stride();
  ContourFrames frames;
  ContourBody(shape).place(pose, frames);
  const auto place = [&](const ShapeParameters& s, size_t cone, int end) {
    ContourFrames moved_frames;
    ContourWorldCones cones;
    const ContourBody body(s);
    body.place(pose, moved_frames);
    body.place(moved_frames, cones);
    return end ? cones[cone].b : cones[cone].a;
  };
  for (size_t c = 0; c < kContourCones; ++c)
    for (int end = 0; end < 2; ++end) {
      Eigen::Matrix<double, 3, kShapeParameterCount> J;
      shapeJacobian(frames, contourKinematicTree().cones[c].ends[end], J);
      for (int i = 0; i < kShapeParameterCount; ++i) {
        const ShapeParameters step = 1e-4 * ShapeParameters::Unit(i);
        const Eigen::Vector3d difference =
            (place(shape + step, c, end) - place(shape - step, c, end)) / 2e-4;
        EXPECT_LT((J.col(i) - difference).norm(), 1e-9) << shapeParameterName(i);
      }
    }
}

TEST(ContourBody, RefusesSizesThatNoBodyHas) {
  ShapeParameters shape = plainSizes();
  shape[BodyLength::kThigh] = 0;
  EXPECT_EQ(errorTextOf([&] { ContourBody body(shape); }),
            "shape parameter thigh of a body is 0.000000, it must be finite and positive");
}

TEST(ShapeStatistics, ReadsWhatItWrites) {
  const ShapeStatistics made = ShapeStatistics::handMade();
  const ShapeStatistics read = ShapeStatistics::fromYaml(made.text(), "file");
  EXPECT_LT((read.mean - made.mean).cwiseAbs().maxCoeff(), 6e-6);
  EXPECT_LT((read.deviation - made.deviation).cwiseAbs().maxCoeff(), 6e-6);
  EXPECT_NEAR(made.meanShape(1.8)[BodyLength::kThigh], 1.8 * 0.245, 1e-12);
}

TEST(ShapeStatistics, IsTheMeanOfPeople) {
  const ShapeParameters one = ShapeStatistics::handMade().meanShape(1.6);
  ShapeParameters other = ShapeStatistics::handMade().meanShape(1.8);
  const int offset = offsetIndex(BodyCone::kChest, 1) + 1, thigh = BodyLength::kThigh;
  other[offset] += 1.8 * 0.01;
  const ShapeStatistics both = ShapeStatistics::fromPeople({one, other}, {1.6, 1.8});
  EXPECT_NEAR(both.mean[thigh], 0.245, 1e-12);
  EXPECT_NEAR(both.deviation[thigh], 0.05 * 0.245, 1e-12);
  EXPECT_NEAR(both.mean[offset], one[offset] / 1.6 + 0.005, 1e-12);
  EXPECT_NEAR(both.deviation[offset], std::hypot(2 * 0.005, 0.002), 1e-12);
  EXPECT_EQ(both.deviation[offsetIndex(BodyCone::kNeck, 0) + 1], 0);
  EXPECT_THROW(ShapeStatistics::fromPeople({one}, {1.6, 1.8}), std::invalid_argument);
}

TEST(ShapeStatistics, SaysWhatIsWrongWithAFile) {
  std::string text = ShapeStatistics::handMade().text();
  EXPECT_EQ(errorTextOf([&] { ShapeStatistics::fromYaml(text + "tail: [1, 0]\n", "f"); }),
            "f has the unknown shape parameter tail");
  EXPECT_EQ(errorTextOf([&] { ShapeStatistics::fromYaml(text + "thigh: [0.2, 0]\n", "f"); }),
            "f gives twice the shape parameter thigh");
  EXPECT_EQ(errorTextOf([] { ShapeStatistics::fromYaml("torso: [0.3, 0]", "f"); }),
            "f lacks the shape parameter neck");
  EXPECT_EQ(errorTextOf([] { ShapeStatistics::fromYaml("[", "f"); }).substr(0, 13),
            "f is not YAML");
  const size_t at = text.find("thigh: [0.24500");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(errorTextOf([&] {
              ShapeStatistics::fromYaml(std::string(text).replace(at, 15, "thigh: [-0.2450"), "f");
            }),
            "f: shape parameter thigh must be positive");
  EXPECT_THROW(ShapeStatistics::handMade().meanShape(3.0), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
