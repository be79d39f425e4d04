#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <cmath>

#include "error_text_of.h"
#include "nodes/common/sender_watch.h"
#include "nodes/pose_fitting/converted_products.h"
#include "ros/world_header.h"

namespace markerless_mocap {
namespace {

VoxelGridConstPtr gridOf(double pitch, double stamp) {
  VoxelLattice lattice;
  lattice.pitch = pitch;
  lattice.size = {10, 10, 10};
  const auto grid = boost::make_shared<VoxelGrid>(messageFromLattice(lattice, worldHeader()));
  grid->header.stamp = ros::Time(stamp);
  return grid;
}

sensor_msgs::PointCloud2Ptr cloudOn(const VoxelGrid& grid, double stamp) {
  VisualHull hull;
  hull.lattice = latticeFromMessage(grid);
  hull.voxels.resize(2);
  hull.voxels[0].index = 123;
  hull.voxels[1].index = 777;
  const auto cloud =
      boost::make_shared<sensor_msgs::PointCloud2>(messageFromHull(hull, worldHeader()));
  cloud->header.stamp = ros::Time(stamp);
  return cloud;
}

TEST(HullGrids, AGridThatIsNoneIsToldAndForgotten) {
  HullGrids grids;
  EXPECT_EQ(grids.add(gridOf(0.03, 1.0)), "");
  const auto bad = boost::make_shared<VoxelGrid>(*gridOf(0.03, 2.0));
  bad->pitch = std::nan("");
  EXPECT_NE(grids.add(bad).find("hull/grid has sent what cannot be used: voxel grid is unusable"),
            std::string::npos);
  EXPECT_EQ(grids.hullOf(*cloudOn(*gridOf(0.03, 1.0), 3.0)).voxels.size(), 2u);
}

TEST(HullGrids, AGridThatTheHullDoesNotLieOnCostsNothing) {
  HullGrids grids;
  const VoxelGridConstPtr right = gridOf(0.03, 1.0);
  grids.add(right);
  for (int i = 0; i < 100; ++i)  // of another node, all the time
    for (const double pitch : {0.02, 0.05}) grids.add(gridOf(pitch, 2.0 + 0.01 * i));
  EXPECT_EQ(grids.hullOf(*cloudOn(*right, 9.0)).lattice.pitch, 0.03);
  EXPECT_NE(errorTextOf([&] {
              grids.hullOf(*cloudOn(*gridOf(0.07, 9.0), 9.0));
            }).find("hull cloud does not lie on the grid"),
            std::string::npos);
}

TEST(HullGrids, AHullHasTheGridOfItsTime) {
  HullGrids grids;
  EXPECT_EQ(errorTextOf([&] { grids.hullOf({}); }), "no hull/grid has been received yet");
  grids.add(gridOf(0.03, 1.0));
  grids.add(gridOf(0.01, 5.0));
  // An empty hull lies on every grid.
  sensor_msgs::PointCloud2Ptr empty = cloudOn(*gridOf(0.03, 1.0), 3.0);
  empty->width = 0;
  empty->data.clear();
  EXPECT_EQ(grids.hullOf(*empty).lattice.pitch, 0.03);
  empty->header.stamp = ros::Time(6.0);
  EXPECT_EQ(grids.hullOf(*empty).lattice.pitch, 0.01);
  empty->header.stamp = ros::Time(0.5);  // a bag that begins again
  EXPECT_EQ(grids.hullOf(*empty).lattice.pitch, 0.01);
}

TEST(ConvertedProducts, AMessageThatCannotBeUsedCostsItsProductOnly) {
  ProductMessages messages;
  messages.grids.add(gridOf(0.03, 1.0));
  messages.hull = cloudOn(*gridOf(0.03, 1.0), 2.0);
  PoseTree good;
  good.nodes.push_back({Eigen::Vector3d(0, 0, 1), -1, TreePart::kTorso});
  const auto tree = boost::make_shared<PoseTreeMsg>(messageFromPoseTree(good, worldHeader()));
  messages.tree = tree;
  const auto parts = boost::make_shared<BodyPartsMsg>(messageFromParts({}, worldHeader()));
  messages.parts = parts;
  messages.labels =
      boost::make_shared<sensor_msgs::PointCloud2>(labelledCloud({}, {}, worldHeader()));
  std::vector<std::string> faults;
  EXPECT_EQ(convertedProducts(messages, &faults).hull.voxels.size(), 2u);
  EXPECT_TRUE(faults.empty());

  tree->rank = std::nan("");
  parts->status = 77;
  FrameProducts products = convertedProducts(messages, &faults);
  EXPECT_EQ(products.hull.voxels.size(), 2u);
  EXPECT_TRUE(products.tree.nodes.empty());
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0],
            "segmentation/parts has sent what cannot be used: BodyParts has the status 77, allowed "
            "are 0 to 2");
  EXPECT_EQ(faults[1],
            "pose_tree has sent what cannot be used: PoseTree has a rank or validity that is not "
            "finite");

  faults.clear();
  tree->rank = 0.5;
  const auto hull = boost::make_shared<sensor_msgs::PointCloud2>(*messages.hull);
  hull->width = hull->height = 1u << 31;
  messages.hull = hull;
  products = convertedProducts(messages, &faults);
  EXPECT_TRUE(products.hull.voxels.empty());
  EXPECT_EQ(products.tree.nodes.size(), 1u);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_NE(faults[0].find("hull/points has sent what cannot be used: hull cloud has"),
            std::string::npos);
}

TEST(SenderWatch, OnlyTheFirstOfTwoSendersCounts) {
  SenderWatch watch;
  for (double now = 0.0; now < 3.0; now += 0.1) {
    EXPECT_TRUE(watch.accept("/stage", now));
    if (now > 1.0) {
      EXPECT_FALSE(watch.accept("/other", now + 0.05));
    }
  }
  EXPECT_EQ(watch.sender(), "/stage");
}

TEST(SenderWatch, AnotherOneTakesOverWhenTheFirstIsSilent) {
  SenderWatch watch;
  double now = 0.0;
  for (; now < 3.0; now += 0.1) watch.accept("/driver", now);
  EXPECT_FALSE(watch.accept("/driver_2", now + 0.1));
  EXPECT_TRUE(watch.accept("/driver_2", now + 0.6));
  EXPECT_TRUE(watch.accept("/driver_2", now + 0.7));
  EXPECT_FALSE(watch.accept("/driver", now + 0.75));
  EXPECT_EQ(watch.sender(), "/driver_2");
  EXPECT_EQ(watch.firstSender(), "/driver");
}

TEST(SenderWatch, ASlowSenderIsNotSilentBetweenItsMessages) {
  SenderWatch watch;
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(watch.accept("/slow", i));
    if (i > 5) {
      EXPECT_FALSE(watch.accept("/other", i + 0.9));
    }
  }
  EXPECT_TRUE(watch.accept("/other", 13.0));
}

}  // namespace
}  // namespace markerless_mocap
