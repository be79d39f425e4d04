#include "ros/hull_conversions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "error_text_of.h"
#include "ros/world_header.h"

namespace markerless_mocap {
namespace {

VisualHull sampleHull() {
  VisualHull hull;
  hull.lattice.origin = {-1.5, -1.5, 0.0};
  hull.lattice.pitch = 0.03;
  hull.lattice.size = {100, 101, 74};
  hull.status = HullStatus::kOk;
  for (uint32_t i = 0; i < hull.lattice.count(); i += 997) {
    HullVoxel voxel;
    voxel.index = i;
    voxel.views = uint8_t(2 + i % 7);
    voxel.rgb = {uint8_t(i), uint8_t(i / 3), uint8_t(i / 7)};
    voxel.color_votes.votes = {1, uint8_t(i % 5), 3};
    voxel.color_votes.possible = {4, 5, uint8_t(i % 9)};
    hull.voxels.push_back(voxel);
  }
  return hull;
}

VoxelGrid sampleGrid() {
  return messageFromLattice(sampleHull().lattice, worldHeader());
}

TEST(HullConversions, LatticeComesBackAsItWas) {
  EXPECT_EQ(latticeFromMessage(sampleGrid()), sampleHull().lattice);
}

TEST(HullConversions, UnusableGridsAreRefused) {
  VoxelGrid grid = sampleGrid();
  grid.pitch = 0.0;
  EXPECT_THROW(latticeFromMessage(grid), std::invalid_argument);
  grid.pitch = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(latticeFromMessage(grid), std::invalid_argument);
  grid = sampleGrid();
  grid.size[1] = 0;
  EXPECT_THROW(latticeFromMessage(grid), std::invalid_argument);
}

TEST(HullConversions, GridsWhoseSizesOverflowAreRefused) {
  VoxelGrid grid = sampleGrid();
  for (const std::array<uint32_t, 3>& size : {std::array<uint32_t, 3>{65536, 65536, 1},
                                              {65536, 65536, 65537},
                                              {1, 1, 0xffffffff},
                                              {0x80000000, 2, 1},
                                              {1 << 21, 1 << 21, 1 << 22}}) {
    std::copy(size.begin(), size.end(), grid.size.begin());
    EXPECT_NE(errorTextOf([&] { latticeFromMessage(grid); }).find("64 million"), std::string::npos);
  }
}

TEST(HullConversions, GridsOutsideOfAnyRoomAreRefused) {
  VoxelGrid grid = sampleGrid();
  grid.origin.y = 1e300;
  EXPECT_THROW(latticeFromMessage(grid), std::invalid_argument);
  grid = sampleGrid();
  grid.pitch = 1e300;
  EXPECT_THROW(latticeFromMessage(grid), std::invalid_argument);
}

TEST(HullConversions, VoxelsThatComeTwiceAreRefused) {
  auto cloud = messageFromHull(sampleHull(), worldHeader());
  std::copy_n(cloud.data.begin(), cloud.point_step, cloud.data.begin() + cloud.point_step);
  EXPECT_EQ(errorTextOf([&] { hullFromMessage(cloud, sampleGrid()); }),
            "hull cloud has a voxel twice");
}

TEST(HullConversions, FieldsOutsideOfThePointAreRefusedWhateverElseThereIs) {
  const auto good = messageFromHull(sampleHull(), worldHeader());
  for (const uint32_t offset : {0xfffffffeu, 0xffffffffu, 4000000000u, good.point_step - 3}) {
    auto cloud = good;
    cloud.fields[0].offset = offset;
    EXPECT_NE(errorTextOf([&] { hullFromMessage(cloud, sampleGrid()); }).find("no field \"x\""),
              std::string::npos)
        << offset;
    cloud.fields.push_back(good.fields[0]);
    EXPECT_EQ(errorTextOf([&] { hullFromMessage(cloud, sampleGrid()); }),
              "hull cloud has the field \"x\" twice");
  }
}

TEST(HullConversions, EveryVoxelComesBackAsItWas) {
  const VisualHull there = sampleHull();
  const auto cloud = messageFromHull(there, worldHeader());
  EXPECT_EQ(cloud.header.stamp, ros::Time(1000, 7));
  const VisualHull back = hullFromMessage(cloud, sampleGrid());
  EXPECT_EQ(back.status, HullStatus::kOk);
  EXPECT_EQ(back.lattice, there.lattice);
  ASSERT_EQ(back.voxels.size(), there.voxels.size());
  for (size_t i = 0; i < there.voxels.size(); ++i) {
    EXPECT_EQ(back.voxels[i].index, there.voxels[i].index);
    EXPECT_EQ(back.voxels[i].views, there.voxels[i].views);
    EXPECT_EQ(back.voxels[i].rgb, there.voxels[i].rgb);
    EXPECT_EQ(back.voxels[i].color_votes.votes, there.voxels[i].color_votes.votes);
    EXPECT_EQ(back.voxels[i].color_votes.possible, there.voxels[i].color_votes.possible);
  }
}

TEST(HullConversions, FloatsOfEveryPointAreAligned) {
  const auto cloud = messageFromHull(sampleHull(), worldHeader());
  EXPECT_EQ(cloud.point_step % 4, 0u);
  EXPECT_EQ(cloud.row_step, cloud.point_step * cloud.width);
  EXPECT_EQ(cloud.data.size(), size_t(cloud.row_step));
}

TEST(HullConversions, FirstPointIsTheCentreOfItsVoxel) {
  const auto cloud = messageFromHull(sampleHull(), worldHeader());
  float xyz[3];
  std::memcpy(xyz, cloud.data.data(), sizeof(xyz));
  EXPECT_FLOAT_EQ(xyz[0], -1.485f);
  EXPECT_FLOAT_EQ(xyz[1], -1.485f);
  EXPECT_FLOAT_EQ(xyz[2], 0.015f);
}

TEST(HullConversions, EmptyCloudIsNobody) {
  const VisualHull hull = hullFromMessage(messageFromHull({}, worldHeader()), sampleGrid());
  EXPECT_EQ(hull.status, HullStatus::kNobody);
  EXPECT_FALSE(hull.reason.empty());
}

TEST(HullConversions, PointOffTheGridIsRefused) {
  for (const float x : {-1.47f, 9.0f, std::numeric_limits<float>::quiet_NaN(),
                        std::numeric_limits<float>::infinity()}) {
    auto cloud = messageFromHull(sampleHull(), worldHeader());
    std::memcpy(cloud.data.data(), &x, sizeof(x));
    const std::string sentence = errorTextOf([&] { hullFromMessage(cloud, sampleGrid()); });
    EXPECT_NE(sentence.find("does not lie on the grid"), std::string::npos) << x;
  }
}

TEST(HullConversions, MissingFieldWrongFrameAndMissingBytesAreRefused) {
  auto cloud = messageFromHull(sampleHull(), worldHeader());
  cloud.fields[6].name = "something_else";
  EXPECT_THROW(hullFromMessage(cloud, sampleGrid()), std::invalid_argument);
  cloud = messageFromHull(sampleHull(), worldHeader());
  cloud.header.frame_id = "map";
  EXPECT_THROW(hullFromMessage(cloud, sampleGrid()), std::invalid_argument);
  cloud = messageFromHull(sampleHull(), worldHeader());
  cloud.data.pop_back();
  EXPECT_THROW(hullFromMessage(cloud, sampleGrid()), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
