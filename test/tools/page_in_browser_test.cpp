#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>

#include "tools/common/person_urdf.h"
#include "tools/common/player.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr int kFrames = 60, kLostFrom = 20, kLostTo = 25;

/// Pages as Chromium shows them, by scripts/check_page, and as scripts/plot reads them.
class PageInBrowser : public ToolTest {
 protected:
  /// \return the status of check_page
  int statusOf(const std::string& html) const {
    writeText("page.html", html);
    const std::string command = std::string(MOCAP_SOURCE_DIR) + "/scripts/check_page '" +
                                path("page.html") + "' > '" + path("said") + "' 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string said() const { return bytesOf("said"); }
};

/// A person who walks on, is lost and is found again.
std::vector<ResultFrame> walk(const BodyModel& body) {
  std::vector<ResultFrame> frames;
  for (int f = 0; f < kFrames; ++f) {
    ResultFrame frame;
    frame.stamp_ns = f * int64_t(33333333);
    const bool lost = f >= kLostFrom && f < kLostTo;
    frame.status = lost ? FrameStatus::kLost : FrameStatus::kTracked;
    frame.reason = lost ? "nobody is <there>" : "";
    Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
    T_world_body.translation() << 0.02 * f, 0.0, 0.95;
    Eigen::VectorXd angles = Eigen::VectorXd::Zero(body.angleCount());
    angles[body.angleIndex("l_knee")] = -0.5 - 0.5 * std::sin(0.2 * f);
    if (!lost) body.forwardKinematics(T_world_body, angles, frame.T_world_link);
    if (f > 40) frame.T_world_link[size_t(body.linkIndex("r_wrist"))].matrix().setConstant(NAN);
    frame.part_sigma_m.fill(0.01);
    frames.push_back(frame);
  }
  return frames;
}

VisualHull smallHull() {
  VisualHull hull;
  hull.lattice.size = {20, 20, 60};
  for (uint32_t index = 0; index < hull.lattice.count(); index += 3) {
    hull.voxels.emplace_back();
    hull.voxels.back().index = index;
  }
  return hull;
}

CameraRig ring() {
  CameraRig rig;
  for (const CameraCalibration& camera : ringOfFour()) rig.emplace_back(camera);
  return rig;
}

PlayerViews someViews(const CameraRig& rig) {
  PlayerViews views;
  for (size_t frame = 0; frame < size_t(kFrames); frame += 10)
    views.add(frame, rig, std::vector<CameraFrame>(4, {smallImage(true), cv::Mat()}),
              std::vector<cv::Mat>(4, smallMask()), {});
  return views;
}

JointTrack someTruth() {
  JointTrack truth;
  truth.names = {"pelvis", "thorax", "head"};
  Eigen::Matrix3d points;
  points << 0, 0, 0, 0, 0, 0, 0.95, 1.4, 1.6;
  for (int f = 0; f < kFrames; ++f) truth.add(f, points);
  return truth;
}

TEST_F(PageInBrowser, PlaysSeeksAndSaysWhyAPoseIsLost) {
  const BodyModel body = BodyModel::fromUrdf(bodyUrdf("", "person1", 1.75), "person1");
  const std::vector<ResultFrame> frames = walk(body);
  const CameraRig rig = ring();
  const JointTrack truth = someTruth();
  const PlayerViews views = someViews(rig);
  PlayerHulls hulls;
  hulls.add(0, smallHull());
  hulls.add(30, VisualHull());
  Page page("A walk");
  page.add(playerPart({&body, true, &frames, &rig, &hulls, &views, &truth, {}}));
  addMotionPlots(body, frames, &page);
  EXPECT_EQ(statusOf(page.html()), 0) << said();
  EXPECT_NE(said().find("nobody is <there>"), std::string::npos) << said();
  EXPECT_NE(said().find("r_arm not seen"), std::string::npos) << said();
}

TEST_F(PageInBrowser, ShowsTheOtherParts) {
  Page page("Parts");
  page.cards({{"1 mm", "an error"}});
  page.table({"a", "#b"}, {{"x", "1"}});
  page.lines({0, 1, 2}, "s", {{"x", {1, NAN, -3}}}, "mm");
  page.bars({"a", "b"}, {{"row", {1, NAN}}}, "mm");
  page.histogram({1, 2, 2, NAN}, "mm");
  page.picture(smallImage(true), "a picture");
  page.add({{"kind", "residuals"},
            {"longer", 20},
            {"cameras",
             {{{"name", "c"},
               {"size", {80, 60}},
               {"used", packed(std::vector<double>{1, 2, 3, 4})},
               {"left_out", ""}}}}});
  EXPECT_EQ(statusOf(page.html()), 0) << said();
}

TEST_F(PageInBrowser, AFaultInAPageIsFound) {
  Page page("Fault");
  page.text("before");
  page.add({{"kind", "nothing that templates/ knows"}});
  EXPECT_EQ(statusOf(page.html()), 1) << said();
  EXPECT_NE(said().find("is not a function"), std::string::npos) << said();
}

TEST_F(PageInBrowser, ItsPlotsCanBePrinted) {
  Page page("Plots");
  page.heading("An error");
  page.lines({0, 1, 2}, "s", {{"x", {1, NAN, -3}}}, "mm");
  writeText("page.html", page.html());
  const auto plot = [&](const std::string& name) {
    return std::system((std::string(MOCAP_SOURCE_DIR) + "/scripts/plot '" + path(name) +
                        "' --out '" + path("plots") + "' > '" + path("said") + "' 2>&1")
                           .c_str());
  };
  EXPECT_EQ(plot("page.html"), 0) << said();
  EXPECT_EQ(bytesOf("plots/00_an_error.pdf").substr(0, 4), "%PDF");
  writeText("other.html", "<html></html>");
  EXPECT_NE(plot("other.html"), 0);
  EXPECT_NE(said().find("it is no page of this package"), std::string::npos) << said();
}

}  // namespace
}  // namespace markerless_mocap
