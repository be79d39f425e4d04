#include "tools/calibrate_rig/calibrate_rig.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "calibration/board_image.h"
#include "formats/ros_texts.h"
#include "markerless_mocap/camera/rig_file.h"
#include "tools/calibrate_rig/film.h"
#include "tools/calibrate_rig/find_boards.h"
#include "tools/calibrate_rig/walk_silhouettes.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr int kPlaces = 12;

class CalibrateRig : public ToolTest {
 protected:
  CalibrateRig() {
    arguments_.board.columns = 6;
    arguments_.board.rows = 5;
    arguments_.board.square = 0.1;
    arguments_.board.marker = 0.075;
    arguments_.output = path("out");
    arguments_.inputs = {path("films")};
  }

  /// Two cameras of 480 x 360 that look down the z axis of the board's room, 0.6 m apart.
  static std::vector<CameraCalibration> pair() {
    std::vector<CameraCalibration> cameras(2);
    for (int i = 0; i < 2; ++i) {
      cameras[i].name = i == 0 ? "left" : "right";
      cameras[i].width = 480;
      cameras[i].height = 360;
      cameras[i].K << 420, 0, 240, 0, 420, 180, 0, 0, 1;
      cameras[i].T_world_camera.translation().x() = 0.6 * i;
      cameras[i].T_world_camera.rotate(Eigen::AngleAxisd(-0.25 * i, Eigen::Vector3d::UnitY()));
    }
    return cameras;
  }

  static Eigen::Isometry3d boardAt(int place) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.translation() << 0.25 + 0.25 * std::sin(1.3 * place), 0.15 * std::cos(1.7 * place),
        1.5 + 0.4 * std::sin(0.9 * place);
    T.linear() =
        (Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()) *  // printed side to the cameras
         Eigen::AngleAxisd(0.5 * std::sin(2.1 * place), Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(0.5 * std::cos(1.1 * place), Eigen::Vector3d::UnitY()))
            .toRotationMatrix();
    return T.translate(Eigen::Vector3d(-0.3, -0.25, 0));
  }

  cv::Mat pictureOf(const CameraCalibration& camera, const Eigen::Isometry3d& world_board) const {
    constexpr double kPixels = 800, kMargin = 0.05;
    const Board board(arguments_.board);
    const cv::Mat flat = boardImage(board, kPixels, kMargin);
    std::vector<cv::Point2f> from, to;
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.6, 0),
                                          Eigen::Vector2d(0.6, 0.5), Eigen::Vector2d(0, 0.5)}) {
      const Eigen::Vector2d pixel =
          *Camera(camera).project(world_board * Eigen::Vector3d(corner.x(), corner.y(), 0));
      from.emplace_back((kMargin + corner.x()) * kPixels - 0.5,
                        (kMargin + board.size().y() - corner.y()) * kPixels - 0.5);
      to.emplace_back(pixel.x(), pixel.y());
    }
    // Drawn large and made small, so that edges are soft as a lens makes them.
    constexpr int kFine = 3;
    cv::Matx33d H = cv::getPerspectiveTransform(from, to);
    H = cv::Matx33d(kFine, 0, (kFine - 1) / 2.0, 0, kFine, (kFine - 1) / 2.0, 0, 0, 1) * H;
    cv::Mat fine, image;
    cv::warpPerspective(flat, fine, H, {camera.width * kFine, camera.height * kFine},
                        cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(150));
    cv::resize(fine, image, {camera.width, camera.height}, 0, 0, cv::INTER_AREA);
    return image;
  }

  void writePictures() const {
    for (const CameraCalibration& camera : pair()) {
      std::filesystem::create_directories(folder_ / "films" / camera.name);
      for (int place = 0; place < kPlaces; ++place) {
        const std::string file = (place < 10 ? "0" : "") + std::to_string(place) + ".png";
        cv::imwrite(path("films/" + camera.name + "/" + file), pictureOf(camera, boardAt(place)));
      }
    }
  }

  CalibrateRigArguments arguments_;
};

