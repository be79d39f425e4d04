#include "calibration/board_detector.h"

#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgproc.hpp>
#include <random>

#include "calibration/board/chessboard_corners.h"
#include "calibration/board_image.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

constexpr double kPixelsPerMetre = 1600, kMargin = 0.03;

BoardOptions charuco() {
  BoardOptions options;
  options.columns = 7;
  options.rows = 5;
  options.square = 0.04;
  options.marker = 0.03;
  return options;
}

/// The board as a camera sees it, and where its corners are then.
struct Picture {
  cv::Mat image;
  std::vector<Eigen::Vector2d> corners;
};

/// \param turn of the board in the image, degrees
Picture pictureOf(const Board& board, double turn = 20) {
  const cv::Mat flat = boardImage(board, kPixelsPerMetre, kMargin);
  const cv::Point2f centre(flat.cols / 2.0f, flat.rows / 2.0f);
  const cv::Mat flat_turn = cv::getRotationMatrix2D(centre, turn, 1.0);
  cv::Matx33d H(flat_turn.at<double>(0, 0), flat_turn.at<double>(0, 1),
                flat_turn.at<double>(0, 2) + 300, flat_turn.at<double>(1, 0),
                flat_turn.at<double>(1, 1), flat_turn.at<double>(1, 2) + 300, 0, 0, 1);
  H = cv::Matx33d(1, 0.1, 0, -0.05, 0.9, 0, 1.5e-4, 2e-4, 1) * H;
  Picture picture;
  const int ground = board.options().inverted ? 40 : 190;
  cv::Mat soft;
  cv::GaussianBlur(flat, soft, {0, 0}, 1.0);
  cv::warpPerspective(soft * 0.7 + 30, picture.image, H, {960, 800}, cv::INTER_AREA,
                      cv::BORDER_CONSTANT, cv::Scalar(ground));
  const double height = board.size().y();
  for (const Eigen::Vector2d& corner : board.corners()) {
    const cv::Vec3d p = H * cv::Vec3d((kMargin + corner.x()) * kPixelsPerMetre - 0.5,
                                      (kMargin + height - corner.y()) * kPixelsPerMetre - 0.5, 1);
    picture.corners.emplace_back(p[0] / p[2], p[1] / p[2]);
  }
  return picture;
}

void expectFound(const BoardOptions& options, size_t least, double turn = 20,
                 double tolerance = 0.35) {
  const Board board(options);
  const Picture picture = pictureOf(board, turn);
  const auto found = BoardDetector(board).detect(picture.image);
  ASSERT_TRUE(found);
  EXPECT_GE(found->ids.size(), least);
  for (size_t i = 0; i < found->ids.size(); ++i)
    EXPECT_LT((found->pixels[i] - picture.corners[found->ids[i]]).norm(), tolerance)
        << "corner " << found->ids[i];
}

TEST(BoardDetector, CornersBetweenMarkers) {
  expectFound(charuco(), 24);
}

TEST(BoardDetector, WhiteOnBlack) {
  BoardOptions options = charuco();
  options.inverted = true;
  expectFound(options, 24);
}

TEST(BoardDetector, EvenRowsBeginBlackOrWhite) {
  BoardOptions options = charuco();
  options.rows = 6;
  expectFound(options, 30);
  options.white_first = true;
  expectFound(options, 30);
  // Read as the other kind, the markers stand in the wrong squares.
  const Picture picture = pictureOf(Board(options));
  options.white_first = false;
  const auto found = BoardDetector(Board(options)).detect(picture.image);
  double error = found ? 0 : 1e3;
  for (size_t i = 0; found && i < found->ids.size(); ++i)
    error = std::max(error, (found->pixels[i] - picture.corners[found->ids[i]]).norm());
  EXPECT_GT(error, 10.0);
}

TEST(BoardDetector, CoveredBoardIsFoundInPart) {
  const Board board(charuco());
  Picture picture = pictureOf(board);
  picture.image.colRange(0, 480) = 120;
  const auto found = BoardDetector(board).detect(picture.image);
  ASSERT_TRUE(found);
  EXPECT_LT(found->ids.size(), 24u);
  for (size_t i = 0; i < found->ids.size(); ++i)
    EXPECT_LT((found->pixels[i] - picture.corners[found->ids[i]]).norm(), 0.5);
}

