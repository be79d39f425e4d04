#include "format_fixture.h"
#include "markerless_mocap/formats/world_transform.h"

namespace markerless_mocap {
namespace {

class BadCalibration : public FormatTest {
 protected:
  std::string of(const std::string& file, const std::string& text) {
    return refusal({write(file, text)});
  }
};

constexpr const char* kAll =
    "allowed are rig file of this package, ROS camera_info and static transforms, Kalibr camchain, "
    "Qualisys .qca.txt, EasyMocap intri.yml and extri.yml, OpenCV XML or YAML, anipose TOML, "
    "caliscope TOML, FreeMoCap TOML, Pose2Sim TOML, COLMAP text model, 3x4 projection matrices";

const std::string kAnipose =
    "[cam_0]\nname = \"A\"\nsize = [640, 480]\nmatrix = [[500.0, 0.0, 320.0], [0.0, 500.0, 240.0], "
    "[0.0, 0.0, 1.0]]\ndistortions = [0.0, 0.0, 0.0, 0.0, 0.0]\nrotation = [1.0, 0.0, 0.0]\n"
    "translation = [0.0, 1.0, 4.0]\n";

const std::string kKalibr =
    "cam0:\n  camera_model: pinhole\n  intrinsics: [500, 500, 320, 240]\n  distortion_model: "
    "radtan\n"
    "  distortion_coeffs: [0, 0, 0, 0]\n  resolution: [640, 480]\n";

const std::string kInfo =
    "image_width: 640\nimage_height: 480\ncamera_name: front\ncamera_matrix:\n  rows: 3\n  cols: "
    "3\n"
    "  data: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST_F(BadCalibration, WhatIsNoneIsTold) {
  EXPECT_EQ(refusal({path("none.xml")}), "cannot read none.xml: there is no such file");
  EXPECT_EQ(of("a.txt", "1 2 3"),
            std::string("a.txt: this is no calibration of a known format, ") + kAll);
  EXPECT_EQ(of("a.txt", "1 2 3 4 5 6 7 8 9 10 11 twelve").substr(0, 27),
            "a.txt: this is no calibrati");
  EXPECT_EQ(of("a.txt", std::string("\0\1", 2)).substr(0, 27), "a.txt: this is no calibrati");
  EXPECT_EQ(of("a.txt", "").substr(0, 27), "a.txt: this is no calibrati");
  std::filesystem::create_directories(path("empty"));
  EXPECT_EQ(refusal({path("empty")}),
            std::string("empty: there is no calibration in this folder, ") + kAll);
  write("model/cameras.bin", "x");
  EXPECT_EQ(refusal({path("model")}),
            "model: COLMAP's model is binary, allowed is text: colmap model_converter "
            "--output_type TXT");
}

TEST_F(BadCalibration, TwoFormatsInOneFolderAreTold) {
  write("both/a.toml", kAnipose);
  write("both/b.yaml", kKalibr);
  EXPECT_EQ(
      refusal({path("both")}),
      "both/b.yaml: this is Kalibr camchain, but both/a.toml is anipose TOML: name the one to "
      "read");
}

TEST_F(BadCalibration, TomlThatIsBrokenOrWrongIsToldWithTheCamera) {
  EXPECT_EQ(
      of("a.toml", replaced(kAnipose, "\"A\"", "\"A")),
      "a.toml, line 2: this is no TOML: a text in quotes has no end, or signs that it may not "
      "hold");
  EXPECT_EQ(
      of("a.toml", replaced(kAnipose, "500.0, 240.0", "-500.0, 240.0")),
      "a.toml, camera cam_0: the camera matrix is 500, 0, 320, 0, -500, 240, 0, 0, 1, allowed "
      "is fx skew cx 0 fy cy 0 0 1 with fx and fy above 0");
  EXPECT_EQ(
      of("a.toml", replaced(kAnipose, "[1.0, 0.0, 0.0]", "[1.0, 0.0]")),
      "a.toml, camera cam_0: the rotation has 2 numbers, allowed are 3 (rotation vector) or 9 "
      "(matrix)");
  EXPECT_EQ(of("a.toml", replaced(kAnipose, "[0.0, 1.0, 4.0]", "[0.0, nan, 4.0]")),
            "a.toml, camera cam_0: 'translation' has a value that is not finite");
  EXPECT_EQ(of("a.toml", replaced(kAnipose, "[1.0, 0.0, 0.0]\n",
                                  "[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]\n")),
            "a.toml, camera cam_0: the rotation is no rotation matrix (determinant -1, allowed is "
            "1)");
  EXPECT_EQ(
      of("a.toml", replaced(kAnipose, "[0.0, 0.0, 0.0, 0.0, 0.0]", "[0.0, 0.0, 0.0, 0.0, 0.1]") +
                       "fisheye = true\n"),
      "a.toml: camera 'A': D has 5 distortion coefficients, allowed are 0 or 4 of a fisheye");
  EXPECT_EQ(of("a.toml", replaced(kAnipose, "rotation = [1.0, 0.0, 0.0]\n", "")),
            "a.toml: the calibration has no cameras");
  EXPECT_EQ(of("a.toml", kAnipose + replaced(kAnipose, "[cam_0]", "[cam_1]")),
            "a.toml: two cameras are named 'A'");
}

TEST_F(BadCalibration, CamchainsOfOtherLensesAreTold) {
  EXPECT_EQ(of("c.yaml", replaced(kKalibr, "pinhole", "omni")),
            "c.yaml, cam0: 'camera_model' is omni, allowed is pinhole");
  EXPECT_EQ(of("c.yaml", replaced(kKalibr, "radtan", "fov")),
            "c.yaml, cam0: 'distortion_model' is fov, allowed are radtan, equidistant and none");
  EXPECT_EQ(of("c.yaml", kKalibr + replaced(kKalibr, "cam0", "cam1")),
            "c.yaml, cam1: key 'T_cn_cnm1' is missing");
  EXPECT_EQ(of("c.yaml", replaced(kKalibr, "[640, 480]", "[640, 0]")),
            "c.yaml, cam0: 'resolution' is 0, allowed are whole numbers from 1 to 65536");
}

TEST_F(BadCalibration, CameraInfoWithoutTransformOrCalibrationIsTold) {
  EXPECT_EQ(of("front.yaml", kInfo),
            "front.yaml: no static transform leads to frame front_optical, give the launch file or "
            "YAML of tf_static, too");
  EXPECT_EQ(of("front.yaml", replaced(kInfo, "[500, 0, 320, 0, 500, 240, 0, 0, 1]",
                                      "[0, 0, 0, 0, 0, 0, 0, 0, 0]")),
            "front.yaml: the camera matrix is all zero, so the camera is not calibrated");
  EXPECT_EQ(of("front.yaml", kInfo + "distortion_model: fov\n"),
            "front.yaml: 'distortion_model' is fov, allowed are plumb_bob, rational_polynomial and "
            "equidistant");
  const std::string info = write("front.yaml", kInfo);
  const auto with = [&](const std::string& args) {
    return refusal({info, write("tf.launch",
                                "<launch>\n<node pkg=\"tf2_ros\" name=\"x\" "
                                "type=\"static_transform_publisher\" args=\"" +
                                    args + "\"/>\n</launch>\n")});
  };
  EXPECT_EQ(with("0 0 0 0 0 0 world side_optical"),
            "front.yaml: no static transform leads to frame front_optical, the frames are "
            "side_optical");
  EXPECT_EQ(
      with("0 0 world front_optical"),
      "tf.launch, line 2: static_transform_publisher has the args '0 0 world front_optical', "
      "allowed are x y z yaw pitch roll or x y z qx qy qz qw, and the parent and child frame");
  EXPECT_EQ(with("0 0 $(arg z) 0 0 0 world front_optical"),
            "tf.launch, line 2: '0 0 $(arg z) 0 0 0 ' has words that are no numbers");
  EXPECT_EQ(with("0 0 0 0 0 0 2 world front_optical"),
            "tf.launch, line 2: a quaternion has length 2, allowed is 1");
}

TEST_F(BadCalibration, HalvesAreTold) {
  EXPECT_EQ(of("cameras.txt", "1 PINHOLE 640 480 500 500 320 240\n"),
            "cameras.txt: this is only half of a model, images.txt is missing");
  EXPECT_EQ(
      of("intri.yml",
         "%YAML:1.0\n---\nK_1: !!opencv-matrix\n  rows: 1\n  cols: 1\n  dt: d\n  data: [1.]\n"),
      "intri.yml: this is only half of a calibration, extri.yml is missing");
  EXPECT_EQ(of("lens.xml",
               "<?xml version=\"1.0\"?>\n<opencv_storage><CameraMatrix "
               "type_id=\"opencv-matrix\"><rows>1</rows><cols>1</cols><dt>d</dt><data>1.</data>"
               "</CameraMatrix></opencv_storage>"),
            "lens.xml: camera 'lens' has 1 camera matrices and 0 poses (Rotation and Translation), "
            "allowed is one of each");
}

TEST_F(BadCalibration, ColmapLensesThatAreUnknownAreTold) {
  const std::string images = write("images.txt", "1 1 0 0 0 0 0 0 1 a.png\n\n");
  EXPECT_EQ(
      refusal({write("cameras.txt", "1 THIN_PRISM_FISHEYE 9 9 5 5 3 2 0 0 0 0 0 0 0 0\n"), images}),
      "cameras.txt, line 1: the camera model is "
      "THIN_PRISM_FISHEYE, allowed are FULL_OPENCV, OPENCV, OPENCV_FISHEYE, PINHOLE, RADIAL, "
      "SIMPLE_PINHOLE, SIMPLE_RADIAL");
  EXPECT_EQ(refusal({write("cameras.txt", "1 PINHOLE 640 480 500 500 320\n"), images}),
            "cameras.txt, line 1: PINHOLE has 3 numbers, allowed are 4");
  EXPECT_EQ(refusal({write("cameras.txt", "2 PINHOLE 640 480 500 500 320 240\n"), images}),
            "images.txt, image 'a.png': camera 1 is not in cameras.txt");
}

TEST_F(BadCalibration, QualisysWithoutAnElementIsTold) {
  EXPECT_EQ(of("c.qca.txt",
               "<calibration><cameras><camera serial=\"7\"><intrinsic focalLengthU=\"1\"/></camera>"
               "</cameras></calibration>"),
            "c.qca.txt, camera '7': there is no element <fov_video>");
}

TEST_F(BadCalibration, BrokenXmlIsToldWithItsLine) {
  EXPECT_EQ(of("c.qca.txt", "<calibration>\n<cameras focalLengthU"),
            "c.qca.txt: the text is no XML from line 2 on: an attribute is not NAME=\"VALUE\", or "
            "stands twice");
  EXPECT_EQ(of("tf.launch", "<launch>\n<node type=\"static_transform_publisher\"></launch>"),
            "tf.launch: the text is no XML from line 2 on: a tag has no end, or that of another");
}

TEST_F(BadCalibration, XmlThatIsACommentAloneIsTold) {
  EXPECT_EQ(of("c.qca.txt", "<!-- <calibration focalLengthU -->"),
            "c.qca.txt: the text is empty or has no tags");
  EXPECT_EQ(of("tf.launch", "<!-- <launch static_transform_publisher -->"),
            "tf.launch: the text is empty or has no tags");
}

TEST_F(BadCalibration, ColmapLinesThatAreNoneAreToldWithTheirNumber) {
  const std::string images = write("images.txt", "1 1 0 0 0 0 0 0 1 a.png\n\n");
  const std::string good = "# comment\n1 PINHOLE 640 480 500 500 320 240\n";
  const auto cameras = [&](const std::string& line) {
    return refusal({write("cameras.txt", good + line), images});
  };
  EXPECT_EQ(cameras("2 PINHOLE 640 480 500 500 320 24O\n"),
            "cameras.txt, line 3: behind WIDTH HEIGHT is something that is no number");
  EXPECT_EQ(cameras("2 PINHOLE 640x480 500 500 320 240\n"),
            "cameras.txt, line 3: it is not CAMERA_ID MODEL WIDTH HEIGHT PARAMS");
  EXPECT_EQ(cameras("2 PINHOLE 0 480 500 500 320 240\n"),
            "cameras.txt, line 3: 'WIDTH' is 0, allowed are whole numbers from 1 to 65536");
  const std::string lens = write("cameras.txt", good);
  EXPECT_EQ(refusal({lens, write("images.txt", "1 1 0 0 0 0 0 0 1 a.png\n\n2 1 0 0\n\n")}),
            "images.txt, line 3: it is not ID QW QX QY QZ TX TY TZ CAMERA_ID NAME; every second "
            "line lists points, and may be empty");
}

/// A camera in OpenCV's XML with other rows or another width.
std::string openCvCamera(const std::string& rows, const std::string& width) {
  return "<?xml version=\"1.0\"?>\n<opencv_storage><image_width>" + width +
         "</image_width><image_height>480</image_height><CameraMatrix "
         "type_id=\"opencv-matrix\"><rows>" +
         rows +
         "</rows><cols>3</cols><dt>d</dt><data>500. 0. 320. 0. 500. 240. 0. 0. 1.</data>"
         "</CameraMatrix><Rotation type_id=\"opencv-matrix\"><rows>3</rows><cols>1</cols>"
         "<dt>d</dt><data>0. 0. 0.</data></Rotation><Translation type_id=\"opencv-matrix\">"
         "<rows>3</rows><cols>1</cols><dt>d</dt><data>0. 0. 1.</data></Translation>"
         "</opencv_storage>";
}

TEST_F(BadCalibration, OpenCvMatricesThatAreNoneAreTold) {
  EXPECT_EQ(refusal({write("a.xml", openCvCamera("3", "640"))}), "");
  EXPECT_EQ(of("a.xml", openCvCamera("4", "640")),
            "a.xml: 'CameraMatrix' is no matrix: allowed are rows, cols, dt d or f, and data with "
            "rows x cols numbers");
  EXPECT_EQ(of("a.xml", openCvCamera("3", "wide")),
            "a.xml: 'image_width' is no number, allowed is one");
  EXPECT_EQ(of("a.xml", openCvCamera("3", "1e30")),
            "a.xml: 'image_width' is 1e+30, allowed are whole numbers from 1 to 65536");
}

TEST_F(BadCalibration, ASecondDocumentThatIsNoYamlIsTold) {
  const std::string info = write("front.yaml", kInfo);
  EXPECT_EQ(refusal({info, write("tf.yaml", "child_frame_id: a\n---\na: [\n")}).substr(0, 19),
            "tf.yaml is no YAML:");
}

TEST(WorldGuess, MillimetresAndAnAxisThatPointsDownAreFound) {
  CalibrationSet set;
  set.cameras.resize(2);
  // Both look along +x with z down in the world, as up is -z: the image's y is the world's z.
  for (CameraCalibration& camera : set.cameras)
    camera.T_world_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  set.cameras[1].T_world_camera.translation() << 0, 3000, 0;
  EXPECT_EQ(guessWorld(set).world.up, "z");
  EXPECT_EQ(guessWorld(set).world.scale_to_metres, 0.001);
  for (CameraCalibration& camera : set.cameras)
    camera.T_world_camera.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_EQ(guessWorld(set).world.up, "-z");
  set.cameras[1].T_world_camera.translation() << 0, 3, 0;
  EXPECT_EQ(guessWorld(set).world.scale_to_metres, 1.0);
  set.metres_per_unit = 0.01;
  EXPECT_EQ(guessWorld(set).world.scale_to_metres, 0.01);
}

}  // namespace
}  // namespace markerless_mocap
