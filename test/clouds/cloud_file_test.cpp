#include "clouds/cloud_file.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl_conversions/pcl_conversions.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "error_text_of.h"
#include "markerless_mocap/ros/point_types.h"
#include "ros/hull_conversions.h"
#include "ros/segmentation_conversions.h"

namespace markerless_mocap {
namespace {

/// Voxels 0 and 5 of a lattice of 3 x 3 x 3 with 0.1 m.
VisualHull twoVoxels() {
  VisualHull hull;
  hull.lattice.origin = {1, 2, -0.05};
  hull.lattice.pitch = 0.1;
  hull.lattice.size = {3, 3, 3};
  for (const uint32_t index : {0u, 5u}) {
    HullVoxel voxel;
    voxel.index = index;
    voxel.views = uint8_t(4 + index);
    voxel.rgb = {uint8_t(10 + index), 20, 30};
    voxel.color_votes.votes = {1, 2, uint8_t(3 + index)};
    voxel.color_votes.possible = {4, 5, uint8_t(6 + index)};
    hull.voxels.push_back(voxel);
  }
  return hull;
}

template <class Points>
void expectTwoVoxels(const Points& points) {
  ASSERT_EQ(points.size(), 2u);
  const HullPoint& last = points[1];
  EXPECT_FLOAT_EQ(last.x, 1.25f);
  EXPECT_FLOAT_EQ(last.y, 2.15f);
  EXPECT_NEAR(last.z, 0.0f, 1e-6f);
  EXPECT_EQ(int(last.r), 15);
  EXPECT_EQ(int(last.g), 20);
  EXPECT_EQ(int(last.b), 30);
  EXPECT_EQ(int(last.views), 9);
  EXPECT_EQ(int(last.votes_x), 1);
  EXPECT_EQ(int(last.votes_z), 8);
  EXPECT_EQ(int(last.possible_y), 5);
  EXPECT_EQ(int(last.possible_z), 11);
}

// The same conversion as in a subscriber to pcl::PointCloud<HullPoint>.
TEST(PointTypes, HullsAreReadFieldByField) {
  pcl::PointCloud<HullPoint> points;
  pcl::fromROSMsg(messageFromHull(twoVoxels(), std_msgs::Header()), points);
  expectTwoVoxels(points);
}

TEST(PointTypes, LabelsAreReadFieldByField) {
  BodyParts parts;
  parts.labels = {uint8_t(PartLabel::kHead), uint8_t(PartLabel::kLeg2)};
  pcl::PointCloud<SegmentationPoint> points;
  pcl::fromROSMsg(labelledCloud(twoVoxels(), parts, std_msgs::Header()), points);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_FLOAT_EQ(points[1].x, 1.25f);
  EXPECT_EQ(points[0].label, uint8_t(PartLabel::kHead));
  EXPECT_EQ(points[1].label, uint8_t(PartLabel::kLeg2));
  EXPECT_EQ(points[1].r, partColor(PartLabel::kLeg2)[0]);
  EXPECT_EQ(points[1].b, partColor(PartLabel::kLeg2)[2]);
}

class CloudText : public ::testing::Test {
 protected:
  CloudText()
      : folder_(std::filesystem::temp_directory_path() /
                ("mocap_clouds_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~CloudText() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string textOf(const std::string& name) const {
    writeCloudFile(path(name), twoVoxels(), true);
    std::ifstream file(path(name));
    return std::string(std::istreambuf_iterator<char>(file), {});
  }

  std::filesystem::path folder_;
};

/// The parameter says whether the file is text.
class CloudFile : public CloudText, public ::testing::WithParamInterface<bool> {};

TEST_P(CloudFile, PcdIsReadBackWhole) {
  writeCloudFile(path("hull.pcd"), twoVoxels(), GetParam());
  pcl::PointCloud<HullPoint> points;
  ASSERT_EQ(pcl::io::loadPCDFile(path("hull.pcd"), points), 0);
  expectTwoVoxels(points);
}

TEST_P(CloudFile, PlyIsReadBackWithPlaceAndColor) {
  writeCloudFile(path("hull.ply"), twoVoxels(), GetParam());
  pcl::PointCloud<pcl::PointXYZRGB> points;
  ASSERT_EQ(pcl::io::loadPLYFile(path("hull.ply"), points), 0);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_FLOAT_EQ(points[1].x, 1.25f);
  EXPECT_FLOAT_EQ(points[1].y, 2.15f);
  EXPECT_EQ(int(points[1].r), 15);
  EXPECT_EQ(int(points[1].b), 30);
}

// Read as the formats describe their text, without PCL: 10 * 65536 + 20 * 256 + 30 and five more
// red.
TEST_F(CloudText, HasTheFieldsOfEachPointInALine) {
  const std::string pcd = textOf("hull.pcd");
  EXPECT_NE(pcd.find("\nFIELDS x y z rgb views votes_x votes_y votes_z possible_x possible_y "
                     "possible_z\n"),
            std::string::npos);
  EXPECT_NE(pcd.find("\nPOINTS 2\n"), std::string::npos);
  EXPECT_EQ(pcd.substr(pcd.find("DATA ascii\n") + 11),
            "1.05 2.05 0 660510 4 1 2 3 4 5 6\n1.25 2.15 0 988190 9 1 2 8 4 5 11\n");
  const std::string ply = textOf("hull.ply");
  EXPECT_EQ(ply.find("ply\nformat ascii 1.0\n"), 0u);
  EXPECT_NE(ply.find("\nelement vertex 2\nproperty float x\n"), std::string::npos);
  EXPECT_NE(ply.find("\nproperty uchar views\n"), std::string::npos);
  EXPECT_EQ(ply.substr(ply.find("end_header\n") + 11),
            "1.05 2.05 0 10 20 30 4 1 2 3 4 5 6\n1.25 2.15 0 15 20 30 9 1 2 8 4 5 11\n");
}

TEST_P(CloudFile, NothingIsLeftOfAFileThatCannotBeWritten) {
  EXPECT_EQ(
      errorTextOf<std::runtime_error>(
          [&] { writeCloudFile(path("no/hull.ply"), twoVoxels(), GetParam()); }),
      "cannot write " + path("no/hull.ply") + ": its folder is missing or may not be written");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

INSTANTIATE_TEST_SUITE_P(Ascii, CloudFile, ::testing::Bool());

}  // namespace
}  // namespace markerless_mocap
