#include "ros/camera_conversions.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "error_text_of.h"
#include "ros/camera_markers.h"
#include "ros/sample_camera.h"

namespace markerless_mocap {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::string refusal(const sensor_msgs::CameraInfo& info,
                    const geometry_msgs::Transform& pose = samplePose()) {
  return errorTextOf([&] { calibrationFromMessage("cam3", info, pose); });
}

TEST(CameraConversions, CalibrationComesBackAsItWas) {
  const CameraCalibration there = sampleCalibration();
  const CameraCalibration back =
      calibrationFromMessage("cam3", messageFromCalibration(there), samplePose());
  EXPECT_EQ(back.name, "cam3");
  EXPECT_EQ(back.width, 640);
  EXPECT_EQ(back.height, 480);
  EXPECT_EQ(back.K, there.K);
  EXPECT_EQ(back.D, there.D);
  EXPECT_TRUE(back.T_world_camera.isApprox(there.T_world_camera, 1e-12));
}

TEST(CameraConversions, FisheyeComesBackAsItWas) {
  CameraCalibration there = sampleCalibration();
  there.lens = LensType::kFisheye;
  there.D = {-0.02, 0.01, 0.001, 0.0};
  const sensor_msgs::CameraInfo info = messageFromCalibration(there);
  EXPECT_EQ(info.distortion_model, "equidistant");
  const CameraCalibration back = calibrationFromMessage("cam3", info, samplePose());
  EXPECT_EQ(back.lens, LensType::kFisheye);
  EXPECT_EQ(back.D, there.D);
  there.D.clear();
  EXPECT_EQ(messageFromCalibration(there).D, std::vector<double>(4, 0.0));
}

TEST(CameraConversions, MatrixIsRowByRow) {
  const sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  EXPECT_EQ(info.K[0], 500.0);
  EXPECT_EQ(info.K[2], 319.5);
  EXPECT_EQ(info.K[5], 239.5);
  EXPECT_EQ(info.P[2], 319.5);
  EXPECT_EQ(info.P[3], 0.0);
  EXPECT_EQ(info.P[10], 1.0);
  EXPECT_EQ(info.distortion_model, "plumb_bob");
}

TEST(CameraConversions, ZeroKIsRefusedByName) {
  sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  info.K.fill(0.0);
  EXPECT_NE(refusal(info).find("cam3"), std::string::npos) << refusal(info);
}

TEST(CameraConversions, NaNIsRefused) {
  sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  info.K[4] = kNaN;
  EXPECT_NE(refusal(info), "");
  info = messageFromCalibration(sampleCalibration());
  info.D[1] = kNaN;
  EXPECT_NE(refusal(info), "");
}

TEST(CameraConversions, NoSizeIsRefused) {
  sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  info.width = 0;
  EXPECT_NE(refusal(info), "");
}

TEST(CameraConversions, ForeignLensModelAndCroppedImagesAreRefused) {
  sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  info.distortion_model = "thin_prism";
  EXPECT_EQ(refusal(info),
            "camera_info of cam3 has the distortion model \"thin_prism\", allowed are plumb_bob, "
            "rational_polynomial and equidistant");
  info.distortion_model = "equidistant";  // with five numbers
  EXPECT_EQ(refusal(info),
            "camera 'cam3': D has 5 distortion coefficients, allowed are 0 or 4 of a fisheye");
  info = messageFromCalibration(sampleCalibration());
  info.binning_x = 2;
  EXPECT_NE(refusal(info), "");
  info = messageFromCalibration(sampleCalibration());
  info.roi.x_offset = 10;
  EXPECT_NE(refusal(info), "");
}

TEST(CameraConversions, TransformThatIsNoneIsRefused) {
  const sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  EXPECT_NE(refusal(info, geometry_msgs::Transform()), "");  // all-zero quaternion
  geometry_msgs::Transform pose = samplePose();
  pose.translation.y = kNaN;
  EXPECT_NE(refusal(info, pose), "");
  pose = samplePose();
  pose.rotation.x = kNaN;
  EXPECT_NE(refusal(info, pose), "");
}

TEST(CameraConversions, TransformsOfTheRigGiveItsPosesBack) {
  const CameraCalibration camera = sampleCalibration();
  const auto message = transformsOf({camera}, ros::Time(3, 4), "map");
  ASSERT_EQ(message.transforms.size(), 1u);
  const geometry_msgs::TransformStamped& transform = message.transforms[0];
  EXPECT_EQ(transform.header.frame_id, "map");
  EXPECT_EQ(transform.header.stamp, ros::Time(3, 4));
  EXPECT_EQ(transform.child_frame_id, camera.name + "_optical");
  const CameraCalibration back =
      calibrationFromMessage(camera.name, messageFromCalibration(camera), transform.transform);
  EXPECT_TRUE(back.T_world_camera.isApprox(camera.T_world_camera, 1e-12));
}

TEST(CameraConversions, StampsSurvive) {
  EXPECT_EQ(nanosecondsOf(ros::Time(1000, 5)), 1000000000005);
  EXPECT_EQ(rosTime(1000000000005), ros::Time(1000, 5));
}

TEST(CameraMarkers, PyramidOpensAlongTheOpticalAxisAndCarriesTheName) {
  const Camera camera(sampleCalibration());
  const auto markers = cameraMarkers({camera}, {CameraHealth()}, std_msgs::Header(), 0.5).markers;
  ASSERT_EQ(markers.size(), 2u);
  ASSERT_EQ(markers[0].points.size(), 16u);
  const Eigen::Vector3d axis = camera.calibration().T_world_camera.linear().col(2);
  for (size_t i = 0; i < 16; i += 4) {
    const auto& p = markers[0].points[i + 1];
    const Eigen::Vector3d corner = Eigen::Vector3d(p.x, p.y, p.z) - camera.position();
    EXPECT_NEAR(corner.dot(axis), 0.5, 1e-9);
  }
  EXPECT_EQ(markers[1].text, "cam3");
}

TEST(CameraMarkers, ColourAndTextTellTheHealth) {
  const Camera camera(sampleCalibration());
  const auto shown = [&](const CameraHealth& health) {
    return cameraMarkers({camera}, {health}, std_msgs::Header(), 0.5).markers;
  };
  const auto used = shown({CameraHealth::kUsed, ""});
  EXPECT_GT(used[0].color.g, used[0].color.r);
  const auto left_out = shown({CameraHealth::kLeftOut, "its mask is full"});
  EXPECT_GT(left_out[0].color.r, left_out[0].color.g + 0.3);
  EXPECT_EQ(left_out[1].text, "cam3\nits mask is full");
  const auto silent = shown({CameraHealth::kSilent, ""});
  EXPECT_EQ(silent[0].color.r, silent[0].color.b);
  const auto doubtful = shown({CameraHealth::kDoubtful, std::string(200, 'x')});
  EXPECT_GT(doubtful[0].color.g, doubtful[0].color.b + 0.3);
  EXPECT_LT(doubtful[1].text.size(), 100u);
}

}  // namespace
}  // namespace markerless_mocap
