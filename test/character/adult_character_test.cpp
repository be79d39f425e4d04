#include "character/adult_character.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

CharacterOptions dressed(const std::string& clothes) {
  CharacterOptions options;
  options.clothes = clothes;
  return options;
}

/// The default person in those clothes; made once.
const Character& manIn(const std::string& clothes) {
  static std::map<std::string, Character> made;
  const auto found = made.find(clothes);
  if (found != made.end()) return found->second;
  return made[clothes] = makeCharacter(dressed(clothes));
}

const Character& man() {
  return manIn("tight");
}

/// By the divergence theorem; litres.
double volume(const ColoredMesh& mesh) {
  double sum = 0.0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vector3d a = mesh.vertices[size_t(t[0])].cast<double>(),
                   b = mesh.vertices[size_t(t[1])].cast<double>(),
                   c = mesh.vertices[size_t(t[2])].cast<double>();
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return 1000.0 * sum;
}

void expectClosed(const ColoredMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const std::array<int, 3>& t : mesh.triangles)
    for (size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    ASSERT_TRUE(count == 1 && back != edges.end() && back->second == 1)
        << "edge " << edge.first << " " << edge.second;
  }
}

/// How far behind the front of the flesh a joint lies, as a share of the flesh's depth, in a window
/// of +-12 mm about it.
double shareOfDepth(const Character& person, const Vector3d& joint) {
  double front = -1.0, back = 1.0;
  for (const Vector3f& vertex : person.mesh.vertices) {
    const Vector3d off = vertex.cast<double>() - joint;
    if (std::abs(off.y()) > 0.012 || std::abs(off.z()) > 0.012) continue;
    front = std::max(front, off.x());
    back = std::min(back, off.x());
  }
  return front / (front - back);
}

/// Winding number by solid angles (van Oosterom and Strackee 1983): 1 inside, 0 outside.
double windings(const ColoredMesh& mesh, const Vector3d& p) {
  double sum = 0.0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vector3d a = mesh.vertices[size_t(t[0])].cast<double>() - p,
                   b = mesh.vertices[size_t(t[1])].cast<double>() - p,
                   c = mesh.vertices[size_t(t[2])].cast<double>() - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2.0 * M_PI);
}

/// Greatest |y| between two heights.
float halfWidth(const ColoredMesh& mesh, float below, float above) {
  float widest = 0.0f;
  for (const Vector3f& v : mesh.vertices)
    if (v.z() > below && v.z() < above) widest = std::max(widest, std::abs(v.y()));
  return widest;
}

std::string refusal(const CharacterOptions& options) {
  return errorTextOf([&] { makeCharacter(options); });
}

TEST(MakeCharacter, IsClosedInAllClothes) {
  for (const char* clothes : {"tight", "loose", "skirt"}) {
    const ColoredMesh& mesh = manIn(clothes).mesh;
    expectClosed(mesh);
    ASSERT_EQ(mesh.colors.size(), mesh.vertices.size());
    for (const Vector3f& color : mesh.colors)
      ASSERT_TRUE(color.minCoeff() >= 0.0f && color.maxCoeff() <= 1.0f) << clothes;
  }
}

TEST(MakeCharacter, HasTheVolumeOfItsWeight) {
  EXPECT_GT(volume(man().mesh), 68.0);
  EXPECT_LT(volume(man().mesh), 80.0);
  CharacterOptions heavy;
  heavy.bmi = 1.35 * CharacterOptions().bmi;
  EXPECT_NEAR(volume(makeCharacter(heavy).mesh) / volume(man().mesh), 1.35, 0.07);
  CharacterOptions woman;
  woman.male = 0.0;
  woman.stature = 1.65;
  woman.bmi = 22.0;
  woman.hair = "long";
  const Character person = makeCharacter(woman);
  expectClosed(person.mesh);
  const double litres = volume(person.mesh);
  EXPECT_GT(litres, 55.0);
  EXPECT_LT(litres, 68.0);
}

