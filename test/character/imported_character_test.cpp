#include "markerless_mocap/character/imported_character.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <assimp/Exporter.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "character/imported_character_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kStature = 1.7;

struct Format {
  const char* id;
  const char* ending;
};
constexpr Format kGltf{"gltf2", ".gltf"}, kGlb{"glb2", ".glb"}, kCollada{"collada", ".dae"},
    kFbx{"fbxa", ".fbx"};

class Imported : public testing::Test {
 protected:
  Imported() : folder_(testing::TempDir() + "imported_" + std::to_string(getpid())) {
    std::filesystem::create_directory(folder_);
  }
  ~Imported() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return folder_ + "/" + name; }

  std::string write(const BoxMan& man, const Format& format = kGltf) const {
    const std::string path = file(std::string("man") + format.ending);
    const BoxManScene scene(man);
    Assimp::Exporter exporter;
    EXPECT_EQ(exporter.Export(&scene.scene(), format.id, path), AI_SUCCESS)
        << exporter.GetErrorString();
    return path;
  }

  Character import(const BoxMan& man, const Format& format = kGltf) const {
    return importCharacter(write(man, format), kStature);
  }

  std::string faultOf(const std::string& path, double stature = kStature) const {
    try {
      importCharacter(path, stature);
    } catch (const std::invalid_argument& fault) {
      const std::string sentence = fault.what();
      EXPECT_EQ(sentence.rfind(path + ": ", 0), 0u) << sentence;
      return sentence.substr(std::min(path.size() + 2, sentence.size()));
    }
    return "none";
  }

 private:
  std::string folder_;
};

class ImportedAnyFormat : public Imported, public testing::WithParamInterface<Format> {};
INSTANTIATE_TEST_SUITE_P(Formats, ImportedAnyFormat, testing::Values(kGltf, kGlb, kFbx),
                         [](const auto& info) { return std::string(info.param.id); });

Bone heaviest(const VertexWeights& vertex) {
  const auto most = std::max_element(vertex.weights.begin(), vertex.weights.end());
  return vertex.bones[size_t(most - vertex.weights.begin())];
}

