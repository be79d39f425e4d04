// One camera in every layout, written by hand: it stands at (0, -4, 1) m, looks along +y with z up,
// has f = 500 px, the centre (320, 240) and k1 = -0.2. The point (0.4, 0, 1.2) is at (0.4, -0.2, 4)
// before it, on the image plane at (0.1, -0.05), with r^2 = 0.0125; the lens moves it inward by
// 0.9975, to the pixel (320 + 50 * 0.9975, 240 - 25 * 0.9975).
#include "format_fixture.h"
#include "markerless_mocap/formats/world_transform.h"

namespace markerless_mocap {
namespace {

const Eigen::Vector3d kPoint(0.4, 0.0, 1.2);
const Eigen::Vector2d kPixel(369.875, 215.0625), kPixelWithoutLens(370.0, 215.0);

class HandWritten : public FormatTest {
 protected:
  void expectPixel(const CalibrationSet& set, size_t camera, const Eigen::Vector3d& point,
                   const Eigen::Vector2d& pixel) const {
    const WorldTransform metres{set.metres_per_unit.value_or(1.0), "z"};
    CameraCalibration calibration = metres.apply(set.cameras.at(camera));
    if (calibration.width == 0) calibration.width = 640, calibration.height = 480;
    const auto seen = Camera(calibration).project(point);
    ASSERT_TRUE(seen);
    EXPECT_LT((*seen - pixel).norm(), 1e-4) << seen->transpose();
  }
  CalibrationSet expectCamera(const std::vector<std::string>& paths, CalibrationFormat format,
                              const std::string& name,
                              const Eigen::Vector2d& pixel = kPixel) const {
    const CalibrationSet set = readCalibration(paths);
    EXPECT_STREQ(nameOf(set.format), nameOf(format));
    EXPECT_EQ(set.cameras.at(0).name, name);
    expectPixel(set, 0, kPoint, pixel);
    return set;
  }
};

const char* const kCameraInfo = R"(image_width: 640
image_height: 480
camera_name: front
camera_matrix:
  rows: 3
  cols: 3
  data: [500, 0, 320, 0, 500, 240, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.2, 0, 0, 0, 0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]
projection_matrix:
  rows: 3
  cols: 4
  data: [500, 0, 320, 0, 0, 500, 240, 0, 0, 0, 1, 0]
)";

TEST_F(HandWritten, RosWithAChainOfTransformsInALaunchFile) {
  write("front.yaml", kCameraInfo);
  write("rig.launch", R"(<launch>
  <group>
    <node pkg="tf" type="static_transform_publisher" name="a" args="0 -4 1 1.570796327 0 0 /world /front_link 100"/>
  </group>
  <node pkg="tf2_ros" type="static_transform_publisher" name="b"
    args="0 0 0 -0.5 0.5 -0.5 0.5 front_link front_optical_frame"/>
</launch>)");
  EXPECT_EQ(expectCamera({path("")}, CalibrationFormat::kRos, "front").metres_per_unit, 1.0);
}

TEST_F(HandWritten, RosWithTransformsAsRostopicPrintsThem) {
  write("front.yaml", kCameraInfo);
  write("tf_static.txt", R"(transforms:
  -
    header:
      seq: 0
      stamp: {secs: 0, nsecs: 0}
      frame_id: "world"
    child_frame_id: "front_optical"
    transform:
      translation: {x: 0.0, y: -4.0, z: 1.0}
      rotation: {x: -0.70710678, y: 0.0, z: 0.0, w: 0.70710678}
---
)");
  expectCamera({path("front.yaml"), path("tf_static.txt")}, CalibrationFormat::kRos, "front");
}

TEST_F(HandWritten, KalibrChainsItsCameras) {
  write("camchain.yaml", R"(cam0:
  cam_overlaps: [1]
  camera_model: pinhole
  distortion_coeffs: [-0.2, 0.0, 0.0, 0.0]
  distortion_model: radtan
  intrinsics: [500.0, 500.0, 320.0, 240.0]
  resolution: [640, 480]
  rostopic: /front/image_raw
cam1:
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -1.0]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
  cam_overlaps: [0]
  camera_model: pinhole
  distortion_coeffs: [-0.2, 0.0, 0.0, 0.0]
  distortion_model: radtan
  intrinsics: [500.0, 500.0, 320.0, 240.0]
  resolution: [640, 480]
  rostopic: /side/image_raw
)");
  const CalibrationSet set = readCalibration({path("camchain.yaml")});
  EXPECT_EQ(set.cameras.at(1).name, "side");
  EXPECT_EQ(set.remarks.at(0), "a camchain has no world: the world is the optical frame of front");
  const Eigen::Vector3d point(0.4, -0.2, 4.0);
  expectPixel(set, 0, point, kPixel);
  // One metre to the right: (-0.15, -0.05), r^2 = 0.025, factor 0.995.
  expectPixel(set, 1, point, {320.0 - 75.0 * 0.995, 240.0 - 25.0 * 0.995});
  EXPECT_TRUE(set.cameras[1].T_world_camera.translation().isApprox(Eigen::Vector3d(1, 0, 0)));
}

