#include "tools/common/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "evaluation/body_silhouette.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

constexpr int kTileWidth = 320;         // pixels
constexpr double kTint = 0.55;          // share of the colour in a tinted pixel
constexpr double kMarginFactor = 1.25;  // size relative to the box around mask and body
const cv::Scalar kBodyColor(60, 200, 60), kMaskColor(40, 40, 230), kUnknownColor(230, 160, 40);

cv::Mat backdrop(const Camera& camera, const CameraFrame& frame, const cv::Mat& mask) {
  cv::Mat picture(camera.height(), camera.width(), CV_8UC3, cv::Scalar(40, 40, 40));
  if (frame.image.type() == CV_8UC3)
    frame.image.copyTo(picture);
  else if (!frame.image.empty())
    cv::cvtColor(frame.image, picture, cv::COLOR_GRAY2BGR);
  else if (!mask.empty())
    picture.setTo(cv::Scalar(120, 120, 120), personPixels(mask));
  return picture;
}

void drawOutline(const cv::Mat& area, const cv::Scalar& color, cv::Mat* picture) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(area, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  cv::drawContours(*picture, outlines, -1, color, 1, cv::LINE_AA);
}

void drawMask(const cv::Mat& mask, cv::Mat* picture) {
  drawOutline(mask == kUnknownPixel, kUnknownColor, picture);
  drawOutline(personPixels(mask), kMaskColor, picture);
}

cv::Mat resized(const cv::Mat& mat, int interpolation) {
  cv::Mat out;
  cv::resize(mat, out, {kTileWidth, std::max(1, kTileWidth * mat.rows / mat.cols)}, 0, 0,
             interpolation);
  return out;
}

cv::Mat blended(const cv::Mat& picture, const cv::Mat& area, const cv::Scalar& color,
                double share) {
  cv::Mat filled = picture.clone(), out;
  filled.setTo(color, area);
  cv::addWeighted(picture, 1.0 - share, filled, share, 0.0, out);
  return out;
}

std::string labelOf(const Camera& camera, const cv::Mat& mask, const cv::Mat& body) {
  if (mask.empty() || body.empty()) return camera.name();
  char iou[16];
  std::snprintf(iou, sizeof iou, "  %.2f", maskIou(body, mask));
  return camera.name() + iou;
}

cv::Mat tileOf(const Camera& camera, const CameraFrame& frame, const cv::Mat& mask,
               const cv::Mat& body) {
  cv::Mat picture = backdrop(camera, frame, mask);
  if (!body.empty()) picture = blended(picture, body, kBodyColor, 0.5);
  const cv::Rect shown = partToShow(picture.size(), mask, body);
  const bool smaller = shown.width > kTileWidth;
  cv::Mat tile = resized(picture(shown), smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
  if (!mask.empty()) drawMask(resized(mask(shown), cv::INTER_NEAREST), &tile);
  const std::string label = labelOf(camera, mask, body);
  cv::putText(tile, label, {8, 20}, cv::FONT_HERSHEY_SIMPLEX, 0.55, {0, 0, 0}, 3, cv::LINE_AA);
  cv::putText(tile, label, {8, 20}, cv::FONT_HERSHEY_SIMPLEX, 0.55, {255, 255, 255}, 1,
              cv::LINE_AA);
  return tile;
}

}  // namespace

cv::Rect partToShow(const cv::Size& image, const cv::Mat& mask, const cv::Mat& body) {
  const cv::Rect whole({0, 0}, image);
  cv::Rect shown;
  if (!mask.empty()) shown |= cv::boundingRect(personPixels(mask));
  if (!body.empty()) shown |= cv::boundingRect(body);
  if (shown.empty()) return whole;
  const double fraction =
      std::min(1.0, kMarginFactor * std::max(double(shown.width) / image.width,
                                             double(shown.height) / image.height));
  const cv::Size size(int(fraction * image.width), int(fraction * image.height));
  const cv::Point middle = (shown.tl() + shown.br()) / 2;
  return {{std::clamp(middle.x - size.width / 2, 0, image.width - size.width),
           std::clamp(middle.y - size.height / 2, 0, image.height - size.height)},
          size};
}

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

cv::Mat unknownTinted(const cv::Mat& picture, const cv::Mat& area) {
  return blended(picture, area, kUnknownColor, kTint);
}

}  // namespace markerless_mocap
