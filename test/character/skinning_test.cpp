#include <gtest/gtest.h>

#include "character/adult_character.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector3f;

const Character& person() {
  static const Character made = makeCharacter(CharacterOptions());
  return made;
}

HumanPose atRest() {
  HumanPose pose;
  pose.hips = person().skeleton.headOf(Bone::kHips);
  return pose;
}

void turn(HumanPose& pose, std::initializer_list<Bone> bones, double angle, const Vector3d& axis) {
  for (Bone bone : bones) pose[bone] = AngleAxisd(angle, axis) * pose[bone];
}

std::vector<Vector3f> posed(const HumanPose& pose) {
  std::vector<Vector3f> vertices;
  person().pose(pose, vertices);
  return vertices;
}

/// Mean distance from a bone's rest line of the ring of vertices about a place on the left arm,
/// after the arm was posed without moving that line.
double armGirth(const std::vector<Vector3f>& vertices, double y) {
  const Vector3d shoulder = person().skeleton.headOf(Bone::kLeftUpperArm);
  double sum = 0.0;
  int count = 0;
  for (size_t v = 0; v < vertices.size(); ++v) {
    if (std::abs(person().mesh.vertices[v].y() - y) > 0.015) continue;
    const Vector3d p = vertices[v].cast<double>() - shoulder;
    sum += std::hypot(p.x(), p.z());
    ++count;
  }
  return sum / count;
}

TEST(SkinWeights, SumToOne) {
  for (const VertexWeights& vertex : person().weights) {
    float sum = 0.0f;
    for (float weight : vertex.weights) {
      ASSERT_GE(weight, 0.0f);
      sum += weight;
    }
    ASSERT_NEAR(sum, 1.0f, 1e-5f);
  }
}

TEST(Pose, AtRestLeavesTheMesh) {
  const std::vector<Vector3f> vertices = posed(atRest());
  for (size_t v = 0; v < vertices.size(); ++v)
    ASSERT_LT((vertices[v] - person().mesh.vertices[v]).norm(), 1e-5f);
}

TEST(Pose, MovesRigidlyWithAllBones) {
  const Quaterniond R(AngleAxisd(2.5, Vector3d(0.3, -0.5, 0.8).normalized()));
  HumanPose pose = atRest();
  pose.hips += Vector3d(0.4, -1.2, 0.3);
  for (int b = 0; b < kBoneCount; ++b) pose[Bone(b)] = R;
  const std::vector<Vector3f> vertices = posed(pose);
  const Vector3d hips = person().skeleton.headOf(Bone::kHips);
  for (size_t v = 0; v < vertices.size(); ++v) {
    const Vector3d want = pose.hips + R * (person().mesh.vertices[v].cast<double>() - hips);
    ASSERT_LT((vertices[v].cast<double>() - want).norm(), 1e-5);
  }
}

TEST(Pose, BentElbowKeepsTheUpperArmAndCarriesTheHand) {
  HumanPose pose = atRest();
  turn(pose, {Bone::kLeftForearm, Bone::kLeftHand}, -M_PI / 2, Vector3d::UnitZ());
  const std::vector<Vector3f> vertices = posed(pose);
  const Vector3d elbow = person().skeleton.headOf(Bone::kLeftForearm);
  const double wrist = person().skeleton.headOf(Bone::kLeftHand).y();
  for (size_t v = 0; v < vertices.size(); ++v) {
    const Vector3d rest = person().mesh.vertices[v].cast<double>();
    const Vector3d now = vertices[v].cast<double>();
    if (rest.y() < elbow.y() - 0.10) {
      ASSERT_LT((now - rest).norm(), 1e-5);
    }
    if (rest.y() < wrist + 0.08) continue;
    // A quarter turn to the front takes (x, y) from the elbow to (y, -x).
    const Vector3d arm = rest - elbow;
    ASSERT_LT((now - elbow - Vector3d(arm.y(), -arm.x(), arm.z())).norm(), 0.002);
  }
}

TEST(Pose, TwistIsSpreadAlongTheForearm) {
  HumanPose pose = atRest();
  turn(pose, {Bone::kLeftHand}, M_PI / 2, Vector3d::UnitY());
  const std::vector<Vector3f> vertices = posed(pose);
  const Vector3d elbow = person().skeleton.headOf(Bone::kLeftForearm);
  const double length = person().skeleton.lengthOf(Bone::kLeftForearm);
  for (double fraction : {0.25, 0.5, 0.75}) {
    for (size_t v = 0; v < vertices.size(); ++v) {
      const Vector3d rest = person().mesh.vertices[v].cast<double>();
      if (std::abs(rest.y() - elbow.y() - fraction * length) > 0.006) continue;
      const double angle = (rest.y() - elbow.y()) / length * M_PI / 2;
      const Vector3d want = elbow + AngleAxisd(angle, Vector3d::UnitY()) * (rest - elbow);
      ASSERT_LT((vertices[v].cast<double>() - want).norm(), 0.004) << "at " << fraction;
    }
  }
}

TEST(Pose, TwistedLimbsKeepTheirGirth) {
  HumanPose pose = atRest();
  turn(pose, {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftHand}, 1.5, Vector3d::UnitY());
  turn(pose, {Bone::kLeftHand}, 1.4, Vector3d::UnitY());
  const std::vector<Vector3f> twisted = posed(pose), rest = person().mesh.vertices;
  const HumanSkeleton& skeleton = person().skeleton;
  for (Bone bone : {Bone::kLeftForearm, Bone::kLeftHand}) {
    const double y = skeleton.headOf(bone).y();
    EXPECT_NEAR(armGirth(twisted, y) / armGirth(rest, y), 1.0, 0.03) << boneName(bone);
  }
}

TEST(Pose, LeftAndRightMirror) {
  HumanPose left = atRest(), right = atRest();
  turn(left, {Bone::kLeftThigh, Bone::kLeftShank, Bone::kLeftFoot, Bone::kLeftToes}, -1.2,
       Vector3d::UnitY());
  turn(right, {Bone::kRightThigh, Bone::kRightShank, Bone::kRightFoot, Bone::kRightToes}, -1.2,
       Vector3d::UnitY());
  const std::vector<Vector3f> a = posed(left), b = posed(right);
  Vector3d mean_a = Vector3d::Zero(), mean_b = Vector3d::Zero();
  for (size_t v = 0; v < a.size(); ++v) {
    mean_a += a[v].cast<double>() / double(a.size());
    mean_b += b[v].cast<double>() / double(b.size());
  }
  EXPECT_GT(mean_a.x() - person().skeleton.headOf(Bone::kHips).x(), 0.02);
  EXPECT_LT((mean_a - Vector3d(mean_b.x(), -mean_b.y(), mean_b.z())).norm(), 1e-4);
}

}  // namespace
}  // namespace markerless_mocap