TEST_F(HandWritten, OpenCvXmlWithARotationVector) {
  write("front.xml", R"(<?xml version="1.0"?>
<opencv_storage>
<image_width>640</image_width>
<image_height>480</image_height>
<camera_matrix type_id="opencv-matrix"><rows>3</rows><cols>3</cols><dt>d</dt>
  <data>500. 0. 320. 0. 500. 240. 0. 0. 1.</data></camera_matrix>
<distortion_coefficients type_id="opencv-matrix"><rows>5</rows><cols>1</cols><dt>d</dt>
  <data>-0.2 0. 0. 0. 0.</data></distortion_coefficients>
<rvec type_id="opencv-matrix"><rows>3</rows><cols>1</cols><dt>d</dt>
  <data>1.57079632679 0. 0.</data></rvec>
<tvec type_id="opencv-matrix"><rows>3</rows><cols>1</cols><dt>d</dt><data>0. 1. 4.</data></tvec>
</opencv_storage>
)");
  expectCamera({path("front.xml")}, CalibrationFormat::kOpenCv, "front");
}

TEST_F(HandWritten, LensThatFoldsInTheCornerIsReadWithoutASize) {
  const auto camera = [](const std::string& k1) {
    return R"(<?xml version="1.0"?>
<opencv_storage>
<CameraMatrix type_id="opencv-matrix"><rows>3</rows><cols>3</cols><dt>d</dt>
  <data>490. 0. 336. 0. 492. 224. 0. 0. 1.</data></CameraMatrix>
<DistortionCoeffs type_id="opencv-matrix"><rows>1</rows><cols>5</cols><dt>d</dt>
  <data>)" +
           k1 + R"( 0.2 0. 0. -0.07</data></DistortionCoeffs>
<Rotation type_id="opencv-matrix"><rows>3</rows><cols>1</cols><dt>d</dt>
  <data>1.57079632679 0. 0.</data></Rotation>
<Translation type_id="opencv-matrix"><rows>3</rows><cols>1</cols><dt>d</dt>
  <data>0. 1. 4.</data></Translation>
</opencv_storage>
)";
  };
  write("front.xml", camera("-0.37"));
  EXPECT_EQ(readCalibration({path("front.xml")}).cameras.at(0).width, 0);
  write("folded.xml", camera("-37."));
  EXPECT_NE(errorTextOf<std::exception>([&] {
              readCalibration({path("folded.xml")});
            }).find("the distortion D is not of a lens"),
            std::string::npos);
}

TEST_F(HandWritten, OpenCvYamlWithLensAndPoseInTwoFilesOfAFolderPerCamera) {
  write("front/intrinsics.yml",
        "%YAML:1.0\n---\nK: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n"
        "  data: [500., 0., 320., 0., 500., 240., 0., 0., 1.]\n"
        "D: !!opencv-matrix\n  rows: 1\n  cols: 4\n  dt: d\n  data: [-0.2, 0., 0., 0.]\n");
  const char* pose =
      "%YAML:1.0\n---\nR: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n"
      "  data: [1., 0., 0., 0., 0., -1., 0., 1., 0.]\n"
      "T: !!opencv-matrix\n  rows: 3\n  cols: 1\n  dt: d\n  data: [0., 1., 4.]\n";
  write("front/extrinsics.yml", pose);
  write("side/extrinsics.yml", pose);
  std::filesystem::copy(path("front/intrinsics.yml"), path("side/intrinsics.yml"));
  write("side/notes.txt", "12.5 m from the door");
  const auto set = expectCamera({path("")}, CalibrationFormat::kOpenCv, "front");
  EXPECT_EQ(set.cameras.at(1).name, "side");
  EXPECT_FALSE(set.metres_per_unit);
}