/// Around its former place the same corners are found; those beyond it are not lost.
TEST(BoardDetector, FormerPlaceChangesNothing) {
  const Board board(charuco());
  const BoardDetector detector(board);
  const Picture picture = pictureOf(board);
  cv::Mat wide(1600, 1920, CV_8UC1, cv::Scalar(190));
  picture.image.copyTo(wide(cv::Rect(500, 400, picture.image.cols, picture.image.rows)));
  const auto whole = detector.detect(wide);
  ASSERT_TRUE(whole);
  for (const double moved : {0.0, 30.0, -60.0, 400.0, 1500.0}) {
    BoardCorners before = *whole;
    for (Eigen::Vector2d& pixel : before.pixels) pixel.x() += moved;
    before.pixels.resize(12);  // as of a board that was covered in part
    const auto found = detector.detect(wide, false, &before);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->ids, whole->ids) << moved;
    for (size_t i = 0; i < std::min(found->ids.size(), whole->ids.size()); ++i)
      EXPECT_LT((found->pixels[i] - whole->pixels[i]).norm(), 0.05) << moved;
  }
}

TEST(BoardDetector, FormerPlaceOfAChessboardChangesNothing) {
  BoardOptions options;
  options.kind = "chessboard";
  options.columns = 8;
  options.rows = 5;
  const BoardDetector detector{Board(options)};
  const Picture picture = pictureOf(detector.board());
  cv::Mat wide(1600, 1920, CV_8UC1, cv::Scalar(190)), small;
  picture.image.copyTo(wide(cv::Rect(500, 400, picture.image.cols, picture.image.rows)));
  cv::resize(wide, small, {}, 0.3, 0.3, cv::INTER_AREA);  // squares of some ten pixels
  for (const cv::Mat& image : {wide, small}) {
    const auto whole = detector.detect(image);
    ASSERT_TRUE(whole);
    for (const double moved : {0.0, 0.1, -0.15, 0.9}) {
      BoardCorners before = *whole;
      for (Eigen::Vector2d& pixel : before.pixels) pixel.x() += moved * image.cols;
      const auto found = detector.detect(image, false, &before);
      ASSERT_TRUE(found) << moved;
      for (size_t i = 0; i < found->ids.size(); ++i)
        EXPECT_LT((found->pixels[i] - whole->pixels[i]).norm(), 0.1) << moved;
    }
  }
}

TEST(BoardDetector, AprilTagGrid) {
  BoardOptions options;
  options.kind = "markers";
  options.columns = 5;
  options.rows = 4;
  options.square = 0.06;
  options.marker = 0.045;
  options.dictionary = "DICT_APRILTAG_36h11";
  expectFound(options, 76, 20, 0.6);
  options.border_bits = 2;
  expectFound(options, 76, 20, 0.6);
}

TEST(BoardDetector, ChessboardLiesAsItsColoursTell) {
  BoardOptions options;
  options.kind = "chessboard";
  options.columns = 8;
  options.rows = 5;
  for (const double turn : {0.0, 20.0, 100.0, 180.0, 250.0}) expectFound(options, 28, turn, 0.12);
}

TEST(BoardDetector, ChessboardThatLooksTheSameTurned) {
  BoardOptions options;
  options.kind = "chessboard";
  options.columns = 7;
  options.rows = 5;
  ASSERT_TRUE(Board(options).looksSameTurned());
  const Board board(options);
  const Picture picture = pictureOf(board, 170);
  const auto found = BoardDetector(board).detect(picture.image);
  ASSERT_TRUE(found);
  double same = 0, turned = 0;
  for (size_t i = 0; i < found->ids.size(); ++i) {
    same = std::max(same, (found->pixels[i] - picture.corners[i]).norm());
    turned =
        std::max(turned, (found->pixels[i] - picture.corners[found->ids.size() - 1 - i]).norm());
  }
  EXPECT_LT(std::min(same, turned), 0.35);
}

/// The page whose corners come to lie where they are named.
cv::Mat placeOf(const cv::Mat& page, const std::vector<cv::Point2f>& corners) {
  const float right = float(page.cols), low = float(page.rows);
  const std::vector<cv::Point2f> of_page{{0, 0}, {right, 0}, {right, low}, {0, low}};
  return cv::getPerspectiveTransform(of_page, corners);
}