double distanceToBone(const HumanSkeleton& skeleton, Bone bone, const Vector3d& point) {
  const Vector3d along = skeleton.tailOf(bone) - skeleton.headOf(bone);
  const Vector3d from = point - skeleton.headOf(bone);
  const double share = std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (from - share * along).norm();
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

TEST_P(ImportedAnyFormat, KeepsColours) {
  const BoxMan man = mixamoMan();
  const Character person = import(man, GetParam());
  // glTF tells light, not what is displayed.
  const float power = std::string(GetParam().id) == "fbxa" ? 1.0f : 1.0f / 2.2f;
  for (size_t v = 0; v < person.mesh.vertices.size(); ++v) {
    const std::string& bone = boneName(heaviest(person.weights[v]));
    const bool skin = bone == "neck" || bone == "head" || bone.find("hand") != std::string::npos;
    const Vector3f want = (skin ? man.skin_color : man.cloth_color).array().pow(power);
    ASSERT_LT((person.mesh.colors[v] - want).norm(), 1e-3f) << bone;
  }
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
  const Character person = import(man);
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
}

/// Four quarters: red and green below, blue and yellow above.
cv::Mat quarters() {
  cv::Mat image(2, 2, CV_8UC3);
  image.at<cv::Vec3b>(1, 0) = {0, 0, 255};
  image.at<cv::Vec3b>(1, 1) = {0, 255, 0};
  image.at<cv::Vec3b>(0, 0) = {255, 0, 0};
  image.at<cv::Vec3b>(0, 1) = {0, 255, 255};
  return image;
}

void expectQuarters(const Character& person) {
  const auto colorOf = [&](Bone bone) {
    for (size_t v = 0; v < person.weights.size(); ++v)
      if (heaviest(person.weights[v]) == bone) return person.mesh.colors[v];
    return Vector3f(-1, -1, -1);
  };
  EXPECT_LT((colorOf(Bone::kRightShank) - Vector3f(1, 0, 0)).norm(), 1e-5f);
  EXPECT_LT((colorOf(Bone::kLeftShank) - Vector3f(0, 1, 0)).norm(), 1e-5f);
  EXPECT_LT((colorOf(Bone::kRightUpperArm) - Vector3f(0, 0, 1)).norm(), 1e-5f);
  EXPECT_LT((colorOf(Bone::kLeftUpperArm) - Vector3f(1, 1, 0)).norm(), 1e-5f);
}

TEST_F(Imported, TextureBesideTheModelIsSampled) {
  BoxMan man = mixamoMan();
  man.cloth_color = Vector3f::Ones();
  cv::imwrite(file("cloth colour.png"), quarters());
  for (const char* name : {"cloth colour.png", "C:\\models\\cloth%20colour.png"}) {
    man.cloth_texture = name;
    expectQuarters(import(man, kFbx));
  }
}

TEST_F(Imported, EmbeddedTextureIsSampled) {
  BoxMan man = mixamoMan();
  man.cloth_color = Vector3f::Ones();
  man.cloth_texture = "*0";
  std::vector<uchar> bytes;
  cv::imencode(".png", quarters(), bytes);
  man.embedded_image.assign(bytes.begin(), bytes.end());
  expectQuarters(import(man, kGlb));
}

TEST_F(Imported, UnreadableTextureLeavesTheMaterialsColour) {
  BoxMan man = mixamoMan();
  man.cloth_texture = "lost.png";
  const Character person = import(man, kFbx);
  for (size_t v = 0; v < person.weights.size(); ++v) {
    if (heaviest(person.weights[v]) != Bone::kChest) continue;
    EXPECT_LT((person.mesh.colors[v] - man.cloth_color).norm(), 1e-3f);
  }
}

TEST_F(Imported, FaultsOfTheFile) {
  EXPECT_EQ(faultOf(file("none.glb")), "there is no such file");
  std::ofstream(file("text.glb")) << "no model";
  EXPECT_EQ(faultOf(file("text.glb")).rfind("is no model that can be read (", 0), 0u);
  std::ofstream(file("empty.gltf"))
      << R"({"asset":{"version":"2.0"},"nodes":[{"name":"a"}],"scenes":[{"nodes":[0]}],"scene":0})";
  EXPECT_EQ(faultOf(file("empty.gltf")), "has no mesh");
}

TEST_F(Imported, FaultsOfTheRig) {
  BoxMan statue = mixamoMan();
  statue.has_bones = false;
  EXPECT_EQ(faultOf(write(statue)), "no mesh is fastened to bones, a rigged character is needed");

  BoxMan fish = plainMan();
  for (Box& box : fish.boxes)
    if (box.name == "thigh.L")
      box.name = "fin";
    else if (box.parent == "thigh.L")
      box.parent = "fin";
  const std::string missing = faultOf(write(fish));
  EXPECT_EQ(missing.rfind("no joint is named like l_thigh; the joints are ", 0), 0u) << missing;
  EXPECT_NE(missing.find(", fin, "), std::string::npos) << missing;

  BoxMan sitting = mixamoMan();
  for (Box& box : sitting.boxes)
    for (Vector3d* place : {&box.head, &box.tail})
      if (place->z() < 0.9) *place = {0.92 - place->z(), place->y(), 0.92 + place->x()};
  EXPECT_EQ(faultOf(write(sitting)),
            "neither the bind pose nor the nodes' pose is a person standing upright, so up and "
            "forward cannot be told");
}

TEST_F(Imported, FaultsOfTheStature) {
  const std::string path = write(mixamoMan());
  for (double stature : {0.0, 3.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(faultOf(path, stature),
              "stature is " + std::to_string(stature) + " m, allowed is 0.5 to 2.5");
}

TEST_F(Imported, FaultOfAPlaceThatIsNoNumber) {
  const std::string path = write(plainMan(), kCollada);
  std::ifstream in(path);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const size_t array = text.find("<float_array");
  const size_t first = text.find('>', array) + 1;
  text.replace(first, text.find(' ', first) - first, "nan");
  std::ofstream(path) << text;
  EXPECT_EQ(faultOf(path), "a vertex's place is not a finite number");
}

}  // namespace
}  // namespace markerless_mocap
