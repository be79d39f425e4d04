#include "tools/convert_calibration/convert_calibration.h"

#include <sstream>

#include "markerless_mocap/camera/rig_file.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

class ConvertCalibration : public ToolTest {
 protected:
  /// The ring of four as 3x4 matrices in millimetres with z down.
  void writeMatrices() const {
    for (CameraCalibration camera : ringOfFour()) {
      const Eigen::Matrix3d flip = WorldTransform{1.0, "-z"}.rotation().transpose();
      camera.T_world_camera.linear() = flip * camera.T_world_camera.linear();
      camera.T_world_camera.translation() = 1000.0 * (flip * camera.T_world_camera.translation());
      std::ostringstream text;
      text.precision(15);
      text << camera.K * camera.T_world_camera.inverse().matrix().topRows<3>();
      writeText("in/" + camera.name + ".txt", text.str());
    }
  }
  std::string refusal() const {
    return errorTextOf<std::exception>([&] { convertCalibration(options_); });
  }

  ConversionOptions options_;
};

TEST_F(ConvertCalibration, UnitAndAxesAreFoundAndSaid) {
  writeMatrices();
  options_.inputs = {path("in")};
  options_.size = "80x60";
  options_.output = path("rig.yaml");
  const Conversion conversion = convertCalibration(options_);
  const auto rig = readRig(path("rig.yaml"));
  const auto ring = ringOfFour();
  ASSERT_EQ(rig.size(), ring.size());
  for (size_t i = 0; i < rig.size(); ++i) {
    EXPECT_EQ(rig[i].name, ring[i].name);
    EXPECT_TRUE(rig[i].K.isApprox(ring[i].K, 1e-6));
    EXPECT_TRUE(rig[i].T_world_camera.isApprox(ring[i].T_world_camera, 1e-6));
  }
  std::ostringstream said;
  print(conversion, said);
  EXPECT_EQ(said.str().substr(0, 114),
            "4 cameras from 3x4 projection matrices\nunit: 0.001 m (guessed, the cameras are up to "
            "6000 units apart), up: -z (gu");
  EXPECT_NE(
      said.str().find("  cam0      80 x 60  at   2.87   0.89   1.00 m, direction -0.96 -0.30"),
      std::string::npos)
      << said.str();
  EXPECT_NE(said.str().find("wrote " + path("rig.yaml")), std::string::npos);
}

TEST_F(ConvertCalibration, WhatIsGivenCounts) {
  writeMatrices();
  options_.inputs = {path("in")};
  options_.scale_to_metres = 0.01;
  options_.up = "y";
  const Conversion conversion = convertCalibration(options_);
  EXPECT_TRUE(conversion.written.empty());
  EXPECT_EQ(conversion.world.world.up, "y");
  EXPECT_NEAR(conversion.rig[0].T_world_camera.translation().norm(), std::sqrt(1000.0), 1e-3);
}

TEST_F(ConvertCalibration, WhatIsMissingIsTold) {
  writeMatrices();
  options_.inputs = {path("in")};
  options_.output = path("out.yaml");
  EXPECT_EQ(refusal(),
            "the calibration does not say the image size of cam0, give it with --size, such as "
            "--size 1280x720");
  options_.size = "80 x 60";
  EXPECT_EQ(refusal(), "size is 80 x 60, allowed is such as 1280x720");
  options_.size = "80x60";
  options_.output = path("out");
  EXPECT_EQ(refusal(),
            "the name " + path("out") + " tells no format (.yaml: a rig file), give one with --to");
  options_.format = "bouguet";
  EXPECT_EQ(refusal(),
            "there is no calibration format 'bouguet', allowed are rig, ros, kalibr, qualisys, "
            "easymocap, opencv, anipose, caliscope, freemocap, pose2sim, colmap, matrices");
  options_.format = "colmap";
  EXPECT_EQ(convertCalibration(options_).written.size(), 3u);
  EXPECT_EQ(refusal(), path("out/cameras.txt") + " exists and is not overwritten");
}

}  // namespace
}  // namespace markerless_mocap
