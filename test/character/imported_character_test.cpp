#include "character/imported_character.h"

#include <cmath>
#include <map>
#include <set>

#include "character/imported_character_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

class ImportedAnyFormat : public Imported, public testing::WithParamInterface<Format> {};
INSTANTIATE_TEST_SUITE_P(Formats, ImportedAnyFormat, testing::Values(kGltf, kGlb, kFbx),
                         [](const auto& info) { return std::string(info.param.id); });

double distanceToBone(const HumanSkeleton& skeleton, Bone bone, const Vector3d& point) {
  const Vector3d along = skeleton.tailOf(bone) - skeleton.headOf(bone);
  const Vector3d from = point - skeleton.headOf(bone);
  const double fraction = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (from - fraction * along).norm();
}

double volume(const ColoredMesh& mesh) {
  double sum = 0.0;
  const auto at = [&](int v) -> Vector3d { return mesh.vertices[size_t(v)].cast<double>(); };
  for (const auto& [a, b, c] : mesh.triangles) sum += at(a).dot(at(b).cross(at(c))) / 6.0;
  return sum;
}

double volume(const BoxMan& man) {
  double sum = 0.0;
  for (const Box& box : man.boxes)
    sum += 4.0 * box.half_width * box.half_width * (box.tail - box.head).norm();
  return sum;
}

void expectTPose(const Character& person) {
  float bottom = 10.0f, top = -10.0f;
  for (const Vector3f& vertex : person.mesh.vertices) {
    bottom = std::min(bottom, vertex.z());
    top = std::max(top, vertex.z());
  }
  EXPECT_NEAR(bottom, 0.0, 1e-5);
  EXPECT_NEAR(top, kStature, 1e-5);
  const HumanSkeleton& s = person.skeleton;
  EXPECT_EQ(s.stature, kStature);
  EXPECT_NEAR(s.tailOf(Bone::kHead).z(), kStature, 1e-5);
  EXPECT_NEAR(s.headOf(Bone::kHips).head<2>().norm(), 0.0, 1e-6);
  const auto expectAlong = [&](Bone bone, const Vector3d& direction) {
    const Vector3d along = (s.tailOf(bone) - s.headOf(bone)).normalized();
    EXPECT_GT(along.dot(direction), 1.0 - 1e-6) << boneName(bone) << " " << along.transpose();
  };
  for (Bone bone : {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftHand}) {
    expectAlong(bone, Vector3d::UnitY());
    expectAlong(mirrorOf(bone), -Vector3d::UnitY());
  }
  for (Bone bone : {Bone::kLeftThigh, Bone::kLeftShank, Bone::kRightThigh, Bone::kRightShank})
    expectAlong(bone, -Vector3d::UnitZ());
  for (Bone toes : {Bone::kLeftToes, Bone::kRightToes}) expectAlong(toes, Vector3d::UnitX());
}

/// Every vertex lies on the box of the bone that carries it.
void expectSkinOnBones(const Character& person) {
  for (size_t v = 0; v < person.mesh.vertices.size(); ++v) {
    const Bone bone = heaviest(person.weights[v]);
    ASSERT_LT(distanceToBone(person.skeleton, bone, person.mesh.vertices[v].cast<double>()), 0.19)
        << boneName(bone) << " at " << person.mesh.vertices[v].transpose();
  }
}

TEST_P(ImportedAnyFormat, StandsInTheTPoseAsTallAsAsked) {
  const Character person = import(mixamoMan(), GetParam());
  expectTPose(person);
  const HumanSkeleton& s = person.skeleton;
  // Lengths keep their ratios: those of the boxes to the upper arm's 0.30.
  const double scale = s.lengthOf(Bone::kLeftUpperArm) / 0.30;
  EXPECT_NEAR(s.lengthOf(Bone::kRightForearm), 0.25 * scale, 1e-5);
  EXPECT_NEAR(s.lengthOf(Bone::kLeftHand), 0.19 * scale, 1e-5);
  EXPECT_NEAR(s.lengthOf(Bone::kLeftThigh), std::hypot(0.05, 0.42) * scale, 1e-5);
  EXPECT_NEAR(s.lengthOf(Bone::kNeck), 0.10 * scale, 1e-5);
  EXPECT_NEAR(s.headOf(Bone::kLeftToes).x(), std::hypot(0.14, 0.06) * scale, 1e-5);
  EXPECT_NEAR(s.tailOf(Bone::kLeftToes).y(), s.headOf(Bone::kLeftThigh).y(), 1e-5);
}