/// 640 x 480 pixels of a page on a grey floor. \param fine_page into an image `times` as large
/// \param blur pixels
cv::Mat pageOnTheFloor(const cv::Mat& page, const cv::Mat& fine_page, int times, double blur) {
  cv::Mat fine(480 * times, 640 * times, CV_8UC1, cv::Scalar(110)), image;
  cv::warpPerspective(page, fine, fine_page, fine.size(), cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
  cv::GaussianBlur(fine, fine, {}, blur * times);
  cv::resize(fine, image, {640, 480}, 0, 0, cv::INTER_AREA);
  return image;
}

/// As a camera of a room sees a board on the floor: far off, flat, on one of its corners, blurred.
Picture pictureOnTheFloor(const Board& board) {
  constexpr int kFine = 8;
  const cv::Mat page = boardImage(board, 400, 0.1);
  const cv::Mat fine_page = placeOf(page, {{1600, 2790}, {2290, 2580}, {2840, 2720}, {2170, 2970}});
  Picture picture;
  picture.image = pageOnTheFloor(page, fine_page, kFine, 0.9);
  const cv::Matx33d H = fine_page;
  for (const Eigen::Vector2d& corner : board.corners()) {
    const cv::Vec3d p = H * cv::Vec3d((0.1 + corner.x()) * 400 - 0.5,
                                      (0.1 + board.size().y() - corner.y()) * 400 - 0.5, 1);
    picture.corners.emplace_back((p[0] / p[2] + 0.5) / kFine - 0.5,
                                 (p[1] / p[2] + 0.5) / kFine - 0.5);
  }
  return picture;
}

TEST(BoardDetector, ChessboardThatLiesFarOffOnTheFloor) {
  BoardOptions options;
  options.kind = "chessboard";
  options.columns = 9;
  options.rows = 6;
  options.square = 0.1;
  const Board board(options);
  Picture picture = pictureOnTheFloor(board);
  cv::Mat noise(picture.image.size(), CV_8SC1);
  cv::theRNG().state = 4;
  cv::randn(noise, 0, 2);
  cv::add(picture.image, noise, picture.image, {}, CV_8U);
  const auto found = BoardDetector(board).detect(picture.image, true);
  ASSERT_TRUE(found);
  for (size_t i = 0; i < found->ids.size(); ++i)
    EXPECT_LT((found->pixels[i] - picture.corners[found->ids[i]]).norm(), 0.2) << "corner " << i;
}

/// A board on the floor, some 150 pixels wide, whose corners lie as a seed tells.
cv::Mat smallPicture(const Board& board, unsigned seed) {
  constexpr int kFine = 4;
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> u(-1, 1);
  const float w = 80 + 20 * u(random), h = 32 + 8 * u(random),
              back = w * (0.85f + 0.1f * u(random));
  const cv::Point2f at(320 + 150 * u(random), 400 + 30 * u(random));
  std::vector<cv::Point2f> corners{{-back, -h}, {back, -h}, {w, h}, {-w, h}};
  for (cv::Point2f& corner : corners)
    corner = kFine * (at + corner + cv::Point2f(10 * u(random), 6 * u(random)));
  const cv::Mat page = boardImage(board, 1500, 0.02);
  return pageOnTheFloor(page, placeOf(page, corners), kFine, 0.45);
}

// It is found in the whole picture first, and then around its former place.
TEST(BoardDetector, ChessboardThatLiesStillHasTheSameCornersInTheNextPicture) {
  BoardOptions options;
  options.kind = "chessboard";
  options.columns = 9;
  options.rows = 7;
  const BoardDetector detector{Board(options)};
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const cv::Mat image = smallPicture(detector.board(), seed);
    const auto first = detector.detect(image, true);
    ASSERT_TRUE(first) << seed;
    const auto next = detector.detect(image, true, &*first);
    ASSERT_TRUE(next) << seed;
    double apart = 0;
    for (size_t i = 0; i < first->pixels.size(); ++i)
      apart = std::max(apart, (next->pixels[i] - first->pixels[i]).norm());
    EXPECT_LT(apart, 0.1) << seed;  // pixels
  }
}