TEST(MakeCharacter, StandsOnTheFloorAsTallAsItsStature) {
  float low = 9.0f, high = 0.0f;
  for (const Vector3f& v : man().mesh.vertices) {
    low = std::min(low, v.z());
    high = std::max(high, v.z());
  }
  EXPECT_NEAR(low, 0.0, 0.003);
  EXPECT_NEAR(high, 1.75, 0.02);
}

TEST(MakeCharacter, HoldsItsJointsInside) {
  const HumanSkeleton& skeleton = man().skeleton;
  for (int b = 0; b < kBoneCount; ++b)
    EXPECT_NEAR(windings(man().mesh, skeleton.headOf(Bone(b))), 1.0, 1e-3) << boneName(Bone(b));
  EXPECT_NEAR(windings(man().mesh, {0.0, 0.0, 0.4}), 0.0, 1e-3);  // between the legs
}

// Hips: Hara et al. 2016 and the buttocks of ANSUR; knees: behind the condyles' middle.
TEST(MakeCharacter, JointsLieInTheFleshWhereAnatomyHasThem) {
  for (const double male : {0.0, 1.0}) {
    CharacterOptions options;
    options.male = male;
    const Character person = makeCharacter(options);
    const HumanSkeleton& s = person.skeleton;
    EXPECT_NEAR(shareOfDepth(person, s.headOf(Bone::kLeftThigh)), 0.38, 0.04) << male;
    EXPECT_NEAR(s.headOf(Bone::kLeftThigh).y(), 0.088, 0.006) << male;
    EXPECT_NEAR(shareOfDepth(person, s.headOf(Bone::kLeftShank)), 0.57, 0.04) << male;
    const Vector3d skull = s.headOf(Bone::kHead);
    EXPECT_NEAR(options.stature - skull.z(), 0.155, 0.006) << male;
    EXPECT_NEAR(skull.x() - s.headOf(Bone::kNeck).x(), 0.007, 0.003) << male;
  }
}

TEST(MakeCharacter, IsMirrorSymmetric) {
  std::map<std::array<int, 3>, int> joint_positions;
  const auto key = [](const Vector3f& v) {
    const Eigen::Vector3i mm = (v * 1000.0f).array().round().cast<int>();
    return std::array<int, 3>{mm.x(), mm.y(), mm.z()};
  };
  for (const Vector3f& v : man().mesh.vertices) ++joint_positions[key(v)];
  size_t alone = 0;
  for (const Vector3f& v : man().mesh.vertices)
    alone += joint_positions.count(key({v.x(), -v.y(), v.z()})) == 0;
  EXPECT_LE(alone, man().mesh.vertices.size() / 500);  // rounding at half a millimetre
}

TEST(MakeCharacter, ClothesChangeTheOutline) {
  EXPECT_GT(volume(manIn("loose").mesh), 1.2 * volume(man().mesh));
  EXPECT_GT(halfWidth(manIn("skirt").mesh, 0.47f, 0.52f),
            halfWidth(man().mesh, 0.47f, 0.52f) + 0.07f);
}

TEST(MakeCharacter, IsTheSameAgain) {
  const Character again = makeCharacter(CharacterOptions());
  EXPECT_EQ(again.mesh.vertices, man().mesh.vertices);
  EXPECT_EQ(again.mesh.colors, man().mesh.colors);
  EXPECT_EQ(again.mesh.triangles, man().mesh.triangles);
}

TEST(MakeCharacter, LookSeedChangesColoursOnly) {
  CharacterOptions options;
  options.appearance_seed = 2;
  const Character other = makeCharacter(options);
  EXPECT_EQ(other.mesh.vertices, man().mesh.vertices);
  EXPECT_NE(other.mesh.colors, man().mesh.colors);
}

TEST(MakeCharacter, RefusesWhatNobodyIs) {
  CharacterOptions tall;
  tall.stature = 3.0;
  EXPECT_EQ(refusal(tall), "virtual_studio/stature is 3, allowed is 1.2 to 2.2");
  EXPECT_EQ(refusal(dressed("toga")),
            "virtual_studio/clothes is \"toga\", allowed is one of tight, loose, skirt");
}

}  // namespace
}  // namespace markerless_mocap
