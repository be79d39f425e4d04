#include "contour/fit/signed_distance.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

// Steps of the chamfer distance along a row or column, a diagonal, and a knight's move, pixels as
// fixed point; values of OpenCV.
constexpr int kOne = 1 << 16, kDiagonal = 91750, kKnight = 143976;
constexpr int kFar = 1 << 29;   // more than any distance, and far from an overflow
constexpr int kReach = 2;       // rows and columns that a step reaches
constexpr int kMaxSide = 4096;  // pixels: kFar is more than any distance up to here

/// Lowers a row to what the next row and the one after it allow. All have kReach more columns on
/// both sides.
MOCAP_VECTORISED void lower(const int* __restrict next, const int* __restrict after, int n,
                            int* __restrict row) {
  for (int i = 0; i < n; ++i) {
    const int k0 = after[i - 1] < after[i + 1] ? after[i - 1] : after[i + 1];
    const int k1 = next[i - 2] < next[i + 2] ? next[i - 2] : next[i + 2];
    const int diagonal = next[i - 1] < next[i + 1] ? next[i - 1] : next[i + 1];
    const int knight = (k0 < k1 ? k0 : k1) + kKnight;
    const int other = diagonal + kDiagonal < next[i] + kOne ? diagonal + kDiagonal : next[i] + kOne;
    const int least = knight < other ? knight : other;
    row[i] = least < row[i] ? least : row[i];
  }
}

MOCAP_VECTORISED void begin(const uchar* __restrict shape, int n, int* __restrict inside,
                            int* __restrict outside) {
  for (int i = 0; i < n; ++i) {
    inside[i] = shape[i] ? kFar : 0;
    outside[i] = shape[i] ? 0 : kFar;
  }
}

MOCAP_VECTORISED void join(const int* __restrict inside, const int* __restrict outside, int n,
                           float* __restrict distance) {
  constexpr float kScale = 1.0f / kOne;
  for (int i = 0; i < n; ++i) {
    const float in = float(inside[i]) * kScale, out = float(outside[i]) * kScale;
    distance[i] = inside[i] > 0 ? 0.5f - in : out - 0.5f;
  }
}

/// Distances inside and outside, with a margin of kFar.
class Chamfer {
 public:
  explicit Chamfer(const cv::Size& size)
      : rows_(size.height),
        cols_(size.width),
        stride_(size_t(size.width + 2 * kReach)),
        inside_(stride_ * (size.height + 2 * kReach), kFar),
        outside_(inside_) {}

  void begin(const cv::Mat& shape) {
    for (int y = 0; y < rows_; ++y)
      markerless_mocap::begin(shape.ptr<uchar>(y), cols_, at(inside_, y), at(outside_, y));
  }

  void sweep() {
    for (int y = 0; y < rows_; ++y) {
      lowerBoth(y, -1);
      walk(at(inside_, y), at(outside_, y), 1);
    }
    for (int y = rows_ - 1; y >= 0; --y) {
      lowerBoth(y, 1);
      walk(at(inside_, y) + cols_ - 1, at(outside_, y) + cols_ - 1, -1);
    }
  }

  void copyTo(cv::Mat& distance) {
    distance.create(rows_, cols_, CV_32FC1);
    for (int y = 0; y < rows_; ++y)
      join(at(inside_, y), at(outside_, y), cols_, distance.ptr<float>(y));
  }

 private:
  int* at(std::vector<int>& values, int y) {
    return &values[size_t(y + kReach) * stride_ + kReach];
  }

  void lowerBoth(int y, int way) {
    for (std::vector<int>* values : {&inside_, &outside_})
      lower(at(*values, y + way), at(*values, y + 2 * way), cols_, at(*values, y));
  }

  /// Each value waits for the one before; two rows at once wait no longer than one.
  void walk(int* inside, int* outside, int way) const {
    int in = kFar, out = kFar;
    for (int i = 0; i < cols_; ++i, inside += way, outside += way) {
      *inside = in = std::min(*inside, in + kOne);
      *outside = out = std::min(*outside, out + kOne);
    }
  }

  int rows_, cols_;
  size_t stride_;
  std::vector<int> inside_, outside_;
};

cv::Mat depthOf(const cv::Mat& shape) {
  cv::Mat depth;
  cv::distanceTransform(shape, depth, cv::DIST_L2, cv::DIST_MASK_5, CV_32F);
  return depth;
}

/// For shapes without a border, and very large ones.
cv::Mat plainDistance(const cv::Mat& shape) {
  const cv::Mat inside = depthOf(shape), outside = depthOf(shape == 0);
  cv::Mat distance(shape.size(), CV_32FC1);
  for (int y = 0; y < shape.rows; ++y)
    for (int x = 0; x < shape.cols; ++x) {
      const float in = inside.at<float>(y, x), out = outside.at<float>(y, x);
      distance.at<float>(y, x) = in > 0 ? 0.5f - in : out - 0.5f;
    }
  return distance;
}

}  // namespace

cv::Mat signedDistance(const cv::Mat& shape) {
  const int count = cv::countNonZero(shape);
  if (count == 0 || count == int(shape.total()) || shape.rows + shape.cols > kMaxSide)
    return plainDistance(shape);
  Chamfer chamfer(shape.size());
  chamfer.begin(shape);
  chamfer.sweep();
  cv::Mat distance;
  chamfer.copyTo(distance);
  return distance;
}

}  // namespace markerless_mocap