TEST_F(CalibrateRig, PicturesBecomeARig) {
  writePictures();
  const RigCalibration result = calibrateFilms(arguments_, nullptr, false);
  EXPECT_LT(result.rms, 0.5);
  const auto rig = readRig(path("out/rig.yaml"));
  ASSERT_EQ(rig.size(), 2u);
  EXPECT_EQ(rig[0].name, "left");
  const Eigen::Isometry3d left_right = rig[0].T_world_camera.inverse() * rig[1].T_world_camera;
  EXPECT_NEAR(left_right.translation().norm(), 0.6, 0.01);
  EXPECT_NEAR(Eigen::AngleAxisd(left_right.linear()).angle(), 0.25, 0.01);
  EXPECT_NEAR(rig[0].K(0, 0), 420, 6);
  EXPECT_NE(bytesOf("out/camera_info/right.yaml").find("camera_name: \"right\""),
            std::string::npos);
  EXPECT_NE(bytesOf("out/cameras.launch").find("world left_optical"), std::string::npos);
  EXPECT_NE(bytesOf("out/report.html").find("Seen together"), std::string::npos);
}

TEST_F(CalibrateRig, ABoardThatLiesStillPlacesKnownLenses) {
  for (const CameraCalibration& camera : pair()) {
    std::filesystem::create_directories(folder_ / "films" / camera.name);
    for (const char* file : {"/0.png", "/1.png", "/2.png"})
      cv::imwrite(path("films/" + camera.name + file), pictureOf(camera, boardAt(1)));
    writeText("lenses/" + camera.name + ".yaml", cameraInfoText(camera));
  }
  const auto run = [&] { calibrateFilms(arguments_, nullptr, false); };
  EXPECT_EQ(errorTextOf(run).substr(0, 33), "the board lies still in all films");
  arguments_.lenses = path("lenses");
  arguments_.floor = "right";
  run();
  for (size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d found = readRig(path("out/rig.yaml"))[i].T_world_camera.translation();
    EXPECT_LT((found - boardAt(1).inverse() * pair()[i].T_world_camera.translation()).norm(), 0.03);
  }
  const std::string page = bytesOf("out/report.html");
  EXPECT_NE(page.find("1 place of the board; 0 corners"), std::string::npos);
  EXPECT_EQ(page.find("views left out"), std::string::npos);  // no lens was tried
  EXPECT_EQ(page.find("Residuals of each view"), std::string::npos);
}

TEST_F(CalibrateRig, FloorIsTheBoardOfThePictureThatIsNamed) {
  writePictures();
  arguments_.floor = "left:3";
  calibrateFilms(arguments_, nullptr, false);
  const auto rig = readRig(path("out/rig.yaml"));
  const Eigen::Vector3d wanted = boardAt(3).inverse() * pair()[0].T_world_camera.translation();
  EXPECT_LT((rig[0].T_world_camera.translation() - wanted).norm(), 0.03);
  EXPECT_GT(rig[0].T_world_camera.translation().z(), 1.0);
}

/// Pictures in which a bright box goes to the right, one pixel per picture.
TEST_F(CalibrateRig, SilhouettesOfAWalkAreJoinedByTime) {
  constexpr int kPictures = 60;
  for (const std::string camera : {"left", "right"}) {
    std::filesystem::create_directories(folder_ / "walk" / camera);
    for (int k = 0; k < kPictures; k += camera == "left" ? 1 : 3) {
      cv::Mat image(120, 160, CV_8UC3, cv::Scalar(60, 70, 80));
      cv::rectangle(image, {20 + k, 40, 20, 50}, {200, 180, 160}, cv::FILLED);
      cv::imwrite(path("walk/" + camera + "/" + std::to_string(100 + k) + ".png"), image);
    }
  }
  const std::vector<FilmSource> films = findFilms({path("walk")}, "");
  std::vector<CameraToCalibrate> cameras = {{"left", 160, 120, {}}, {"right", 160, 120, {}}};
  const auto sets = walkSilhouettes(films, cameras, {0, 0}, false);
  ASSERT_EQ(sets.size(), 20u);  // those of the right
  for (size_t k = 0; k < sets.size(); ++k) {
    EXPECT_NEAR(cv::boundingRect(sets[k][0] == 255).x, 20 + int(k), 2) << k;
    EXPECT_NEAR(cv::boundingRect(sets[k][1] == 255).x, 20 + 3 * int(k), 2) << k;
  }
  // Films of the board that began at other times: 3 pictures.
  const auto moved = walkSilhouettes(films, cameras, {0, -3}, true);
  ASSERT_EQ(moved.size(), 20u);
  EXPECT_NEAR(cv::boundingRect(moved[5][0] == 255).x, 20 + 2, 2);
  EXPECT_TRUE(moved[0][0].empty());
  cameras[1].width = 161;
  EXPECT_EQ(errorTextOf<std::exception>([&] {
              walkSilhouettes(films, cameras, {0, 0}, false);
            }),
            "the walk's images of right are 160 x 120 pixels, those of the board 161 x 120");
  cameras[1].name = "top";
  EXPECT_EQ(errorTextOf<std::exception>([&] {
              walkSilhouettes(films, cameras, {0, 0}, false);
            }),
            "the walk needs films of two cameras or more, it has those of 1: films are named "
            "after their cameras");
}

