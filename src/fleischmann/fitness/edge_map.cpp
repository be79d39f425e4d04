#include "fleischmann/fitness/edge_map.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace markerless_mocap {
namespace {

/// The part of the image that can contain blurred edges of the person.
cv::Rect reachOf(const cv::Mat& silhouette, const EdgeSettings& settings) {
  const cv::Rect body = cv::boundingRect(silhouette);
  if (body.empty()) return {};
  const int margin = settings.reach + int(std::ceil(4.0 * settings.blur)) + 1;
  return cv::Rect(body.x - margin, body.y - margin, body.width + 2 * margin,
                  body.height + 2 * margin) &
         cv::Rect(0, 0, silhouette.cols, silhouette.rows);
}

cv::Mat edgesOf(const cv::Mat& grey, double threshold) {
  cv::Mat dx, dy, squared;
  cv::Sobel(grey, dx, CV_32F, 1, 0);
  cv::Sobel(grey, dy, CV_32F, 0, 1);
  squared = dx.mul(dx) + dy.mul(dy);
  return squared > threshold * threshold;
}

}  // namespace

cv::Mat edgeMap(const cv::Mat& image, const cv::Mat& silhouette, const EdgeSettings& settings) {
  if (silhouette.type() != CV_8UC1 || image.size() != silhouette.size() ||
      (image.type() != CV_8UC1 && image.type() != CV_8UC3))
    throw std::invalid_argument(
        "edges need an 8-bit image of one or three channels and a mono8 silhouette of the same "
        "size");
  cv::Mat map = cv::Mat::zeros(image.size(), CV_8UC1);
  const cv::Rect part = reachOf(silhouette, settings);
  if (part.empty()) return map;
  cv::Mat grey = image(part);
  if (image.channels() == 3) cv::cvtColor(grey, grey, cv::COLOR_BGR2GRAY);
  cv::Mat near;
  const int size = 2 * settings.reach + 1;
  cv::dilate(silhouette(part) != 0, near,
             cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(size, size)));
  cv::Mat blurred;
  cv::Mat(edgesOf(grey, settings.threshold) & near).convertTo(blurred, CV_32F);
  cv::GaussianBlur(blurred, blurred, cv::Size(), settings.blur, settings.blur, cv::BORDER_CONSTANT);
  double highest = 0.0;
  cv::minMaxLoc(blurred, nullptr, &highest);
  if (highest > 0.0) blurred.convertTo(map(part), CV_8U, 255.0 / highest);
  return map;
}

}  // namespace markerless_mocap
