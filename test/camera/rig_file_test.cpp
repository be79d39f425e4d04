#include "markerless_mocap/camera/rig_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

std::vector<CameraCalibration> twoCameras() {
  std::vector<CameraCalibration> rig(2);
  rig[0].name = "left: \"front\"";
  rig[0].width = 640;
  rig[0].height = 480;
  rig[0].K << 512.3456789, 0.25, 319.5, 0, 510.1 / 3, 239.5, 0, 0, 1;
  rig[0].D = {-0.1, 0.01, 1e-4, -1e-300, 0.3};
  rig[0].T_world_camera.linear() =
      Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.3).normalized()).toRotationMatrix();
  rig[0].T_world_camera.translation() << 1.0 / 3, -2.7, 1e-17;
  rig[1] = rig[0];
  rig[1].name = "cam1";
  rig[1].K(0, 1) = 0.0;
  rig[1].D.clear();
  rig[1].T_world_camera.linear() = Eigen::Matrix3d::Identity();
  return rig;
}

constexpr const char* kCamera =
    "- name: a\n  size: [80, 60]\n  fx: 70\n  fy: 72\n  cx: 39.5\n  cy: 29.5\n"
    "  distortion: []\n  position: [0, 1, 2]\n  orientation: [0, 0, 0, 1]\n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

std::string errorFor(const std::string& text) {
  return errorTextOf([&] { rigFromText(text, "rig.yaml"); });
}

std::string errorForCamera(const std::string& what, const std::string& with) {
  return errorFor("cameras:\n" + replaced(kCamera, what, with));
}

TEST(RigFileTest, everyNumberComesBackAsItWas) {
  const auto rig = twoCameras(), again = rigFromText(rigText(rig), "rig.yaml");
  ASSERT_EQ(again.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again[i].name, rig[i].name);
    EXPECT_EQ(again[i].width, 640);
    EXPECT_EQ(again[i].height, 480);
    EXPECT_EQ(again[i].K, rig[i].K);
    EXPECT_EQ(again[i].D, rig[i].D);
    EXPECT_EQ(again[i].T_world_camera.translation(), rig[i].T_world_camera.translation());
    EXPECT_LT((again[i].T_world_camera.linear() - rig[i].T_world_camera.linear()).norm(), 1e-12);
  }
}

TEST(RigFileTest, aRigOnceReadKeepsEveryBit) {
  for (int turn = 0; turn < 500; ++turn) {
    auto rig = twoCameras();
    const Eigen::Vector3d axis = Eigen::Vector3d(turn - 20.0, 3.0, 0.1 * turn).normalized();
    rig[0].T_world_camera.linear() = Eigen::AngleAxisd(0.13 * turn, axis).toRotationMatrix();
    const std::string text = rigText(rig);
    const auto once = rigFromText(text, "rig.yaml");
    EXPECT_EQ(rigText(once), text) << turn;
    const auto twice = rigFromText(rigText(once), "rig.yaml");
    EXPECT_EQ(twice[0].T_world_camera.matrix(), once[0].T_world_camera.matrix()) << turn;
  }
}

TEST(RigFileTest, aTimeOffsetIsKeptAndWrittenOnlyWhereThereIsOne) {
  auto rig = twoCameras();
  EXPECT_EQ(rigText(rig).find("  time_offset"), std::string::npos);
  rig[1].time_offset = -0.0125;
  const auto again = rigFromText(rigText(rig), "rig.yaml");
  EXPECT_EQ(again[0].time_offset, 0.0);
  EXPECT_EQ(again[1].time_offset, -0.0125);
  EXPECT_EQ(errorForCamera("fx: 70", "time_offset: soon\n  fx: 70"),
            "rig.yaml, camera 'a': 'time_offset' holds soon, allowed are finite numbers");
}

TEST(RigFileTest, aFisheyeIsKeptAndWrittenOnlyWhereThereIsOne) {
  auto rig = twoCameras();
  EXPECT_EQ(rigText(rig).find("  lens:"), std::string::npos);
  rig[1].lens = LensType::kFisheye;
  rig[1].D = {-0.02, 0.01, 0.001, 0.0};
  const auto again = rigFromText(rigText(rig), "rig.yaml");
  EXPECT_EQ(again[0].lens, LensType::kPolynomial);
  EXPECT_EQ(again[1].lens, LensType::kFisheye);
  EXPECT_EQ(again[1].D, rig[1].D);
  EXPECT_EQ(errorForCamera("fx: 70", "lens: wide\n  fx: 70"),
            "rig.yaml, camera 'a': 'lens' is wide, allowed are polynomial and fisheye");
}