TEST_F(CalibrateRig, OnlyOneThingGivesTheWorld) {
  arguments_.floor = "left:3";
  arguments_.walk = {path("walk")};
  EXPECT_EQ(errorTextOf<std::exception>([&] { calibrateFilms(arguments_, nullptr, false); }),
            "--floor, --points and --walk all say where the world is: choose one");
}

TEST_F(CalibrateRig, SeparatePicturesNeedPointsForPlaces) {
  arguments_.separate = true;
  writePictures();
  EXPECT_EQ(errorTextOf<std::exception>([&] { calibrateFilms(arguments_, nullptr, false); }),
            "with --separate no two cameras see the board at one time, so it cannot tell their "
            "places: give --points (docs/calibration.md), or --lens-only for the lenses alone");
  arguments_.lens_only = true;
  EXPECT_EQ(calibrateFilms(arguments_, nullptr, false).cameras.size(), 2u);
}

TEST_F(CalibrateRig, WhatIsMissingIsTold) {
  EXPECT_EQ(errorTextOf<std::exception>([&] { calibrateFilms(arguments_, nullptr, false); }),
            "there is no file or folder " + path("films"));
  writePictures();
  arguments_.floor = "middle";
  EXPECT_EQ(errorTextOf<std::exception>([&] { calibrateFilms(arguments_, nullptr, false); }),
            "--floor names the camera middle, there are left, right");
  arguments_.floor.clear();
  const BoardOptions right = arguments_.board;
  const std::string found_nowhere = "the board was found in no picture of any camera; ";
  arguments_.board.dictionary = "DICT_6X6_50";
  EXPECT_EQ(errorTextOf<std::exception>([&] { calibrateFilms(arguments_, nullptr, false); }),
            found_nowhere + "markers of DICT_4X4_50 are seen: --dictionary DICT_4X4_50");
  arguments_.board = right;
  arguments_.board.inverted = true;
  EXPECT_EQ(errorTextOf<std::exception>([&] { calibrateFilms(arguments_, nullptr, false); }),
            found_nowhere + "the board is black on white: leave out --inverted");
  EXPECT_FALSE(std::filesystem::exists(path("out")));
}

/// Of calibrateFilms(), without having searched a film.
TEST_F(CalibrateRig, OtherInputsAreReadBeforeTheFilms) {
  writePictures();
  const auto refusal = [&](void (*change)(CalibrateRigArguments*, const std::string&),
                           const std::string& value) {
    CalibrateRigArguments arguments = arguments_;
    change(&arguments, value);
    std::ostringstream notes;
    const std::string text =
        errorTextOf<std::exception>([&] { calibrateFilms(arguments, &notes, false); });
    EXPECT_EQ(notes.str(), "") << "the films were searched first";
    return text;
  };
  using A = CalibrateRigArguments;
  EXPECT_EQ(refusal([](A* a, const std::string& v) { a->points = v; }, path("none.yaml")),
            "cannot read the points in " + path("none.yaml") + ": there is no such file");
  EXPECT_EQ(refusal([](A* a, const std::string& v) { a->floor = v; }, "left:nan"),
            "--floor left:nan: after the colon comes a time in seconds");
  EXPECT_EQ(refusal([](A* a, const std::string& v) { a->floor = v; }, "middle:1"),
            "--floor names the camera middle, there are left, right");
  EXPECT_EQ(refusal([](A* a, const std::string& v) { a->walk = {v}; }, path("none")),
            "there is no file or folder " + path("none"));
  EXPECT_EQ(refusal([](A* a, const std::string& v) { a->lens_pictures = {v}; }, path("none")),
            "there is no file or folder " + path("none"));
  EXPECT_EQ(refusal([](A* a, const std::string& v) { a->lens = v; }, "k9")
                .rfind("there is no lens model 'k9', allowed are ", 0),
            0u);
  writeText("a_file", "");
  EXPECT_EQ(
      refusal([](A* a, const std::string& v) { a->output = v; }, path("a_file/out")),
      "cannot write the folder " + path("a_file/out") + ": " + path("a_file") + " is no folder");
  writeRig(path("rig.yaml"), {pair()[0]});
  EXPECT_NE(
      refusal([](A* a, const std::string& v) { a->lenses = v; }, path("rig.yaml")).find("right"),
      std::string::npos);
}

