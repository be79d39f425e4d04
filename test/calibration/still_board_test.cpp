// One board on the floor, cameras whose lenses are known.
#include "calibration/still_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "board_scene.h"

namespace markerless_mocap {
namespace {

BoardScene floorScene() {
  BoardScene scene;
  scene.board.kind = "chessboard";
  scene.board.columns = 9;
  scene.board.rows = 7;
  scene.board.square = 0.115;
  scene.addRing(4);
  return scene;
}

/// Corner of the board at the origin; z of the board is up.
CalibrationInput filmsOfFloor(const BoardScene& scene, int images) {
  CalibrationInput input;
  input.board = scene.board;
  std::mt19937 random(3);
  for (size_t i = 0; i < scene.cameras.size(); ++i) {
    input.cameras.push_back(
        {scene.cameras[i].name, scene.cameras[i].width, scene.cameras[i].height, scene.cameras[i]});
    for (int k = 0; k < images; ++k)
      input.views.push_back(*scene.viewAt(i, 0.1 * k, Eigen::Isometry3d::Identity(), &random));
  }
  return input;
}

/// Marks on the floor as a camera sees them. \param contrast levels of grey
cv::Mat imageOfFloor(const CameraCalibration& calibration, double contrast) {
  cv::Mat floor(500, 500, CV_32F), image(calibration.height, calibration.width, CV_8UC1);
  cv::RNG random(8);
  random.fill(floor, cv::RNG::NORMAL, 0, 1);
  cv::GaussianBlur(floor, floor, {}, 2);
  const Camera camera(calibration);
  cv::RNG noise(uint64_t(calibration.K(0, 0)));
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u) {
      const Eigen::Vector3d ray = camera.rayDirection({u, v});
      double grey = 128 + noise.gaussian(2);
      if (ray.z() < -0.05) {
        const Eigen::Vector3d place =
            camera.position() - ray * (camera.position().z() / ray.z());  // 2 cm a cell
        const int x = int(place.x() * 50) + 250, y = int(place.y() * 50) + 250;
        if (x >= 0 && y >= 0 && x < floor.cols && y < floor.rows)
          grey += contrast * floor.at<float>(y, x) * 7;  // of unit variance before it was blurred
      }
      image.at<uchar>(v, u) = cv::saturate_cast<uchar>(grey);
    }
  return image;
}

std::vector<cv::Mat> imagesOfFloor(const BoardScene& scene, double contrast) {
  std::vector<cv::Mat> images;
  for (const CameraCalibration& camera : scene.cameras)
    images.push_back(imageOfFloor(camera, contrast));
  return images;
}

TEST(StillBoard, TellsWhereCamerasStandWhoseLensesAreKnown) {
  BoardScene scene = floorScene();
  scene.noise = 0.1;
  CalibrationInput input = filmsOfFloor(scene, 40);
  for (size_t i = 0; i < input.views.size(); i += 3)
    std::reverse(input.views[i].corners.pixels.begin(), input.views[i].corners.pixels.end());
  ASSERT_TRUE(mergeStillViews(48, true, &input.views));
  ASSERT_EQ(input.views.size(), 4u);
  const Board board(input.board);
  const FloorTurns turns = turnsByFloor(board, input.cameras, input.views, imagesOfFloor(scene, 8));
  EXPECT_GT(turns.certainty, kCertainTurns);
  for (size_t i = 0; i < 4; ++i)
    if (turns.turned[i])
      std::reverse(input.views[i].corners.pixels.begin(), input.views[i].corners.pixels.end());
  input.turns_known = true;
  input.floor = FloorView{};
  const RigCalibration result = calibrateRig(input);
  EXPECT_TRUE(result.good);
  EXPECT_TRUE(result.floor_known);
  EXPECT_LT(rigError(result, scene.cameras).largestPosition(), 0.005);
  for (const CalibratedCamera& camera : result.cameras)
    EXPECT_GT(camera.calibration.T_world_camera.translation().z(), 1.9);
}

TEST(StillBoard, AnEmptyFloorTellsNothing) {
  const BoardScene scene = floorScene();
  CalibrationInput input = filmsOfFloor(scene, 1);
  const FloorTurns turns =
      turnsByFloor(Board(input.board), input.cameras, input.views, imagesOfFloor(scene, 0));
  EXPECT_LT(turns.certainty, kCertainTurns);
}

TEST(StillBoard, ABoardThatIsMovedStaysManyViews) {
  BoardScene scene = floorScene();
  std::vector<BoardView> views = scene.input(5).views;
  const size_t before = views.size();
  EXPECT_FALSE(mergeStillViews(48, true, &views));
  EXPECT_EQ(views.size(), before);
}

}  // namespace
}  // namespace markerless_mocap
