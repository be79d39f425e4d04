#include "tools/offline/self_calibration_run.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_msgs/TFMessage.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "contour/rig_shift.h"
#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/package_files.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/common/studio_settings.h"
#include "tools/render/render_capture.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr size_t kTurned = 2;  // camera
constexpr int kBlock = 20;     // pixels

class SelfCalibrationRun : public ToolTest {
 protected:
  SelfCalibrationRun() {
    run_.input = path("film.bag");
    run_.output = path("out.bag");
    run_.recording.use_masks = true;
  }

  /// Somebody walks in a circle within four cameras.
  void film(const std::string& images = "none") {
    RenderOptions film;
    film.output = run_.input;
    film.files.urdf_template = readText(packageFile("urdf/human.urdf.in"));
    film.files.motions_folder = packageFile("config/motions");
    film.studio.motion = "walk_in_circle";
    film.studio.rig = "ring4";
    film.studio.width = 320;
    film.studio.height = 240;
    film.studio.background_frames = 0;
    film.studio.fps = 10.0;
    film.studio.duration = 3.0;
    film.images = images;
    film.masks = true;
    renderCapture(film, nullptr, false);
    truth_ = Recording(run_.input, run_.recording).rig();
  }

  /// A fifth of every silhouette becomes unknown, in blocks that stay where they are.
  void forgetBackground() {
    const std::string known = run_.input;
    run_.input = path("unknown.bag");
    rosbag::Bag from(known);
    rosbag::Bag to(run_.input, rosbag::bagmode::Write);
    for (const rosbag::MessageInstance& entry : rosbag::View(from)) {
      const auto image = entry.instantiate<sensor_msgs::Image>();
      if (!image || image->encoding != "mono8") {
        to.write(entry.getTopic(), entry.getTime(), entry);
        continue;
      }
      const cv::Mat mask = maskFromMessage(*image);
      const int camera = entry.getTopic().at(4) - '0';  // of /cam0/silhouette
      for (int y = 0; y < mask.rows / kBlock; ++y)
        for (int x = 0; x < mask.cols / kBlock; ++x)
          if ((7 * y + 3 * x + camera) % 5 == 0)
            mask(cv::Rect(x * kBlock, y * kBlock, kBlock, kBlock)).setTo(128);
      to.write(entry.getTopic(), entry.getTime(), messageFromMat(mask, image->header));
    }
  }

  /// Tells the run of a rig with one camera that points so far past where it does.
  void tellTurned(double pixels) {
    std::vector<CameraCalibration> told;
    for (const Camera& camera : truth_) told.push_back(camera.calibration());
    CameraCalibration& turned = told[kTurned];
    turned.T_world_camera.rotate(
        Eigen::AngleAxisd(pixels / turned.K(0, 0), Eigen::Vector3d::UnitY()));
    run_.recording.rig = path("told.yaml");
    writeRig(run_.recording.rig, told);
  }

  CameraRig rigOf(const std::string& file) const {
    CameraRig rig;
    for (const CameraCalibration& camera : readRig(path(file))) rig.emplace_back(camera);
    return rig;
  }
  /// The static ones, by child.
  static std::map<std::string, Eigen::Isometry3d> transformsIn(const std::string& path) {
    std::map<std::string, Eigen::Isometry3d> transforms;
    rosbag::Bag bag(path);
    for (const auto& entry : rosbag::View(bag, rosbag::TopicQuery("/tf_static")))
      for (const auto& one : entry.instantiate<tf2_msgs::TFMessage>()->transforms)
        transforms[one.child_frame_id] = tf2::transformToEigen(one);
    return transforms;
  }
  double pixelsOff(const CameraRig& rig) const {
    return relative(truth_, shiftBetween(truth_, rig)).norm();
  }

  OfflineOptions run_;
  CameraRig truth_;
};

