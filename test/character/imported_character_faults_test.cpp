#include <fstream>
#include <iterator>
#include <limits>

#include "character/imported_character_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

TEST_F(Imported, FaultsOfTheFile) {
  EXPECT_EQ(faultOf(file("none.glb")), "there is no such file");
  std::ofstream(file("text.glb")) << "no model";
  EXPECT_EQ(faultOf(file("text.glb")).rfind("is no model that can be read (", 0), 0u);
  std::ofstream(file("empty.gltf"))
      << R"({"asset":{"version":"2.0"},"nodes":[{"name":"a"}],"scenes":[{"nodes":[0]}],"scene":0})";
  EXPECT_EQ(faultOf(file("empty.gltf")), "has no mesh");
}

TEST_F(Imported, WhatEndsTheImporterIsRefusedBefore) {
  const std::string asset = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"scene":0,)";
  std::ofstream(file("skin.gltf"))
      << asset << R"("nodes":[{"name":"a"}],"skins":[{"joints":[0]}]})";
  EXPECT_EQ(faultOf(file("skin.gltf")),
            "its skin 0 has no inverseBindMatrices, export it with them");
  for (const bool circle : {false, true}) {
    std::ofstream deep(file("deep.gltf"));
    const int nodes = circle ? 2 : 20000;
    deep << asset << "\"nodes\":[";
    for (int i = 0; i + 1 < nodes; ++i) deep << "{\"children\":[" << i + 1 << "]},";
    deep << (circle ? "{\"children\":[0]}" : "{}") << "]}";
    deep.close();
    EXPECT_EQ(faultOf(file("deep.gltf")),
              "its nodes are nested more than 500 deep, or in a circle");
  }
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
            "forward cannot be determined");
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