TEST_F(HandWritten, MatricesAsTextTagsAndOpenCvOfAnySign) {
  // K [R | t], times -2: a projection is known up to a factor.
  write("front.txt", "-1000 -640 0 -2560\n0 -480 1000 -2920\n0 -2 0 -8\n");
  expectCamera({path("front.txt")}, CalibrationFormat::kMatrices, "front", kPixelWithoutLens);
  write("tag.xml",
        "<?xml version=\"1.0\" ?>\n<camera>\n500, 320, 0, 1280; 0 240 -500 1460\n0 1 0 "
        "4</camera>");
  expectCamera({path("tag.xml")}, CalibrationFormat::kMatrices, "tag", kPixelWithoutLens);
  write("cv.yml",
        "%YAML:1.0\n---\nP: !!opencv-matrix\n  rows: 3\n  cols: 4\n  dt: f\n"
        "  data: [500., 320., 0., 1280., 0., 240., -500., 1460., 0., 1., 0., 4.]\n");
  expectCamera({path("cv.yml")}, CalibrationFormat::kMatrices, "cv", kPixelWithoutLens);
}

TEST_F(HandWritten, QualisysInSubpixelsAndMillimetresByColumns) {
  write("Calib.qca.txt", R"(<?xml version='1.0' encoding='ASCII'?>
<calibration created="2020" qtm-version="2.17" type="regular">
  <cameras>
    <camera active="1" avg-residual="0.4" model="Miqus Video" serial="21001" viewrotation="0">
      <fov_video bottom="479" left="0" right="639" top="0"/>
      <transform r11="1" r12="0" r13="0" r21="0" r22="0" r23="1" r31="0" r32="-1" r33="0" x="0" y="-4000" z="1000"/>
      <intrinsic centerPointU="20480" centerPointV="15360" focalLengthU="32000" focalLengthV="32000" focallength="9.3" radialDistortion1="-0.2" radialDistortion2="0" radialDistortion3="0" sensorMaxU="40896" sensorMaxV="30656" sensorMinU="0" sensorMinV="0" skew="0" tangentalDistortion1="0" tangentalDistortion2="0"/>
    </camera>
  </cameras>
</calibration>)");
  const auto set = expectCamera({path("Calib.qca.txt")}, CalibrationFormat::kQualisys, "21001");
  EXPECT_EQ(set.cameras[0].width, 640);
  EXPECT_EQ(set.cameras[0].height, 480);
  EXPECT_EQ(guessWorld(set).world.up, "z");
}

TEST_F(HandWritten, AniposeInTheUnitOfItsBoard) {
  write("calibration.toml", R"([cam_0]
name = "A"
size = [ 640, 480,]
matrix = [ [ 500.0, 0.0, 320.0,], [ 0.0, 500.0, 240.0,], [ 0.0, 0.0, 1.0,],]
distortions = [ -0.2, 0.0, 0.0, 0.0, 0.0,]
rotation = [ 1.5707963267948966, 0.0, 0.0,]
translation = [ 0.0, 1.0, 4.0,]

[metadata]
adjusted = false
)");
  const auto set = expectCamera({path("calibration.toml")}, CalibrationFormat::kAnipose, "A");
  EXPECT_FALSE(set.metres_per_unit);
}

TEST_F(HandWritten, FreeMoCapInMillimetres) {
  write("calibration.toml", R"([cam_0]
name = "Camera_000"
size = [ 640, 480,]
matrix = [ [ 500.0, 0.0, 320.0,], [ 0.0, 500.0, 240.0,], [ 0.0, 0.0, 1.0,],]
distortions = [ -0.2, 0.0, 0.0, 0.0, 0.0,]
rotation = [ 1.5707963267948966, 0.0, 0.0,]
translation = [ 0.0, 1000.0, 4000.0,]

[metadata]
charuco_square_size = 54.0
date_time_calibrated = "2023-05-17T15:46:07"
)");
  expectCamera({path("calibration.toml")}, CalibrationFormat::kFreeMoCap, "Camera_000");
}

