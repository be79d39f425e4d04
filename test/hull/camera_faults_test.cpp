#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

/// Expects the hull that the other cameras make without `bad`, which is reported.
void expectLeftOut(const CameraRig& rig, const std::vector<HullView>& views, size_t bad,
                   const std::string& reason) {
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  ASSERT_EQ(hull.cameras_left_out.size(), 1u);
  EXPECT_EQ(hull.cameras_left_out[0].name, rig[bad].name());
  EXPECT_EQ(hull.cameras_left_out[0].reason, reason);
  std::vector<HullView> others = views;
  others[bad] = {};
  EXPECT_EQ(indices(hull), indices(HullCarver(rig, makeOptions()).carve(others)));
  EXPECT_EQ(hull.voxels[0].views, int(rig.size()) - 1);
}

TEST(CameraFaults, NobodyIsLeftOutOfAGoodInstant) {
  const CameraRig rig = makeRig(6);
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(renderViews(rig, {Sphere()}));
  EXPECT_TRUE(hull.cameras_left_out.empty());
}

TEST(CameraFaults, EmptyMaskBeforeAPerson) {
  for (const int cameras : {3, 4, 8}) {
    const CameraRig rig = makeRig(cameras);
    std::vector<HullView> views = renderViews(rig, {Sphere()});
    views[2].mask.setTo(0);
    expectLeftOut(rig, views, 2, "its mask is empty, but other cameras see a person in its view");
  }
}

TEST(CameraFaults, FullMask) {
  const CameraRig rig = makeRig(5);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  views[1].mask.setTo(255);
  views[1].mask.rowRange(0, 5).setTo(0);
  expectLeftOut(rig, views, 1, "its mask is full");
}

TEST(CameraFaults, MaskThatLacksThePerson) {
  const CameraRig rig = makeRig(6);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  views[4].mask = 255 - views[4].mask;
  expectLeftOut(rig, views, 4, "its mask lacks a person on whom the other cameras agree");
  views[4].mask.setTo(0);  // something stands in a corner of the image, the person is not there
  views[4].mask(cv::Rect(0, 0, 40, 30)).setTo(255);
  expectLeftOut(rig, views, 4, "its mask lacks a person on whom the other cameras agree");
}

TEST(CameraFaults, EmptyMaskOfACameraThatLooksElsewhereIsRight) {
  CameraRig rig = makeRig(6);
  rig.push_back(makeCamera("edge", {-2, 0, 3}, {-2, 5, 0}));
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  ASSERT_EQ(cv::countNonZero(views[6].mask), 0);
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  EXPECT_EQ(hull.status, HullStatus::kOk);
  EXPECT_TRUE(hull.cameras_left_out.empty());
}

TEST(CameraFaults, TwoOfSix) {
  const CameraRig rig = makeRig(6);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  views[0].mask.setTo(0);
  views[3].mask.setTo(255);
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  EXPECT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_EQ(hull.cameras_left_out.size(), 2u);
}

TEST(CameraFaults, HalfOfTheCamerasIsTooMuchToLeaveOut) {
  const CameraRig rig = makeRig(6);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  for (const size_t c : {0, 2, 4}) views[c].mask.setTo(0);
  const VisualHull hull = HullCarver(rig, makeOptions()).carve(views);
  EXPECT_EQ(hull.status, HullStatus::kNobody);
  EXPECT_TRUE(hull.cameras_left_out.empty());
  EXPECT_NE(hull.reason.find("the mask of 'cam0', 'cam2', 'cam4' is empty"), std::string::npos);
}

TEST(CameraFaults, OneMaskAloneIsNobody) {
  const CameraRig rig = makeRig(6);
  std::vector<HullView> views = renderViews(rig, {});
  views[1].mask(cv::Rect(60, 40, 40, 40)).setTo(255);
  EXPECT_EQ(HullCarver(rig, makeOptions()).carve(views).status, HullStatus::kNobody);
}

TEST(CameraTrust, HalfTrustedCamerasFellAVoxelOnlyTogether) {
  const CameraRig rig = makeRig(8);
  HullOptions options = makeOptions();
  options.leave_out_bad_cameras = false;
  options.camera_trust = {"cam2=0.5", "cam5=0.5"};
  const std::vector<HullView> good = renderViews(rig, {Sphere()});
  std::vector<HullView> views = good;
  views[2].mask.setTo(0);
  HullCarver carver(rig, options);
  EXPECT_EQ(carver.carve(views).status, HullStatus::kOk);
  views[5].mask.setTo(0);
  EXPECT_EQ(carver.carve(views).status, HullStatus::kNobody);
  views = good;
  views[0].mask.setTo(0);
  EXPECT_EQ(carver.carve(views).status, HullStatus::kNobody);
}

TEST(CameraTrust, NoTrustIsNoVote) {
  const CameraRig rig = makeRig(6);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  HullOptions options = makeOptions();
  options.camera_trust = {"cam3=0"};
  const std::vector<uint32_t> untrusted = indices(HullCarver(rig, options).carve(views));
  views[3] = {};
  EXPECT_EQ(untrusted, indices(HullCarver(rig, makeOptions()).carve(views)));
}

TEST(CameraTrust, BadEntriesAreRefused) {
  for (const std::string entry : {"cam9=0.5", "cam1", "cam1=", "cam1=1.5", "cam1=x", "cam1=0.5x"}) {
    HullOptions options = makeOptions();
    options.camera_trust = {entry};
    try {
      HullCarver(makeRig(4), options);
      ADD_FAILURE() << entry;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()), "visual_hull/camera_trust has '" + entry +
                                               "', allowed is <camera of the rig>=<0 to 1>");
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
