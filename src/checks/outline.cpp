#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "checks/seen_rig.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

constexpr double kSmallPart = 0.2;          // of the largest part
constexpr double kSmallPerson = 1 / 500.0;  // of the image

bool touchesBorder(const cv::Rect& box, const cv::Size& size) {
  return box.x <= 1 || box.y <= 1 || box.br().x >= size.width - 1 || box.br().y >= size.height - 1;
}

}  // namespace

Outline outlineOf(const cv::Mat& mask, int width, int height) {
  Outline outline;
  cv::Mat labels, stats, centres;
  const int count =
      cv::connectedComponentsWithStats(personPixels(mask), labels, stats, centres, 8, CV_32S);
  int largest = 0;
  for (int i = 1; i < count; ++i) largest = std::max(largest, stats.at<int>(i, cv::CC_STAT_AREA));
  if (largest < kSmallPerson * mask.total()) return outline;
  const double sx = double(width) / mask.cols, sy = double(height) / mask.rows;
  std::vector<cv::Point> border;
  for (int i = 1; i < count; ++i) {
    const int area = stats.at<int>(i, cv::CC_STAT_AREA);
    if (area < kSmallPart * largest) continue;
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    outline.cut |= touchesBorder(box, mask.size());
    outline.centre += area * Eigen::Vector2d(centres.at<double>(i, 0), centres.at<double>(i, 1));
    outline.area += area;
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(labels(box) == i, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE,
                     box.tl());
    for (const auto& contour : contours)
      border.insert(border.end(), contour.begin(), contour.end());
  }
  std::vector<cv::Point> hull;
  cv::convexHull(border, hull);
  const auto scaled = [&](const Eigen::Vector2d& pixel) {
    return Eigen::Vector2d((pixel.x() + 0.5) * sx - 0.5, (pixel.y() + 0.5) * sy - 0.5);
  };
  for (const cv::Point& corner : hull) outline.hull.push_back(scaled({corner.x, corner.y}));
  outline.centre = scaled(outline.centre / outline.area);
  outline.area *= sx * sy;
  return outline;
}

}  // namespace markerless_mocap
