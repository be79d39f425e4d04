#include "tools/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "markerless_mocap/evaluation/body_silhouette.h"

namespace markerless_mocap {
namespace {

constexpr int kTileWidth = 320;  // pixels
const cv::Scalar kBodyColor(60, 200, 60), kMaskColor(40, 40, 230);

cv::Mat backdrop(const Camera& camera, const CameraFrame& frame, const cv::Mat& mask) {
  cv::Mat picture(camera.height(), camera.width(), CV_8UC3, cv::Scalar(40, 40, 40));
  if (frame.image.type() == CV_8UC3)
    frame.image.copyTo(picture);
  else if (!frame.image.empty())
    cv::cvtColor(frame.image, picture, cv::COLOR_GRAY2BGR);
  else if (!mask.empty())
    picture.setTo(cv::Scalar(120, 120, 120), mask);
  return picture;
}

void drawMask(const cv::Mat& mask, cv::Mat* picture) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  cv::drawContours(*picture, outlines, -1, kMaskColor, 2);
}

cv::Mat tileOf(const Camera& camera, const CameraFrame& frame, const cv::Mat& mask,
               const cv::Mat& body) {
  cv::Mat picture = backdrop(camera, frame, mask);
  std::string label = camera.name();
  if (!body.empty()) {
    cv::Mat filled = picture.clone();
    filled.setTo(kBodyColor, body);
    cv::addWeighted(picture, 0.5, filled, 0.5, 0.0, picture);
  }
  if (!mask.empty()) drawMask(mask, &picture);
  if (!mask.empty() && !body.empty()) {
    char iou[16];
    std::snprintf(iou, sizeof iou, "  %.2f", maskIou(body, mask));
    label += iou;
  }
  cv::Mat tile;
  cv::resize(picture, tile, {kTileWidth, kTileWidth * picture.rows / picture.cols}, 0, 0,
             cv::INTER_AREA);
  cv::putText(tile, label, {8, 20}, cv::FONT_HERSHEY_SIMPLEX, 0.55, {0, 0, 0}, 3, cv::LINE_AA);
  cv::putText(tile, label, {8, 20}, cv::FONT_HERSHEY_SIMPLEX, 0.55, {255, 255, 255}, 1,
              cv::LINE_AA);
  return tile;
}

}  // namespace

cv::Mat overlayOf(const CameraRig& rig, const std::vector<CameraFrame>& frames,
                  const std::vector<cv::Mat>& masks, const std::vector<cv::Mat>& bodies) {
  std::vector<cv::Mat> tiles;
  int height = 0;
  for (size_t i = 0; i < rig.size(); ++i) {
    tiles.push_back(tileOf(rig[i], frames[i], masks[i], bodies.empty() ? cv::Mat() : bodies[i]));
    height = std::max(height, tiles.back().rows);
  }
  const int columns = int(std::ceil(std::sqrt(double(tiles.size()))));
  const int rows = (int(tiles.size()) + columns - 1) / columns;
  cv::Mat sheet = cv::Mat::zeros(rows * height, columns * kTileWidth, CV_8UC3);
  for (size_t i = 0; i < tiles.size(); ++i) {
    const cv::Point corner(int(i) % columns * kTileWidth, int(i) / columns * height);
    tiles[i].copyTo(sheet(cv::Rect(corner, tiles[i].size())));
  }
  return sheet;
}

}  // namespace markerless_mocap
