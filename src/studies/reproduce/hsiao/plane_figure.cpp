#include "studies/reproduce/hsiao/plane_figure.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr int kReach = 2;       // pixels along each axis
constexpr int kNeighbors = 24;  // of an interior pixel
constexpr double kThreshold = 60.0,
                 kDissimilar = -0.9;  // thd and h of Eq. 3-14; k d + l falls from 1

double colorWeight(const cv::Vec3b& a, const cv::Vec3b& b) {
  return similarityWeight(cv::norm(cv::Vec3d(a) - cv::Vec3d(b)));
}

}  // namespace

double similarityWeight(double d) {
  return d < kThreshold ? 1.0 - d / kThreshold : kDissimilar;
}

cv::Mat testImage() {
  const cv::Scalar skin(150, 190, 240), suit(190, 90, 50);
  cv::Mat image(96, 88, CV_8UC3, cv::Scalar::all(0));
  cv::line(image, {36, 62}, {26, 90}, suit, 4);
  cv::line(image, {52, 62}, {62, 90}, suit, 4);
  cv::line(image, {37, 34}, {8, 50}, suit, 4);
  cv::line(image, {51, 34}, {80, 50}, suit, 4);
  cv::rectangle(image, cv::Point(34, 30), cv::Point(54, 63), suit, cv::FILLED);
  cv::rectangle(image, cv::Point(41, 24), cv::Point(47, 29), skin, cv::FILLED);
  cv::ellipse(image, {44, 16}, {8, 10}, 0, 0, 360, skin, cv::FILLED);
  return image;
}

PixelGraph pixelGraph(const cv::Mat& image, const PixelGraphOptions& weights) {
  PixelGraph plane;
  cv::Mat_<int> node_at(image.size(), -1);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      if (image.at<cv::Vec3b>(y, x) == cv::Vec3b()) continue;
      node_at(y, x) = int(plane.pixel.size());
      plane.pixel.emplace_back(x, y);
    }
  }
  std::vector<int> degree(plane.pixel.size(), 0);
  std::vector<Edge> edges;
  const cv::Rect inside({0, 0}, image.size());
  for (uint32_t node = 0; node < plane.pixel.size(); ++node) {
    for (int step = 0; step < 25; ++step) {
      const cv::Point at = plane.pixel[node] + cv::Point(step % 5 - kReach, step / 5 - kReach);
      if (!inside.contains(at) || node_at(at) < 0 || node_at(at) == int(node)) continue;
      ++degree[node];
      if (node_at(at) < int(node)) continue;
      edges.push_back({node, uint32_t(node_at(at)), 1.0});
    }
  }
  for (Edge& edge : edges) {
    const cv::Point a = plane.pixel[edge.from], b = plane.pixel[edge.to];
    if (weights.color) edge.weight += colorWeight(image.at<cv::Vec3b>(a), image.at<cv::Vec3b>(b));
    const bool full = degree[edge.from] == kNeighbors || degree[edge.to] == kNeighbors;
    if (full) edge.weight += weights.shrink;
  }
  plane.graph = graphOfEdges(plane.pixel.size(), edges);
  for (const cv::Point& at : plane.pixel) plane.graph.cell.emplace_back(at.x, at.y, 0);
  return plane;
}

}  // namespace markerless_mocap
