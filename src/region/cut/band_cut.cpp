#include "region/cut/band_cut.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>
#include <vector>

namespace markerless_mocap {
namespace {

constexpr float kSmoothness = 7.f;       // cost of a border between two samples of the same colour
constexpr float kDiagonal = .70710678f;  // of it, by the distance of the neighbours

int squaredDifference(const cv::Vec3b& a, const cv::Vec3b& b) {
  const int d0 = a[0] - b[0], d1 = a[1] - b[1], d2 = a[2] - b[2];
  return d0 * d0 + d1 * d1 + d2 * d2;
}

/// Mean squared difference of neighbours in the band.
float meanSquaredDifference(const cv::Mat& image, const cv::Mat& band) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < image.rows; ++y) {
    const cv::Vec3b* color = image.ptr<cv::Vec3b>(y);
    const uchar* undecided = band.ptr<uchar>(y);
    for (int x = 0; x + 1 < image.cols; ++x)
      if (undecided[x]) {
        sum += squaredDifference(color[x], color[x + 1]);
        ++count;
      }
  }
  return count ? float(sum / count) : 0.f;
}

/// Costs of the samples of the band, and of borders between neighbours, as a graph.
class BandGraph {
 public:
  BandGraph(const cv::Mat& image, const cv::Mat& log_odds, const cv::Mat& band)
      : image_(image), log_odds_(log_odds), number_(band.size(), CV_32SC1) {
    number(band);
    graph_.create(unsigned(of_person_.size()), unsigned(8 * of_person_.size()));
    for (size_t i = 0; i < of_person_.size(); ++i) graph_.addVtx();
    falloff_ = 0.5f / std::max(meanSquaredDifference(image, band), 1.f);
    for (int y = 0; y < image.rows; ++y) linkRow(y);
    for (size_t i = 0; i < of_person_.size(); ++i)
      graph_.addTermWeights(int(i), of_person_[i], of_others_[i]);
  }

  /// Decides the samples of the band; the others are left as they are.
  void cut(cv::Mat& mask) {
    graph_.maxFlow();
    for (int y = 0; y < mask.rows; ++y) {
      const int* numbers = number_.ptr<int>(y);
      uchar* decided = mask.ptr<uchar>(y);
      for (int x = 0; x < mask.cols; ++x)
        if (numbers[x] >= 0) decided[x] = graph_.inSourceSegment(numbers[x]) ? 255 : 0;
    }
  }

 private:
  /// Numbers the samples of the band; -1 outside.
  void number(const cv::Mat& band) {
    for (int y = 0; y < band.rows; ++y) {
      const uchar* undecided = band.ptr<uchar>(y);
      const float* odds = log_odds_.ptr<float>(y);
      int* numbers = number_.ptr<int>(y);
      for (int x = 0; x < band.cols; ++x) {
        numbers[x] = undecided[x] ? int(of_person_.size()) : -1;
        if (!undecided[x]) continue;
        of_person_.push_back(std::max(odds[x], 0.f));
        of_others_.push_back(std::max(-odds[x], 0.f));
      }
    }
  }

  /// Links the samples of a row with their neighbours to the right and in the next row.
  void linkRow(int y) {
    const Row here = row(y), below = y + 1 < image_.rows ? row(y + 1) : Row{};
    for (int x = 0; x < image_.cols; ++x) {
      if (x + 1 < image_.cols) link(here, x, here, x + 1, kSmoothness);
      if (!below.numbers) continue;
      link(here, x, below, x, kSmoothness);
      if (x + 1 < image_.cols) link(here, x, below, x + 1, kSmoothness * kDiagonal);
      if (x > 0) link(here, x, below, x - 1, kSmoothness * kDiagonal);
    }
  }

  struct Row {
    const int* numbers = nullptr;
    const cv::Vec3b* colors = nullptr;
    const float* log_odds = nullptr;
  };
  Row row(int y) const {
    return {number_.ptr<int>(y), image_.ptr<cv::Vec3b>(y), log_odds_.ptr<float>(y)};
  }

  /// Links two neighbours; one of them may be decided already.
  void link(const Row& from, int x, const Row& to, int other, float smoothness) {
    const int a = from.numbers[x], b = to.numbers[other];
    if (a < 0 && b < 0) return;
    const float difference = float(squaredDifference(from.colors[x], to.colors[other]));
    const float weight = smoothness * std::exp(-falloff_ * difference);
    if (a >= 0 && b >= 0) return graph_.addEdges(a, b, weight, weight);
    const bool person = (a >= 0 ? to.log_odds[other] : from.log_odds[x]) > 0;
    (person ? of_person_ : of_others_)[size_t(std::max(a, b))] += weight;
  }

  cv::Mat image_, log_odds_, number_;
  std::vector<float> of_person_, of_others_;  ///< weights of the terms
  float falloff_;                             ///< of a border's cost with the squared difference
  cv::detail::GCGraph<float> graph_;
};

}  // namespace

cv::Mat bandCut(const cv::Mat& image, const cv::Mat& log_odds, const cv::Mat& band) {
  cv::Mat mask = log_odds > 0;
  if (cv::countNonZero(band) > 0) BandGraph(image, log_odds, band).cut(mask);
  return mask;
}

}  // namespace markerless_mocap