TEST_P(ImportedAnyFormat, SkinGoesToItsBones) {
  const Character person = import(mixamoMan(), GetParam());
  ASSERT_EQ(person.weights.size(), person.mesh.vertices.size());
  std::map<Bone, int> count;
  for (const VertexWeights& vertex : person.weights) {
    ++count[heaviest(vertex)];
    EXPECT_FLOAT_EQ(vertex.weights[0], 1.0f);
  }
  for (int b = 0; b < kBoneCount; ++b) {
    // A finger's box goes to the hand.
    const bool is_hand = Bone(b) == Bone::kLeftHand || Bone(b) == Bone::kRightHand;
    EXPECT_EQ(count[Bone(b)], is_hand ? 16 : 8) << boneName(Bone(b));
  }
  expectSkinOnBones(person);
}

TEST_P(ImportedAnyFormat, IsClosedAndFacesOutward) {
  const BoxMan man = mixamoMan();
  const Character person = import(man, GetParam());
  std::set<std::pair<int, int>> edges;
  for (const auto& t : person.mesh.triangles)
    for (size_t k = 0; k < 3; ++k) EXPECT_TRUE(edges.insert({t[k], t[(k + 1) % 3]}).second);
  for (const auto& [a, b] : edges) EXPECT_TRUE(edges.count({b, a}));
  const double scale = person.skeleton.lengthOf(Bone::kLeftUpperArm) / 0.30;
  EXPECT_NEAR(volume(person.mesh), volume(man) * scale * scale * scale, 1e-5);
}

TEST_P(ImportedAnyFormat, RaisedArmTakesTheHandUp) {
  const Character person = import(mixamoMan(), GetParam());
  HumanPose pose;
  pose.hips = person.skeleton.headOf(Bone::kHips);
  for (Bone bone : {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftHand})
    pose[bone] = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX());
  std::vector<Vector3f> vertices;
  person.pose(pose, vertices);
  const Vector3d shoulder = person.skeleton.headOf(Bone::kLeftUpperArm);
  for (size_t v = 0; v < vertices.size(); ++v) {
    const Vector3d rest = person.mesh.vertices[v].cast<double>();
    const Bone bone = heaviest(person.weights[v]);
    Vector3d want = rest;
    // A quarter turn about x takes (y, z) from the shoulder to (-z, y).
    if (bone == Bone::kLeftHand || bone == Bone::kLeftForearm)
      want = shoulder + Vector3d(rest.x(), -(rest.z() - shoulder.z()), rest.y() - shoulder.y());
    if (bone == Bone::kLeftUpperArm) continue;
    ASSERT_LT((vertices[v].cast<double>() - want).norm(), 1e-4) << boneName(bone);
  }
}

TEST_F(Imported, RigWithFewBonesGetsTheOthers) {
  for (const Format& format : {kCollada, kGltf}) {
    const Character person = import(plainMan(), format);
    expectTPose(person);
    expectSkinOnBones(person);
    const HumanSkeleton& s = person.skeleton;
    for (int b = 0; b < kBoneCount; ++b) EXPECT_GT(s.lengthOf(Bone(b)), 0.02) << boneName(Bone(b));
    for (int b = int(Bone::kSpine); b <= int(Bone::kHead); ++b)
      EXPECT_GT(s.headOf(Bone(b)).z(), s.headOf(Bone(b - 1)).z()) << boneName(Bone(b));
    EXPECT_GT(s.headOf(Bone::kNeck).z(), s.headOf(Bone::kLeftUpperArm).z());
    EXPECT_NEAR(s.lengthOf(Bone::kLeftHand) / s.lengthOf(Bone::kLeftForearm), 0.75, 0.03);
    EXPECT_NEAR(s.tailOf(Bone::kLeftHand).y() / s.lengthOf(Bone::kLeftUpperArm),
                (0.18 + 0.30 + 0.44) / 0.30, 1e-4);
    EXPECT_LT(s.headOf(Bone::kLeftClavicle).y(), s.headOf(Bone::kLeftUpperArm).y());
  }
}

