#include "tools/calibrate_rig/coverage_picture.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr int kWidth = 480;
const cv::Scalar kGreen(80, 200, 80), kRed(60, 60, 230), kWhite(255, 255, 255);

void tintCells(const CameraCoverage& camera, cv::Mat* tile) {
  cv::Mat tinted = tile->clone();
  for (int row = 0; row < CameraCoverage::kRows; ++row)
    for (int column = 0; column < CameraCoverage::kColumns; ++column) {
      const cv::Point from(column * tile->cols / CameraCoverage::kColumns,
                           row * tile->rows / CameraCoverage::kRows);
      const cv::Point to((column + 1) * tile->cols / CameraCoverage::kColumns - 1,
                         (row + 1) * tile->rows / CameraCoverage::kRows - 1);
      if (camera.cells[size_t(row * CameraCoverage::kColumns + column)])
        cv::rectangle(tinted, from, to, kGreen, cv::FILLED);
      cv::rectangle(*tile, from, to, cv::Scalar::all(90));
    }
  cv::addWeighted(*tile, 0.7, tinted, 0.3, 0, *tile);
}

cv::Mat tileOf(const CameraCoverage& camera, int wanted, const cv::Mat& image,
               const BoardCorners& corners) {
  const double scale = image.empty() ? 1.0 : double(kWidth) / image.cols;
  const int height = image.empty() ? kWidth * 3 / 4 : int(std::lround(image.rows * scale));
  cv::Mat tile(height, kWidth, CV_8UC3, cv::Scalar::all(40));
  if (!image.empty()) {
    cv::resize(image, tile, tile.size(), 0, 0, cv::INTER_AREA);
    if (tile.channels() == 1) cv::cvtColor(tile, tile, cv::COLOR_GRAY2BGR);
  }
  tintCells(camera, &tile);
  for (const Eigen::Vector2d& pixel : corners.pixels)
    cv::circle(tile, cv::Point(int(pixel.x() * scale), int(pixel.y() * scale)), 3, kRed, 1);
  const std::string text =
      camera.name + "  " + std::to_string(camera.views) + " of " + std::to_string(wanted);
  cv::putText(tile, text, {8, 22}, cv::FONT_HERSHEY_SIMPLEX, 0.6, cv::Scalar::all(0), 3);
  cv::putText(tile, text, {8, 22}, cv::FONT_HERSHEY_SIMPLEX, 0.6, kWhite, 1);
  return tile;
}

}  // namespace

cv::Mat coveragePicture(const BoardCoverage& coverage, const std::vector<cv::Mat>& images,
                        const std::vector<BoardCorners>& corners) {
  std::vector<cv::Mat> tiles;
  int height = 0;
  for (size_t i = 0; i < coverage.cameras().size(); ++i) {
    tiles.push_back(tileOf(coverage.cameras()[i], coverage.goals().views, images[i], corners[i]));
    height = std::max(height, tiles.back().rows);
  }
  const int columns = int(std::ceil(std::sqrt(double(tiles.size()))));
  const int rows = (int(tiles.size()) + columns - 1) / columns;
  cv::Mat picture(rows * height, columns * kWidth, CV_8UC3, cv::Scalar::all(0));
  for (int i = 0; i < int(tiles.size()); ++i)
    tiles[size_t(i)].copyTo(picture(
        cv::Rect(i % columns * kWidth, i / columns * height, kWidth, tiles[size_t(i)].rows)));
  return picture;
}

}  // namespace markerless_mocap