TEST_F(SelfCalibrationRun, FindsTheTurnedCameraToHalfAPixel) {
  film();
  tellTurned(4.0);
  ASSERT_GT(pixelsOff(rigOf("told.yaml")), 2.5);
  const OrientationRefinement found = selfCalibrate(run_, path("found.yaml"));
  EXPECT_EQ(found.status, OrientationRefinementStatus::kCorrected);
  EXPECT_LT(pixelsOff(rigOf("found.yaml")), 0.5);
  for (size_t c = 0; c < truth_.size(); ++c)
    EXPECT_LE(found.corrections[c].turn,
              found.corrections[kTurned].turn * (c == kTurned ? 1 : 0.5));
  const std::vector<std::string> sentences = calibrationMessages(found, path("found.yaml"));
  ASSERT_EQ(sentences.size(), 2 + truth_.size());
  EXPECT_EQ(sentences[0].rfind("self-calibration: the camera orientations are corrected: in ", 0),
            0u)
      << sentences[0];
  EXPECT_EQ(sentences[1 + kTurned].rfind("cam2 is rotated by 0.", 0), 0u) << sentences[1 + kTurned];
  EXPECT_EQ(sentences.back(), "the corrected rig is written to " + path("found.yaml"));

  run_.recording.rig = path("found.yaml");
  runOffline(run_, nullptr, false);
  const std::map<std::string, Eigen::Isometry3d> T_world = transformsIn(run_.output);
  for (const Camera& camera : found.rig)
    EXPECT_TRUE(T_world.at(opticalFrame(camera.name()))
                    .isApprox(camera.calibration().T_world_camera, 1e-9));
}

TEST_F(SelfCalibrationRun, ColoursDoWhereTheBackgroundIsUnknown) {
  film("raw");
  forgetBackground();
  tellTurned(4.0);
  const OrientationRefinement found = selfCalibrate(run_, path("found.yaml"));
  EXPECT_EQ(found.status, OrientationRefinementStatus::kCorrected);
  EXPECT_LT(pixelsOff(rigOf("found.yaml")), 0.8);
}

TEST_F(SelfCalibrationRun, ARunSaysThatTheCalibrationIsWrongAndUsesItAsItIs) {
  film();
  tellTurned(4.0);
  const RunSummary summary = runOffline(run_, nullptr, false);
  const std::string& finding = summary.calibrationFinding();
  EXPECT_EQ(finding.rfind("the calibration looks wrong: the person fits better if these cameras "
                          "are rotated: cam2 by 0.",
                          0),
            0u)
      << finding;
  EXPECT_EQ(finding.find("cam0"), std::string::npos) << finding;
  std::ostringstream text;
  summary.print(text);
  EXPECT_NE(text.str().find(finding), std::string::npos);
  const CameraRig told = rigOf("told.yaml");
  const std::map<std::string, Eigen::Isometry3d> T_world = transformsIn(run_.output);
  for (const Camera& camera : told)
    EXPECT_TRUE(T_world.at(opticalFrame(camera.name()))
                    .isApprox(camera.calibration().T_world_camera, 1e-9));
}

TEST_F(SelfCalibrationRun, ARunSaysNothingOfACalibrationThatIsRight) {
  film();
  EXPECT_EQ(runOffline(run_, nullptr, false).calibrationFinding(), "");
}

TEST_F(SelfCalibrationRun, ARunThatIsNotToCheckSaysNothing) {
  film();
  tellTurned(4.0);
  run_.check_calibration = false;
  EXPECT_EQ(runOffline(run_, nullptr, false).calibrationFinding(), "");
}

TEST_F(SelfCalibrationRun, ARigThatIsRightIsKeptAndNothingIsWritten) {
  film();
  const OrientationRefinement found = selfCalibrate(run_, path("found.yaml"));
  EXPECT_EQ(found.status, OrientationRefinementStatus::kNoGain);
  EXPECT_FALSE(std::filesystem::exists(path("found.yaml")));
  const std::vector<std::string> sentences = calibrationMessages(found, "found.yaml");
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_EQ(
      sentences[0].rfind("self-calibration: the calibration is unchanged, because no other is", 0),
      0u)
      << sentences[0];
  EXPECT_NE(sentences[0].find("; found.yaml is not written"), std::string::npos);
}

TEST_F(SelfCalibrationRun, WithoutAPersonItSaysSo) {
  CameraBagWriter bag(run_.input, ringOfFour(), 0);
  bag.writeTransforms(1000000000);
  for (int i = 0; i < 4; ++i) bag.write(1000000000, i, smallImage(true), smallMask());
  bag.commit();
  const OrientationRefinement found = selfCalibrate(run_, path("found.yaml"));
  EXPECT_EQ(
      calibrationMessages(found, "found.yaml"),
      std::vector<std::string>{
          "self-calibration: the camera orientations were not estimated: only 0 frames of "
          "different postures could be fitted, at least 4 are needed; found.yaml is not written"});
  EXPECT_FALSE(std::filesystem::exists(path("found.yaml")));
}

}  // namespace
}  // namespace markerless_mocap
