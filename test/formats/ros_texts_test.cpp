#include "formats/ros_texts.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

TEST(CameraInfoText, HasFiveOrEightCoefficients) {
  CameraCalibration camera;
  camera.name = "cam";
  camera.width = 640;
  camera.height = 480;
  camera.K << 500, 0, 320, 0, 501, 240, 0, 0, 1;
  camera.D = {-0.1, 0.2, 0.001, 0.002};
  const std::string text = cameraInfoText(camera);
  EXPECT_NE(text.find("distortion_model: plumb_bob\n"), std::string::npos);
  EXPECT_NE(text.find("data: [-0.1, 0.2, 0.001, 0.002, 0]"), std::string::npos);
  EXPECT_NE(text.find("data: [500, 0, 320, 0, 0, 501, 240, 0, 0, 0, 1, 0]"), std::string::npos);
  camera.D.resize(8, 0.5);
  EXPECT_NE(cameraInfoText(camera).find("distortion_model: rational_polynomial\n"),
            std::string::npos);
}

TEST(TransformsLaunchText, NamesTheFrameOfTheWorld) {
  CameraCalibration camera;
  camera.name = "left/cam";
  camera.T_world_camera.translation() << 1, 2, 0.5;
  const std::string text = transformsLaunchText({camera}, "room");
  EXPECT_NE(text.find("name=\"left_cam_pose\""), std::string::npos) << text;
  EXPECT_NE(text.find("args=\"1 2 0.5 0 0 0 1 room left/cam_optical\""), std::string::npos) << text;
}

}  // namespace
}  // namespace markerless_mocap