TEST(RigFileTest, theFormatIsThatOfTheManual) {
  const auto rig = rigFromText(std::string("cameras:\n") + kCamera, "rig.yaml");
  EXPECT_EQ(rig[0].K, (Eigen::Matrix3d() << 70, 0, 39.5, 0, 72, 29.5, 0, 0, 1).finished());
  EXPECT_EQ(rig[0].T_world_camera.translation(), Eigen::Vector3d(0, 1, 2));
  // A quarter turn about z takes the camera's x to the world's y.
  const auto turned = rigFromText(
      "cameras:\n" + replaced(kCamera, "[0, 0, 0, 1]", "[0, 0, 0.7071, 0.7071]"), "rig.yaml");
  EXPECT_LT((turned[0].T_world_camera.linear().col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-9);
}

TEST(RigFileTest, faultsAreNamed) {
  EXPECT_EQ(errorFor("cameras: []"),
            "rig.yaml: the rig has no cameras, key 'cameras' must list at least one");
  EXPECT_EQ(errorFor(""), "rig.yaml: the rig has no cameras, key 'cameras' must list at least one");
  EXPECT_EQ(errorFor(std::string("cameras:\n") + kCamera + kCamera),
            "rig.yaml: two cameras are named 'a', each needs a name of its own");
  EXPECT_EQ(errorFor("cameras: [3]"), "rig.yaml, camera 0: this is no map of keys to values");
  EXPECT_EQ(errorFor("camera: []"), "rig.yaml: key 'camera' is unknown, allowed are cameras");
  EXPECT_EQ(errorForCamera("name: a", "name: \"\""),
            "rig.yaml, camera 0: key 'name' is missing or empty, each camera needs a name");
  EXPECT_EQ(errorForCamera("fx: 70", "fx: .nan"),
            "rig.yaml, camera 'a': 'fx' holds .nan, allowed are finite numbers");
  EXPECT_EQ(errorForCamera("fx: 70", "fx: wide"),
            "rig.yaml, camera 'a': 'fx' holds wide, allowed are finite numbers");
  EXPECT_EQ(errorForCamera("  cy: 29.5\n", ""), "rig.yaml, camera 'a': key 'cy' is missing");
  EXPECT_EQ(errorForCamera("cy: 29.5", "cy: 29.5\n  cy: 3"),
            "rig.yaml, camera 'a': key 'cy' is repeated");
  EXPECT_EQ(errorForCamera("cy: 29.5", "cy: 29.5\n  zoom: 3"),
            "rig.yaml, camera 'a': key 'zoom' is unknown, allowed are cx, cy, distortion, fx, fy, "
            "lens, name, orientation, position, size, skew, time_offset");
}

TEST(RigFileTest, valuesThatAreNoCameraAreNamed) {
  EXPECT_EQ(errorForCamera("[0, 0, 0, 1]", "[0, 0, 1, 1]"),
            "rig.yaml, camera 'a': 'orientation' is a quaternion of length 1.4142135623730951, "
            "allowed are rotations, whose length is 1");
  EXPECT_EQ(
      errorForCamera("[0, 0, 0, 1]", "[0, 0, 1]"),
      "rig.yaml, camera 'a': 'orientation' has 3 numbers, wanted are 4: a quaternion x y z w");
  EXPECT_EQ(errorForCamera("[80, 60]", "[80.5, 60]"),
            "rig.yaml, camera 'a': 'size' holds 80.5, allowed are whole numbers from 1 to 65536");
  EXPECT_EQ(errorForCamera("distortion: []", "distortion: [1, 2]"),
            "rig.yaml: camera 'a': D has 2 distortion coefficients, allowed are 0, 4, 5 or 8");
  EXPECT_EQ(errorForCamera("fx: 70", "fx: -70"),
            "rig.yaml: camera 'a': the focal lengths in K must be positive");
  EXPECT_EQ(errorFor("cameras: [").rfind("rig.yaml is no YAML: ", 0), 0u);
}

TEST(RigFileTest, camerasAreChosenByNameAndLackingOnesNamed) {
  auto rig = twoCameras();
  rig[0].name = "cam0";
  const auto chosen = camerasNamed({"cam1", "cam0"}, rig, "rig.yaml");
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0].name, "cam1");
  EXPECT_EQ(chosen[1].K, rig[0].K);
  EXPECT_EQ(errorTextOf([&] {
              camerasNamed({"cam2", "cam1", "left"}, rig, "rig.yaml");
            }),
            "rig.yaml: the rig lacks cam2, left, its cameras are cam0, cam1");
}

TEST(RigFileTest, filesAreWrittenAndRead) {
  const auto path =
      std::filesystem::temp_directory_path() / ("mocap_rig_" + std::to_string(getpid()) + ".yaml");
  writeRig(path.string(), twoCameras());
  EXPECT_EQ(rigText(readRig(path.string())), rigText(twoCameras()));
  std::filesystem::remove(path);
  EXPECT_THROW(readRig(path.string()), std::runtime_error);
  EXPECT_THROW(writeRig("/nowhere/at/all.yaml", twoCameras()), std::runtime_error);
  EXPECT_THROW(rigText({}), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
