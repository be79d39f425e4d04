#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "calibration/start/board_pose.h"
#include "calibration/still_board.h"

namespace markerless_mocap {
namespace {

constexpr int kCells = 400;      // of the floor, along a side
constexpr double kAround = 3.0;  // sides of the board, from its middle to the border of the floor
constexpr double kBeside = 0.3;  // sides of the board, around its pattern, that belong to it
constexpr int kBlock = 25;       // cells along the side of a block, taken as independent
constexpr size_t kMostCameras = 12;

/// The floor around the board as one camera sees it, from straight above.
struct Floor {
  cv::Mat pattern;  ///< CV_32F: bright and dark, of about unit variance everywhere
  cv::Mat seen;     ///< CV_32F: 1 or 0
};

/// Place of a cell, m, on the board.
Eigen::Vector3d placeOf(const Board& board, int x, int y) {
  const double step = 2 * kAround * board.size().maxCoeff() / kCells;
  return {board.centre().x() + (x + 0.5 - kCells / 2.0) * step,
          board.centre().y() + (y + 0.5 - kCells / 2.0) * step, 0};
}

bool isBoard(const Board& board, const Eigen::Vector3d& place) {
  const Eigen::Vector2d off = (place.head<2>() - board.centre()).cwiseAbs() - board.size() / 2;
  return off.maxCoeff() < kBeside * board.size().maxCoeff();
}

/// What varies over a few cells, wherever it is bright or dark; where the camera does not see, 0.
cv::Mat patternOf(const cv::Mat& top, const cv::Mat& seen) {
  const auto blurred = [&](const cv::Mat& image, double sigma) {
    cv::Mat out, part;
    cv::GaussianBlur(image.mul(seen), out, {}, sigma);
    cv::GaussianBlur(seen, part, {}, sigma);
    return cv::Mat(out / cv::max(part, 1e-3));
  };
  cv::Mat fine = top - blurred(top, 12), spread;
  cv::GaussianBlur(fine.mul(seen), fine, {}, 2);
  cv::sqrt(blurred(fine.mul(fine), 20), spread);
  return fine.mul(seen) / (spread + 1.0);  // of a level of grey is noise
}

Floor floorOf(const Board& board, const CameraCalibration& lens, const BoardView& view,
              const cv::Mat& image) {
  CameraCalibration above = lens;
  above.T_world_camera =
      boardPose(board, view.corners, intrinsicsOf(lens), modelOf(lens)).camera_board.inverse();
  const Camera camera(above);
  cv::Mat map(kCells, kCells, CV_32FC2, cv::Scalar(-1, -1)), grey, top;
  Floor floor;
  floor.seen = cv::Mat::zeros(kCells, kCells, CV_32F);
  for (int y = 0; y < kCells; ++y)
    for (int x = 0; x < kCells; ++x) {
      const Eigen::Vector3d place = placeOf(board, x, y);
      const auto pixel = camera.projectInside(place);
      if (!pixel) continue;
      map.at<cv::Vec2f>(y, x) = {float(pixel->x()), float(pixel->y())};
      floor.seen.at<float>(y, x) = isBoard(board, place) ? 0.0f : 1.0f;
    }
  if (image.channels() == 3)
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  else
    grey = image;
  cv::remap(grey, top, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  top.convertTo(top, CV_32F);
  floor.pattern = patternOf(top, floor.seen);
  return floor;
}

/// Mean product of two patterns over the floor that both see, and how exactly it is known.
struct Likeness {
  double mean = 0.0, variance = 0.0;
  int blocks = 0;
};

Likeness likenessOf(const Floor& a, const Floor& b) {
  const cv::Mat both = a.seen.mul(b.seen), product = a.pattern.mul(b.pattern).mul(both);
  std::vector<double> means;
  for (int y = 0; y + kBlock <= kCells; y += kBlock)
    for (int x = 0; x + kBlock <= kCells; x += kBlock) {
      const cv::Rect block(x, y, kBlock, kBlock);
      const double cells = cv::sum(both(block))[0];
      if (cells > kBlock * kBlock / 2.0) means.push_back(cv::sum(product(block))[0] / cells);
    }
  Likeness like;
  like.blocks = int(means.size());
  for (const double mean : means) like.mean += mean / double(means.size());
  for (const double mean : means)
    like.variance += std::pow(mean - like.mean, 2) / double(means.size() * means.size());
  return like;
}

/// How many standard deviations more alike two floors are as they are than if one is turned.
double evidence(const Floor& a, const Floor& b) {
  constexpr int kLeastBlocks = 8;
  Floor turned;
  cv::rotate(b.pattern, turned.pattern, cv::ROTATE_180);
  cv::rotate(b.seen, turned.seen, cv::ROTATE_180);
  const Likeness same = likenessOf(a, b), other = likenessOf(a, turned);
  if (same.blocks < kLeastBlocks || other.blocks < kLeastBlocks) return 0;
  const double sigma = std::sqrt(same.variance + other.variance);
  return sigma > 0 ? (same.mean - other.mean) / sigma : 0;
}

bool isTurned(unsigned turns, size_t view) {
  return view > 0 && (turns >> (view - 1) & 1u);
}

}  // namespace

FloorTurns turnsByFloor(const Board& board, const std::vector<CameraToCalibrate>& cameras,
                        const std::vector<BoardView>& views, const std::vector<cv::Mat>& images) {
  FloorTurns result;
  result.turned.assign(views.size(), false);
  if (views.size() < 2 || views.size() > kMostCameras) return result;
  std::vector<Floor> floors;
  for (size_t i = 0; i < views.size(); ++i)
    floors.push_back(floorOf(board, *cameras[views[i].camera].given, views[i], images[i]));
  std::vector<std::vector<double>> same(views.size(), std::vector<double>(views.size(), 0.0));
  for (size_t a = 0; a < views.size(); ++a)
    for (size_t b = a + 1; b < views.size(); ++b) same[a][b] = evidence(floors[a], floors[b]);
  const auto sumOf = [&](unsigned turns) {
    double sum = 0;
    for (size_t a = 0; a < views.size(); ++a)
      for (size_t b = a + 1; b < views.size(); ++b)
        sum += isTurned(turns, a) == isTurned(turns, b) ? same[a][b] : -same[a][b];
    return sum;
  };
  unsigned best = 0;
  const unsigned all = 1u << (views.size() - 1);
  for (unsigned turns = 1; turns < all; ++turns)
    if (sumOf(turns) > sumOf(best)) best = turns;
  result.certainty = INFINITY;
  for (unsigned turns = 0; turns < all; ++turns) {
    if (turns == best) continue;
    int pairs = 0;  // in which they differ
    for (size_t a = 0; a < views.size(); ++a)
      for (size_t b = a + 1; b < views.size(); ++b)
        pairs += isTurned(turns ^ best, a) != isTurned(turns ^ best, b);
    result.certainty =
        std::min(result.certainty, (sumOf(best) - sumOf(turns)) / (2 * std::sqrt(double(pairs))));
  }
  for (size_t i = 0; i < views.size(); ++i) result.turned[i] = isTurned(best, i);
  return result;
}

}  // namespace markerless_mocap
