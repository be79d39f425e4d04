// Lenses alone: what camera drivers and OpenCV write before anybody knows where the cameras stand.
#include "format_fixture.h"

namespace markerless_mocap {
namespace {

class Lenses : public FormatTest {};

TEST_F(Lenses, OfCameraInfoFilesWithoutTransforms) {
  for (const char* name : {"left", "right"})
    write(std::string("camera_info/") + name + ".yaml",
          std::string("image_width: 640\nimage_height: 480\ncamera_name: ") + name +
              "\ncamera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 510, 240, 0, 0, 1]}\n"
              "distortion_model: plumb_bob\n"
              "distortion_coefficients: {rows: 1, cols: 5, data: [-0.2, 0.1, 0, 0, 0]}\n");
  const CalibrationSet set = readLenses({path("camera_info")});
  ASSERT_EQ(set.cameras.size(), 2u);
  EXPECT_EQ(set.cameras[1].name, "right");
  EXPECT_EQ(set.cameras[1].K(1, 1), 510);
  EXPECT_EQ(set.cameras[1].D.at(0), -0.2);
  EXPECT_NE(refusal({path("camera_info")}), "");
}

TEST_F(Lenses, OfOpenCvFilesWithAndWithoutPoses) {
  const std::string lens =
      "%YAML:1.0\n---\nCameraMatrix: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n"
      "  data: [500., 0., 320., 0., 510., 240., 0., 0., 1.]\n";
  const std::string pose =
      "Rotation: !!opencv-matrix\n  rows: 3\n  cols: 1\n  dt: d\n  data: [0., 0., 0.]\n"
      "Translation: !!opencv-matrix\n  rows: 3\n  cols: 1\n  dt: d\n  data: [0., 0., 4.]\n";
  write("rig/cam1/config.yml", lens);
  write("rig/cam2/config.yml", lens + pose);
  const CalibrationSet set = readLenses({path("rig")});
  ASSERT_EQ(set.cameras.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(set.cameras[i].name, i ? "cam2" : "cam1");
    EXPECT_EQ(set.cameras[i].K(1, 1), 510);
    EXPECT_EQ(set.cameras[i].T_world_camera.translation().norm(), 0);
  }
  EXPECT_NE(refusal({path("rig")}), "");
}

}  // namespace
}  // namespace markerless_mocap
