#include "capture/cameras/camera_rigs.h"

#include <gtest/gtest.h>

#include "capture/studio_fixture.h"
#include "markerless_mocap/camera/rig_file.h"

namespace markerless_mocap {
namespace {

RigPlan planOf(const std::string& kind) {
  RigPlan plan;
  plan.kind = kind;
  return plan;
}

std::vector<CameraCalibration> calibrations(const CameraRig& rig) {
  std::vector<CameraCalibration> out;
  for (const Camera& camera : rig) out.push_back(camera.calibration());
  return out;
}

TEST(RigsTest, everyCameraOfEveryRigSeesTheWholeStage) {
  for (const std::string& kind : rigKinds())
    for (const auto& [width, height] : {std::pair(640, 480), {320, 240}, {1280, 720}, {300, 400}})
      for (const double k1 : {0.0, -0.15}) {
        RigPlan plan = planOf(kind);
        plan.width = width;
        plan.height = height;
        plan.distortion_k1 = k1;
        for (const Camera& camera : makeRig(plan)) {
          int seen = 0, all = 0;
          for (const Eigen::Vector3d& point : volumePoints()) {
            seen += bool(camera.projectInside(point));
            ++all;
          }
          // The random rig's lenses may be a little too long.
          EXPECT_GE(seen, kind == "random8" ? 0.9 * all : all) << kind << ' ' << camera.name();
        }
      }
}

TEST(RigsTest, aTallPersonWithRaisedArmsIsInViewAnywhereOnTheStage) {
  for (const char* kind : {"ring8", "ring7_overhead", "ring4", "ceiling4"})
    for (const Camera& camera : makeRig(planOf(kind)))
      for (const double x : {-0.9, 0.0, 0.9})
        for (const double y : {-0.9, 0.0, 0.9})
          for (const double z : {0.0, 2.4})
            EXPECT_TRUE(camera.projectInside({x, y, z})) << kind << ' ' << camera.name();
}

TEST(RigsTest, imagesAreFilledByTheStage) {
  for (const std::string& kind : rigKinds())
    for (const Camera& camera : makeRig(planOf(kind))) {
      double farthest = 0.0;
      for (const Eigen::Vector3d& point : volumePoints()) {
        const Eigen::Vector2d p = camera.project(point).value();
        farthest =
            std::max({farthest, std::abs(p.x() - 319.5) / 320.0, std::abs(p.y() - 239.5) / 240.0});
      }
      EXPECT_GT(farthest, 0.8) << kind;
    }
}

TEST(RigsTest, camerasStandWhereTheNameSays) {
  const CameraRig ring = makeRig(planOf("ring8"));
  ASSERT_EQ(ring.size(), 8u);
  for (const Camera& camera : ring) {
    EXPECT_NEAR(camera.position().head<2>().norm(), 4.2, 1e-12);
    EXPECT_LT((*camera.project({0, 0, 1}) - Eigen::Vector2d(319.5, 239.5)).norm(), 1e-6);
    EXPECT_LT(camera.project({0, 0, 1.5})->y(), 239.0);  // upright
  }
  EXPECT_EQ(ring[3].name(), "cam3");
  const CameraRig overhead = makeRig(planOf("ring7_overhead"));
  ASSERT_EQ(overhead.size(), 8u);
  EXPECT_EQ(overhead[7].position(), Eigen::Vector3d(0, 0, 4.6));
  EXPECT_EQ(makeRig(planOf("ring4")).size(), 4u);
  for (const Camera& camera : makeRig(planOf("ceiling4"))) EXPECT_EQ(camera.position().z(), 2.7);
}

TEST(RigsTest, theRandomRigIsItsSeeds) {
  RigPlan plan = planOf("random8"), other = plan;
  other.seed = 2;
  const std::string text = rigText(calibrations(makeRig(plan)));
  EXPECT_EQ(rigText(calibrations(makeRig(plan))), text);
  EXPECT_NE(rigText(calibrations(makeRig(other))), text);
  const CameraRig rig = makeRig(plan);
  EXPECT_NE(rig[0].calibration().D, rig[1].calibration().D);
  EXPECT_NE(rig[0].calibration().K(0, 0), rig[1].calibration().K(0, 0));
}

TEST(RigsTest, aRigFileKeepsTheRigBitByBit) {
  const auto rig = calibrations(makeRig(planOf("random8")));
  const auto read = rigFromText(rigText(rig), "rig.yaml");
  for (size_t i = 0; i < rig.size(); ++i) {
    EXPECT_EQ(read[i].T_world_camera.matrix(), rig[i].T_world_camera.matrix());
    EXPECT_EQ(read[i].K, rig[i].K);
  }
}

TEST(RigsTest, faultsAreNamed) {
  EXPECT_EQ(errorTextOf([] { makeRig(planOf("ring5")); }),
            "the rig is \"ring5\", allowed are ring8, ring7_overhead, ring4, ring16, ceiling4, "
            "random8, wide6 or path of a rig file with the ending .yaml");
  EXPECT_EQ(errorTextOf([] {
              lookAt({1, 2, 3}, {1, 2, 3});
            }),
            "a camera cannot look at the point where it is");
}

}  // namespace
}  // namespace markerless_mocap
