#include "ros/node_options.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

HullNodeOptions hullOf(size_t cameras) {
  HullNodeOptions options;
  for (size_t i = 0; i < cameras; ++i) options.cameras.push_back("cam" + std::to_string(i));
  return options;
}

TEST(NodeOptions, EachCameraHasABackgroundOfItsOwn) {
  SilhouetteNodeOptions options;
  options.background_folder = "/kept";
  EXPECT_EQ(options.backgroundFile("cam0"), "/kept/cam0.background");
  std::set<std::string> files;
  for (const char* camera : {"a/b/c", "a_b/c", "a/b_c", "a_b_c", "/a_b_c"})
    files.insert(options.backgroundFile(camera));
  EXPECT_EQ(files.size(), 5u);
  for (const std::string& file : files)
    EXPECT_EQ(std::filesystem::path(file).parent_path(), "/kept") << file;
  options.input = "mask";
  EXPECT_EQ(options.backgroundFile("cam0"), "");
}

TEST(NodeOptions, TwoTo32CamerasMakeAHull) {
  EXPECT_EQ(errorTextOf([] { hullOf(1).validate(); }),
            "visual_hull/cameras lists 1 cameras, allowed is 2 to 32");
  EXPECT_EQ(errorTextOf([] { hullOf(2).validate(); }), "");
  EXPECT_EQ(errorTextOf([] { hullOf(32).validate(); }), "");
  EXPECT_NE(errorTextOf([] { hullOf(33).validate(); }), "");
}

TEST(NodeOptions, ThreeQuartersOfTheCamerasAreEnough) {
  EXPECT_EQ(hullOf(2).requiredCameras(), 2u);
  EXPECT_EQ(hullOf(4).requiredCameras(), 3u);
  EXPECT_EQ(hullOf(8).requiredCameras(), 6u);
  HullNodeOptions options = hullOf(8);
  options.min_cameras = 2;
  EXPECT_EQ(options.requiredCameras(), 2u);
  options.min_cameras = 9;
  EXPECT_NE(errorTextOf([&] { options.validate(); }), "");
}

TEST(NodeOptions, DeadlineIsNotBelowTheTolerance) {
  HullNodeOptions options = hullOf(4);
  options.stamp_tolerance = 0.6;
  EXPECT_NE(errorTextOf([&] { options.validate(); }).find("visual_hull/deadline"),
            std::string::npos);
}

TEST(NodeOptions, BodyIdIsLettersAndDigits) {
  for (const std::string id : {"", "1person", "person 1", "a/b"}) {
    FittingNodeOptions options;
    options.body_id = id;
    EXPECT_NE(errorTextOf([&] { options.validate(); }), "") << id;
  }
}

TEST(NodeOptions, MethodsThatReadSilhouettesNeedTwoCameras) {
  FittingNodeOptions options;
  EXPECT_EQ(errorTextOf([&] { options.validate(); }), "");
  EXPECT_EQ(errorTextOf([&] { options.requireCameras(); }),
            "pose_fitting/cameras lists 0 cameras, allowed is 2 to 32");
  options.cameras = {"a", "b"};
  EXPECT_EQ(errorTextOf([&] { options.requireCameras(); }), "");
  options.cameras = {"a", "a"};
  EXPECT_NE(errorTextOf([&] { options.validate(); }), "");
}

TEST(NodeOptions, WorldFrameIsNamed) {
  FittingNodeOptions options;
  options.world_frame.clear();
  EXPECT_EQ(errorTextOf([&] { options.validate(); }),
            "pose_fitting/world_frame is empty, allowed is a frame's name");
}

}  // namespace
}  // namespace markerless_mocap