TEST_F(HandWritten, CaliscopeInTheOrderOfTheFileWithoutCamerasToIgnore) {
  std::string text;
  for (const char* camera : {"10", "2", "3"})
    text += std::string("[cameras.") + camera + "]\ncam_id = " + camera +
            "\nrotation_count = 0\nignore = " + (camera[0] == '2' ? "true" : "false") + R"(
size = [640, 480]
matrix = [[500.0, 0.0, 320.0], [0.0, 500.0, 240.0], [0.0, 0.0, 1.0]]
distortions = [-0.2, 0.0, 0.0, 0.0, 0.0]
translation = [0.0, 1.0, 4.0]
rotation = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]

)";
  write("camera_array.toml", text);
  const auto set =
      expectCamera({path("camera_array.toml")}, CalibrationFormat::kCaliscope, "cam_10");
  ASSERT_EQ(set.cameras.size(), 2u);
  EXPECT_EQ(set.cameras[1].name, "cam_3");
  EXPECT_EQ(set.remarks.at(0), "camera cam_2 is left out, the file says to ignore it");
}

TEST_F(HandWritten, Pose2SimWithFourCoefficients) {
  write("Calib.toml", R"([cam_01]
name = "cam_01"
size = [ 640.0, 480.0]
matrix = [ [ 500.0, 0.0, 320.0], [ 0.0, 500.0, 240.0], [ 0.0, 0.0, 1.0]]
distortions = [ -0.2, 0.0, 0.0, 0.0]
rotation = [ 1.5707963267948966, 0.0, 0.0]
translation = [ 0.0, 1.0, 4.0]
fisheye = false

[metadata]
adjusted = false
error = 0.0
)");
  expectCamera({path("Calib.toml")}, CalibrationFormat::kPose2Sim, "cam_01");
}

TEST_F(HandWritten, EasyMocapWithNamesThatAreNumbers) {
  write(
      "intri.yml",
      "%YAML:1.0\r\n---\r\nnames:\r\n  - 01\r\nK_01: !!opencv-matrix\r\n  rows: 3\r\n  cols: 3\r\n"
      "  dt: d\r\n  data: [500.000, 0.000, 320.000, 0.000, 500.000, 240.000, 0.000, 0.000, "
      "1.000]\r\ndist_01: !!opencv-matrix\r\n  rows: 1\r\n  cols: 5\r\n  dt: d\r\n  data: [-0.200, "
      "0.000, 0.000, 0.000, 0.000]\r\n");
  write(
      "extri.yml",
      "%YAML:1.0\r\n---\r\nnames:\r\n  - 01\r\nR_01: !!opencv-matrix\r\n  rows: 3\r\n  cols: 1\r\n"
      "  dt: d\r\n  data: [1.570796, 0.000000, 0.000000]\r\nRot_01: !!opencv-matrix\r\n  rows: "
      "3\r\n  cols: 3\r\n  dt: d\r\n  data: [1.000, 0.000, 0.000, 0.000, 0.000, -1.000, 0.000, "
      "1.000, 0.000]\r\nT_01: !!opencv-matrix\r\n  rows: 3\r\n  cols: 1\r\n  dt: d\r\n  data: "
      "[0.000, 1.000, 4.000]\r\n");
  expectCamera({path("")}, CalibrationFormat::kEasyMocap, "01");
}

TEST_F(HandWritten, ColmapWithPixelCentresAtHalves) {
  write("cameras.txt",
        "# Camera list with one line of data per camera:\n"
        "#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n# Number of cameras: 1\n"
        "7 SIMPLE_RADIAL 640 480 500 320.5 240.5 -0.2\n");
  write("images.txt",
        "# Image list with two lines of data per image:\n"
        "#   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n"
        "#   POINTS2D[] as (X, Y, POINT3D_ID)\n# Number of images: 2\n"
        "3 0.70710678 0.70710678 0 0 0 1 4 7 front/0001.jpg\n"
        "2362.39 248.498 58396 1784.7 268.254 59027\n"
        "1 0.70710678 0.70710678 0 0 0 1 5 7 side/0001.jpg\n\n");
  write("points3D.txt", "# 3D point list\n63390 1.67 0.89 12.7 115 121 122 1.33 1 0 2 1\n");
  const auto set = expectCamera({path("")}, CalibrationFormat::kColmap, "front");
  ASSERT_EQ(set.cameras.size(), 2u);
  EXPECT_EQ(set.cameras[1].name, "side");
  EXPECT_TRUE(set.cameras[1].T_world_camera.translation().isApprox(Eigen::Vector3d(0, -5, 1)));
}

}  // namespace
}  // namespace markerless_mocap
