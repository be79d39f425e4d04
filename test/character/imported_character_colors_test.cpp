#include <opencv2/imgcodecs.hpp>

#include "character/imported_character_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3f;

class ImportedColors : public Imported, public testing::WithParamInterface<Format> {};
INSTANTIATE_TEST_SUITE_P(Formats, ImportedColors, testing::Values(kGltf, kGlb, kFbx),
                         [](const auto& info) { return std::string(info.param.id); });

TEST_P(ImportedColors, KeepsColours) {
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

}  // namespace
}  // namespace markerless_mocap
