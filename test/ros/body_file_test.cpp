#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "markerless_mocap/tracking/shape_file.h"
#include "ros/package_files.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

TEST(BodyFile, OnlyItsOwnerReadsIt) {
  const std::string path = ::testing::TempDir() + "body_" + std::to_string(getpid()) + ".yaml";
  std::ofstream(path) << "an older one that all may read";
  fs::permissions(path, fs::perms(0644));
  ShapeParameters shape;
  for (int i = 0; i < kShapeParameterCount; ++i) shape[i] = 0.25;
  writeBodyFile(path, shape);
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0600));
  EXPECT_NEAR(shapeFromYaml(readText(path), path)[0], 0.25, 1e-9);
  fs::remove(path);
}

}  // namespace
}  // namespace markerless_mocap