/// Corners of 7 x 4 seen at a steep angle from near.
std::vector<cv::Point2f> steepGrid() {
  std::vector<cv::Point2f> grid;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 7; ++x) {
      const float depth = 0.45f + 0.06f * float(y) + 0.02f * float(x);  // m
      grid.emplace_back(500 + 800 * (0.06f * float(x) - 0.18f) / depth,
                        400 + 800 * 0.02f * float(y) / depth);
    }
  return grid;
}

TEST(BoardDetector, AGridOfWhichAPartLiesElsewhereIsNone) {
  const cv::Size inner(7, 4);
  EXPECT_TRUE(isGrid(steepGrid(), inner));
  std::vector<cv::Point2f> mirrored = steepGrid();
  for (cv::Point2f& p : mirrored) p.x = -p.x;
  EXPECT_TRUE(isGrid(mirrored, inner));
  std::vector<cv::Point2f> row_elsewhere = steepGrid(), exchanged = steepGrid();
  for (size_t i = 21; i < 28; ++i) row_elsewhere[i].y += 60;
  EXPECT_FALSE(isGrid(row_elsewhere, inner));
  std::swap(exchanged[12], exchanged[13]);
  EXPECT_FALSE(isGrid(exchanged, inner));
}

TEST(BoardDetector, NothingInAnEmptyPicture) {
  const cv::Mat grey(480, 640, CV_8UC1, cv::Scalar(90));
  EXPECT_FALSE(BoardDetector(Board(charuco())).detect(grey));
  BoardOptions options;
  options.kind = "chessboard";
  EXPECT_FALSE(BoardDetector(Board(options)).detect(grey).has_value());
}

TEST(BoardOptions, WhatIsWrongIsNamed) {
  BoardOptions options = charuco();
  options.marker = 0.05;
  EXPECT_EQ(errorTextOf([&] { options.validate(); }),
            "board: marker is 0.050000 m, it must be smaller than square, 0.040000 m");
  options = charuco();
  options.columns = 20;
  options.rows = 20;
  EXPECT_EQ(errorTextOf([&] { options.validate(); }),
            "board: it needs the markers 0 to 199, dictionary DICT_4X4_50 has 50");
  options.kind = "chessboard";
  EXPECT_NE(errorTextOf([&] { options.validate(); }), "");
}

TEST(BoardOptions, BoardFileIsReadBack) {
  BoardOptions options = charuco();
  options.inverted = true;
  options.square = 0.0537;
  options.marker = 0.75 * options.square;
  const std::string path = ::testing::TempDir() + "board.yaml";
  std::ofstream(path) << boardText(options);
  EXPECT_EQ(boardText(readBoard(path)), boardText(options));
  std::ofstream(path) << "columns: 7\nrow: 5\n";
  EXPECT_NE(errorTextOf([&] { readBoard(path); }).find("row"), std::string::npos);
}

TEST(BoardOptions, BoardOfCaliscopeIsRead) {
  const std::string path = ::testing::TempDir() + "charuco.toml";
  const std::string text =
      "columns = 4\nrows = 5\nboard_height = 11.0\nboard_width = 8.5\nunits = \"inch\"\n"
      "dictionary = \"DICT_4X4_1000\"\naruco_scale = 0.75\ninverted = true\n";
  std::ofstream(path) << text << "square_size_override_cm = 5.4\n";
  const BoardOptions board = readBoard(path);
  EXPECT_EQ(board.columns, 4);
  EXPECT_EQ(board.rows, 5);
  EXPECT_DOUBLE_EQ(board.square, 0.054);
  EXPECT_DOUBLE_EQ(board.marker, 0.0405);
  EXPECT_EQ(board.dictionary, "DICT_4X4_1000");
  EXPECT_TRUE(board.inverted);
  std::ofstream(path) << text;
  EXPECT_NEAR(readBoard(path).square, 8.5 / 4 * 0.0254, 1e-12);  // 11 / 5 inches are more
  std::ofstream(path) << "columns = 4\n";
  EXPECT_EQ(errorTextOf([&] { readBoard(path); }),
            path + ": there is no rows, or it is of another kind");
}

}  // namespace
}  // namespace markerless_mocap