TEST_F(CalibrateRig, APipeIsNoVideo) {
  const std::string pipe = path("left.mp4");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(
      errorTextOf<std::exception>([&] {
        openFilm({"left", pipe, ""});
      }),
      "cannot read the video " + pipe + ": it is a folder, pipe or device, allowed are files");
}

TEST_F(CalibrateRig, TimesOfEachCameraAreRead) {
  writeText("times.csv", "sync_index,cam_id,frame_time\n0,0,5.5\n0,1,5.6\n1,1,5.8\n1,0,5.7\n");
  const FrameTimes times = readFrameTimes(path("times.csv"), {"cam_0", "cam_01"});
  EXPECT_EQ(times.at("cam_0"), (std::vector<double>{5.5, 5.7}));
  EXPECT_EQ(times.at("cam_01"), (std::vector<double>{5.6, 5.8}));
  EXPECT_EQ(errorTextOf<std::exception>([&] { readFrameTimes(path("times.csv"), {"cam_10"}); }),
            "no camera of " + path("times.csv") +
                " is called like the film cam_10, there are 0, 1 and the films cam_10");
  writeText("times.csv", "");
  EXPECT_EQ(errorTextOf<std::exception>([&] { readFrameTimes(path("times.csv"), {"cam_10"}); }),
            path("times.csv") + " is empty, wanted is a head line with cam_id and frame_time");
}

TEST_F(CalibrateRig, FilesBesideTheFilmsAreFound) {
  std::filesystem::create_directories(path("films"));
  EXPECT_EQ(fileBesideFilms(arguments_.inputs, {"board.yaml", "charuco.toml"}), "");
  writeText("films/charuco.toml", "");
  EXPECT_EQ(fileBesideFilms(arguments_.inputs, {"board.yaml", "charuco.toml"}),
            path("films/charuco.toml"));
  writeText("films/board.yaml", "");
  EXPECT_EQ(fileBesideFilms(arguments_.inputs, {"board.yaml", "charuco.toml"}),
            path("films/board.yaml"));
}

TEST_F(CalibrateRig, PointsNameTheirCameras) {
  writeText("points.yaml",
            "points:\n- {name: a, position: [1, 2, 3], sigma: 2.5, pixels: {left: [4, 5], right: "
            "[6, 7]}}\n");
  const std::vector<CameraToCalibrate> cameras = {{"left", 480, 360, {}}, {"right", 480, 360, {}}};
  const auto points = readKnownPoints(path("points.yaml"), cameras);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(points[0].pixels[1].second, Eigen::Vector2d(6, 7));
  EXPECT_EQ(points[0].sigma, 2.5);
  EXPECT_EQ(errorTextOf<std::exception>([&] {
              readKnownPoints(path("points.yaml"), {{"left", 480, 360, {}}});
            }),
            path("points.yaml") + " names the camera right, of which there is no film");
  writeText("points.yaml",
            "points:\n- {name: a, position: [1, 2, .nan], pixels: {left: [4, 5]}}\n");
  EXPECT_EQ(errorTextOf<std::exception>([&] { readKnownPoints(path("points.yaml"), cameras); }),
            path("points.yaml") +
                ": position of point a is missing or no list of finite numbers, allowed is [x, y, "
                "z] in metres");
  writeText("points.yaml", "points:\n- {name: a, position: [1, 2, 3], pixels: {left: 4}}\n");
  EXPECT_EQ(errorTextOf<std::exception>([&] { readKnownPoints(path("points.yaml"), cameras); }),
            path("points.yaml") +
                ": a pixel of point a is missing or no list of finite numbers, allowed is CAMERA: "
                "[u, v]");
}

}  // namespace
}  // namespace markerless_mocap