TEST_F(Imported, BonesThatTheRigHasNotTakeOverTheirShareOfTheSkin) {
  const Character person = import(plainMan(), kCollada);
  std::map<Bone, double> most;
  for (size_t v = 0; v < person.weights.size(); ++v)
    for (size_t k = 0; k < 4; ++k) {
      double& weight = most[person.weights[v].bones[k]];
      weight = std::max(weight, double(person.weights[v].weights[k]));
    }
  for (Bone bone : {Bone::kHead, Bone::kLeftHand, Bone::kRightHand, Bone::kLeftToes,
                    Bone::kRightToes, Bone::kSpine})
    EXPECT_NEAR(most[bone], 1.0, 1e-5) << boneName(bone);
}

TEST_F(Imported, MirroredSceneStillFacesOutwardAndForward) {
  BoxMan man = mixamoMan();
  man.root(0, 0) = -1.0;
  man.T_file_world = man.root * man.T_file_world;
  man.loose.push_back({"nose", "mixamorig:Head", {0, 0, 1.7}, {0.15, 0, 1.7}, 0.02});
  const Character person = import(man);
  float front = 0.0f;
  for (size_t v = 0; v < person.weights.size(); ++v)
    if (heaviest(person.weights[v]) == Bone::kHead)
      front = std::max(front, person.mesh.vertices[v].x());
  EXPECT_GT(front, 0.12f);
  expectTPose(person);
  expectSkinOnBones(person);
  EXPECT_GT(volume(person.mesh), 0.0);
}

TEST_F(Imported, InsideOutMeshIsTurned) {
  BoxMan man = mixamoMan();
  man.inside_out = true;
  EXPECT_GT(volume(import(man).mesh), 0.0);
}

TEST_F(Imported, NodesTellThePoseWhereTheBindPoseDoesNot) {
  BoxMan man = mixamoMan();
  man.bind_is_lost = true;
  const Character person = import(man);
  expectTPose(person);
  expectSkinOnBones(person);
}

TEST_F(Imported, VertexWithoutWeightGoesToTheNearestBone) {
  BoxMan man = mixamoMan();
  for (Box& box : man.boxes) box.weighted = box.name != "mixamorig:LeftLeg";
  const Character person = import(man);
  std::map<Bone, int> count;
  for (const VertexWeights& vertex : person.weights) ++count[heaviest(vertex)];
  EXPECT_EQ(count[Bone::kLeftThigh] + count[Bone::kLeftShank] + count[Bone::kLeftFoot], 24);
  expectSkinOnBones(person);
}

TEST_F(Imported, HatComesAlongAndTheFloorDoesNot) {
  BoxMan man = mixamoMan();
  const size_t without = import(man).mesh.vertices.size();
  man.loose.push_back({"floor", "", {0, 0, -0.2}, {0, 0, 0}, 3.0});
  man.loose.push_back({"hat", "mixamorig:Head", {0, 0, 1.75}, {0, 0, 1.90}, 0.1});
  const Character person = import(man);
  EXPECT_EQ(person.mesh.vertices.size(), without + 8);
  int count = 0;
  for (const VertexWeights& vertex : person.weights) count += heaviest(vertex) == Bone::kHead;
  EXPECT_EQ(count, 16);
  expectTPose(person);
  man.boxes.push_back(man.loose.back());
  const double scale = person.skeleton.lengthOf(Bone::kLeftUpperArm) / 0.30;
  EXPECT_NEAR(volume(person.mesh), volume(man) * scale * scale * scale, 1e-5);
}

}  // namespace
}  // namespace markerless_mocap
