#include "tracking/body_in_mask.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <set>

#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

// Of right calibrations 0.9 and more of the joints are inside, and nearly all of the silhouette is
// around them.
constexpr double kJointsInside = 0.5;
constexpr double kAround = 0.85;
constexpr double kMargin = 0.15;     // of the joints' extent, for head, hands and feet
constexpr double kSomebody = 0.003;  // of the image

/// The part of connected foreground that holds joints and lies in the box.
double partAround(const cv::Mat& foreground, const std::vector<cv::Point>& inside,
                  const cv::Rect& box) {
  cv::Mat labels;
  cv::connectedComponents(foreground, labels);
  std::set<int> touched;
  for (const cv::Point& joint : inside) touched.insert(labels.at<int>(joint));
  int all = 0, around = 0;
  for (const int label : touched) {
    const cv::Mat of_label = labels == label;
    all += cv::countNonZero(of_label);
    around += cv::countNonZero(of_label(box));
  }
  return all == 0 ? 1.0 : double(around) / all;
}

/// The joints' box with a margin, in the image.
cv::Rect boxAround(const std::vector<cv::Point2d>& joints, const cv::Size& image) {
  cv::Point2d low = joints.front(), high = joints.front();
  for (const cv::Point2d& joint : joints) {
    low = {std::min(low.x, joint.x), std::min(low.y, joint.y)};
    high = {std::max(high.x, joint.x), std::max(high.y, joint.y)};
  }
  const double margin = kMargin * std::max(high.x - low.x, high.y - low.y);
  const auto within = [](double value, int size) {
    return int(std::lround(std::clamp(value, 0.0, double(size))));
  };
  return {cv::Point(within(low.x - margin, image.width), within(low.y - margin, image.height)),
          cv::Point(within(high.x + margin, image.width), within(high.y + margin, image.height))};
}

}  // namespace

bool mayShowBody(const Camera& camera, const cv::Mat& mask,
                 const std::vector<Eigen::Vector3d>& joints) {
  std::vector<cv::Point2d> seen;  // also beside the image
  std::vector<cv::Point> in_view, inside;
  for (const Eigen::Vector3d& joint : joints) {
    const std::optional<Eigen::Vector2d> pixel = camera.project(joint);
    if (pixel) seen.emplace_back(pixel->x(), pixel->y());
    if (!camera.projectInside(joint)) continue;
    const cv::Point at(int(std::lround(pixel->x())), int(std::lround(pixel->y())));
    if (mask.at<uint8_t>(at) == kUnknownPixel) continue;
    in_view.push_back(at);
    if (mask.at<uint8_t>(at) != kBackgroundPixel) inside.push_back(at);
  }
  const cv::Mat foreground = personPixels(mask);
  if (in_view.empty())
    return hasUnknownPixels(mask) ||
           cv::countNonZero(foreground) < kSomebody * double(mask.total());
  if (double(inside.size()) < kJointsInside * double(in_view.size())) return false;
  return partAround(foreground, inside, boxAround(seen, mask.size())) >= kAround;
}

}  // namespace markerless_mocap
