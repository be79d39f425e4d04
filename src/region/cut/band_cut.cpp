#include "region/cut/band_cut.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

namespace markerless_mocap {
namespace {

constexpr float kSmoothness = 7.f;  // cost of a border between two samples of the same colour

struct Neighbour {
  int x, y;
  float weight;  // by its distance
};
constexpr Neighbour kNeighbours[] = {
    {1, 0, 1.f}, {0, 1, 1.f}, {1, 1, .70710678f}, {-1, 1, .70710678f}};

float squaredDifference(const cv::Vec3b& a, const cv::Vec3b& b) {
  const float d0 = float(a[0]) - b[0], d1 = float(a[1]) - b[1], d2 = float(a[2]) - b[2];
  return d0 * d0 + d1 * d1 + d2 * d2;
}

/// Mean squared difference of neighbours in the band.
float meanSquaredDifference(const cv::Mat& image, const cv::Mat& band) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x + 1 < image.cols; ++x)
      if (band.at<uchar>(y, x)) {
        sum += squaredDifference(image.at<cv::Vec3b>(y, x), image.at<cv::Vec3b>(y, x + 1));
        ++count;
      }
  return count ? float(sum / count) : 0.f;
}

using Graph = cv::detail::GCGraph<float>;

/// Numbers the samples of the band; -1 outside.
cv::Mat numbered(const cv::Mat& band, int& count) {
  cv::Mat number(band.size(), CV_32SC1);
  count = 0;
  for (int y = 0; y < band.rows; ++y)
    for (int x = 0; x < band.cols; ++x) number.at<int>(y, x) = band.at<uchar>(y, x) ? count++ : -1;
  return number;
}

/// Links two neighbours; one of them may be decided already.
void link(Graph& graph, const cv::Mat& log_odds, const cv::Mat& number, const cv::Point& from,
          const cv::Point& to, float weight) {
  const int a = number.at<int>(from), b = number.at<int>(to);
  if (a >= 0 && b >= 0) graph.addEdges(a, b, weight, weight);
  if ((a >= 0) == (b >= 0)) return;
  const bool person = log_odds.at<float>(a >= 0 ? to : from) > 0;
  graph.addTermWeights(std::max(a, b), person ? weight : 0.f, person ? 0.f : weight);
}

void linkAll(Graph& graph, const cv::Mat& image, const cv::Mat& log_odds, const cv::Mat& band,
             const cv::Mat& number) {
  const float beta = 0.5f / std::max(meanSquaredDifference(image, band), 1.f);
  const cv::Rect inside(0, 0, image.cols, image.rows);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      for (const Neighbour& neighbour : kNeighbours) {
        const cv::Point from(x, y), to(x + neighbour.x, y + neighbour.y);
        if (!inside.contains(to) || (number.at<int>(from) < 0 && number.at<int>(to) < 0)) continue;
        const float difference =
            squaredDifference(image.at<cv::Vec3b>(from), image.at<cv::Vec3b>(to));
        link(graph, log_odds, number, from, to,
             kSmoothness * neighbour.weight * std::exp(-beta * difference));
      }
}

}  // namespace

cv::Mat bandCut(const cv::Mat& image, const cv::Mat& log_odds, const cv::Mat& band) {
  int count = 0;
  const cv::Mat number = numbered(band, count);
  cv::Mat mask = log_odds > 0;
  if (count == 0) return mask;
  Graph graph(unsigned(count), unsigned(4 * count));
  for (int i = 0; i < count; ++i) graph.addVtx();
  for (int y = 0; y < band.rows; ++y)
    for (int x = 0; x < band.cols; ++x)
      if (number.at<int>(y, x) >= 0) {
        const float odds = log_odds.at<float>(y, x);
        graph.addTermWeights(number.at<int>(y, x), std::max(odds, 0.f), std::max(-odds, 0.f));
      }
  linkAll(graph, image, log_odds, band, number);
  graph.maxFlow();
  for (int y = 0; y < band.rows; ++y)
    for (int x = 0; x < band.cols; ++x)
      if (number.at<int>(y, x) >= 0)
        mask.at<uchar>(y, x) = graph.inSourceSegment(number.at<int>(y, x)) ? 255 : 0;
  return mask;
}

}  // namespace markerless_mocap
