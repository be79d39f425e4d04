#include "tools/export_hull/export_hull.h"

#include <cstring>

#include "ros/hull_conversions.h"
#include "tools/common/bag_io.h"
#include "tools/tool_fixture.h"

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
    hull.voxels.push_back(voxel);
  }
  return hull;
}

std::string bodyAfter(const std::string& file, const std::string& header_end) {
  return file.substr(file.find(header_end) + header_end.size());
}

TEST(HullFiles, AsciiPcd) {
  const std::string file = pcdOf(twoVoxels(), true);
  EXPECT_NE(file.find("\nFIELDS x y z rgb views\nSIZE 4 4 4 4 1\nTYPE F F F U U\n"),
            std::string::npos);
  EXPECT_NE(file.find("\nPOINTS 2\n"), std::string::npos);
  // 10 * 65536 + 20 * 256 + 30 and five more red
  EXPECT_EQ(bodyAfter(file, "DATA ascii\n"), "1.05 2.05 0 660510 4\n1.25 2.15 0 988190 9\n");
}

TEST(HullFiles, AsciiPly) {
  const std::string file = plyOf(twoVoxels(), true);
  EXPECT_EQ(file.find("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"), 0u);
  EXPECT_EQ(bodyAfter(file, "end_header\n"), "1.05 2.05 0 10 20 30 4\n1.25 2.15 0 15 20 30 9\n");
}

TEST(HullFiles, BinaryHoldsTheSameNumbers) {
  const std::string pcd = bodyAfter(pcdOf(twoVoxels(), false), "DATA binary\n");
  ASSERT_EQ(pcd.size(), 2u * 17);
  float x;
  std::memcpy(&x, pcd.data() + 17, 4);
  EXPECT_FLOAT_EQ(x, 1.25f);
  uint32_t rgb;
  std::memcpy(&rgb, pcd.data() + 17 + 12, 4);
  EXPECT_EQ(rgb, 988190u);
  EXPECT_EQ(pcd[33], 9);
  const std::string ply = bodyAfter(plyOf(twoVoxels(), false), "end_header\n");
  ASSERT_EQ(ply.size(), 2u * 16);
  EXPECT_EQ(ply.substr(16 + 12), std::string("\x0f\x14\x1e\x09"));
}

class ExportHull : public ToolTest {
 protected:
  /// No person at 10 s, two voxels at 11 s and 12.5 s.
  ExportHull() {
    what_.input = path("in.bag");
    what_.output = path("hull.ply");
    BagWriter bag(what_.input);
    std_msgs::Header header;
    header.frame_id = "world";
    header.stamp = ros::Time(10.0);
    bag.write("/hull/grid", header.stamp, messageFromLattice(twoVoxels().lattice, header));
    for (const double stamp : {10.0, 11.0, 12.5}) {
      header.stamp = ros::Time(stamp);
      const VisualHull hull = stamp > 10 ? twoVoxels() : VisualHull();
      bag.write("/hull/points", header.stamp, messageFromHull(hull, header));
    }
    bag.commit();
  }

  HullExportOptions what_;
};

TEST_F(ExportHull, FirstHullWithVoxels) {
  EXPECT_EQ(exportHulls(what_), std::vector<std::string>{what_.output});
  EXPECT_EQ(bytesOf("hull.ply"), plyOf(twoVoxels(), false));
}

TEST_F(ExportHull, AllHullsWithTheirStamps) {
  what_.output = path("hull.pcd");
  what_.all = what_.ascii = true;
  EXPECT_EQ(exportHulls(what_), (std::vector<std::string>{path("hull_11.000000000.pcd"),
                                                          path("hull_12.500000000.pcd")}));
  EXPECT_EQ(bytesOf("hull_12.500000000.pcd"), pcdOf(twoVoxels(), true));
}

TEST_F(ExportHull, BadCallsAreRefused) {
  const auto refused = [&](auto change) {
    HullExportOptions what = what_;
    change(what);
    return errorTextOf<std::exception>([&] { exportHulls(what); });
  };
  EXPECT_EQ(refused([](HullExportOptions& w) { w.output = "hull.obj"; }),
            "output is hull.obj, allowed are names that end in .pcd or .ply");
  EXPECT_EQ(refused([](HullExportOptions& w) { w.at = 3; }),
            "the bag has no hull with voxels on /hull/points from that time on");
  EXPECT_EQ(refused([](HullExportOptions& w) { w.topic = "/other/points"; }),
            "the bag has no /other/grid");
  EXPECT_EQ(refused([&](HullExportOptions& w) { w.output = path("no/such/folder.ply"); }),
            "cannot write " + path("no/such/folder.ply"));
  EXPECT_EQ(refused([](HullExportOptions& w) { w.input = "none.bag"; }),
            "there is no bag none.bag");
}

}  // namespace
}  // namespace markerless_mocap
