#include "tools/export_hull/export_hull.h"

#include "clouds/cloud_file.h"
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

  /// test/clouds checks what is in such a file.
  std::string expected(const std::string& name) const {
    writeCloudFile(path(name), twoVoxels(), what_.ascii);
    return bytesOf(name);
  }

  HullExportOptions what_;
};

TEST_F(ExportHull, FirstHullWithVoxels) {
  EXPECT_EQ(exportHulls(what_), std::vector<std::string>{what_.output});
  EXPECT_EQ(bytesOf("hull.ply"), expected("expected.ply"));
}

TEST_F(ExportHull, AllHullsWithTheirStamps) {
  what_.output = path("hull.pcd");
  what_.all = what_.ascii = true;
  EXPECT_EQ(exportHulls(what_), (std::vector<std::string>{path("hull_11.000000000.pcd"),
                                                          path("hull_12.500000000.pcd")}));
  EXPECT_EQ(bytesOf("hull_12.500000000.pcd"), expected("expected.pcd"));
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
            what_.input + " has no hull with voxels on /hull/points from that time on");
  EXPECT_EQ(refused([](HullExportOptions& w) { w.topic = "/other/points"; }),
            what_.input +
                " has no point clouds on the topic \"/other/points\", it has them on "
                "/hull/points");
  EXPECT_EQ(refused([&](HullExportOptions& w) { w.output = path("no/such/folder.ply"); }),
            "cannot write " + path("no/such/folder.ply") +
                ": its folder is missing or may not be written");
  EXPECT_EQ(refused([](HullExportOptions& w) { w.input = "none.bag"; }),
            "there is no bag none.bag");
}

}  // namespace
}  // namespace markerless_mocap
