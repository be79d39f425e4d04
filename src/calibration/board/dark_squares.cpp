#include "calibration/board/dark_squares.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace markerless_mocap {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// What may be a dark square: a dark part of the image of the shape of a parallelogram.
struct Blob {
  Vector2d middle;
  Matrix2d scatter;
  double area = 0.0;
};

std::optional<Blob> blobIn(const cv::Mat& labels, int label, const cv::Rect& box) {
  Vector2d sum = Vector2d::Zero();
  Matrix2d squares = Matrix2d::Zero();
  double count = 0;
  for (int y = box.y; y < box.br().y; ++y) {
    const int* row = labels.ptr<int>(y);
    for (int x = box.x; x < box.br().x; ++x) {
      if (row[x] != label) continue;
      const Vector2d p(x, y);
      sum += p;
      squares += p * p.transpose();
      ++count;
    }
  }
  Blob blob;
  blob.middle = sum / count;
  blob.area = count;
  blob.scatter = squares / count - blob.middle * blob.middle.transpose();
  blob.scatter.diagonal().array() += 1.0 / 12;  // of a pixel itself
  // 12 for every parallelogram, 9 for two that meet in a corner.
  constexpr double kCompact = 10.8;
  if (blob.area < kCompact * std::sqrt(blob.scatter.determinant())) return std::nullopt;
  return blob;
}

std::vector<Blob> blobsOf(const cv::Mat& dark) {
  constexpr int kLeastArea = 12;  // pixels
  cv::Mat labels, statistics, middles;
  const int count = cv::connectedComponentsWithStats(dark, labels, statistics, middles, 4, CV_32S);
  std::vector<Blob> blobs;
  for (int i = 1; i < count; ++i) {
    const int* s = statistics.ptr<int>(i);
    const cv::Rect box(s[cv::CC_STAT_LEFT], s[cv::CC_STAT_TOP], s[cv::CC_STAT_WIDTH],
                       s[cv::CC_STAT_HEIGHT]);
    if (s[cv::CC_STAT_AREA] < kLeastArea || s[cv::CC_STAT_AREA] > dark.rows * dark.cols / 50)
      continue;
    if (const auto blob = blobIn(labels, i, box)) blobs.push_back(*blob);
  }
  return blobs;
}

/// A dark square's steps to the two next ones along its diagonals, as columns.
using Steps = Matrix2d;

/// The dark squares around a first one, by their numbers along its diagonals.
class Lattice {
 public:
  Lattice(const std::vector<Blob>& blobs, size_t seed) : blobs_(blobs) {
    const std::optional<Steps> steps = stepsOf(seed);
    if (!steps) return;
    add({0, 0}, seed, *steps);
    while (!waiting_.empty()) {
      const Key at = waiting_.front();
      waiting_.pop_front();
      for (const auto& [axis, sign] : {std::pair{0, 1}, {0, -1}, {1, 1}, {1, -1}})
        grow(at, axis, sign);
    }
  }

  using Key = std::pair<int, int>;
  struct Place {
    size_t blob;
    Steps steps;
  };
  const std::map<Key, Place>& places() const { return places_; }

 private:
  static constexpr double kOff = 0.3;  // of a step, from where a square is expected

  bool isLike(const Blob& a, const Blob& b) const {
    return a.area < 2.5 * b.area && b.area < 2.5 * a.area;
  }

  /// The blob nearest to a place, if it is near in units of the steps.
  std::optional<size_t> near(const Vector2d& place, const Steps& steps, const Blob& like) const {
    const Matrix2d inverse = steps.inverse();
    std::optional<size_t> best;
    double least = kOff;
    for (size_t i = 0; i < blobs_.size(); ++i) {
      const double off = (inverse * (blobs_[i].middle - place)).cwiseAbs().maxCoeff();
      if (off > least || !isLike(blobs_[i], like)) continue;
      least = off;
      best = i;
    }
    return best;
  }

  /// Of a square with neighbours on all four sides: in units of its own shape its two next ones are
  /// at right angles and about as far.
  std::optional<Steps> stepsOf(size_t seed) const {
    const Blob& own = blobs_[seed];
    const Eigen::LLT<Matrix2d> shape(own.scatter);
    std::vector<std::pair<double, size_t>> next;
    for (size_t i = 0; i < blobs_.size(); ++i)
      if (i != seed && isLike(blobs_[i], own))
        next.emplace_back(shape.matrixL().solve(blobs_[i].middle - own.middle).norm(), i);
    if (next.size() < 4) return std::nullopt;
    std::partial_sort(next.begin(), next.begin() + 4, next.end());
    Steps steps;
    steps.col(0) = blobs_[next[0].second].middle - own.middle;
    for (size_t k = 1; k < 4; ++k) {
      steps.col(1) = blobs_[next[k].second].middle - own.middle;
      const Matrix2d own_units = shape.matrixL().solve(steps);
      const double cosine = own_units.col(0).normalized().dot(own_units.col(1).normalized());
      if (std::abs(cosine) > 0.7 || next[k].first > 2.0 * next[0].first) continue;
      if (near(own.middle - steps.col(0), steps, own) &&
          near(own.middle - steps.col(1), steps, own))
        return steps;
    }
    return std::nullopt;
  }

  void add(const Key& key, size_t blob, const Steps& steps) {
    places_[key] = {blob, steps};
    used_.push_back(blob);
    waiting_.push_back(key);
  }

  void grow(const Key& at, int axis, int sign) {
    Key key = at;
    (axis == 0 ? key.first : key.second) += sign;
    if (places_.count(key)) return;
    const Place from = places_.at(at);
    const Blob& own = blobs_[from.blob];
    const auto found = near(own.middle + sign * from.steps.col(axis), from.steps, own);
    if (!found || std::count(used_.begin(), used_.end(), *found)) return;
    Steps steps = from.steps;
    steps.col(axis) = sign * (blobs_[*found].middle - own.middle);
    add(key, *found, steps);
  }

  const std::vector<Blob>& blobs_;
  std::map<Key, Place> places_;
  std::vector<size_t> used_;
  std::deque<Key> waiting_;
};

/// From squares (column, row) to pixels; empty if the lattice is not that of a board of so many.
cv::Mat boardToPixels(const Lattice& lattice, const std::vector<Blob>& blobs, cv::Size squares) {
  std::vector<cv::Point2f> on_board, pixels;
  for (const auto& [key, place] : lattice.places()) {
    on_board.emplace_back(float(key.first + key.second), float(key.first - key.second));
    const Vector2d& p = blobs[place.blob].middle;
    pixels.emplace_back(float(p.x()), float(p.y()));
  }
  const size_t dark = size_t(squares.area()) / 2;  // or one more
  if (on_board.size() < dark || on_board.size() > dark + 1) return {};
  cv::Rect2f box = cv::boundingRect(on_board);  // one more than the difference, in whole numbers
  if (int(box.width) == squares.height && int(box.height) == squares.width &&
      squares.width != squares.height) {
    for (cv::Point2f& p : on_board) std::swap(p.x, p.y);
    box = cv::Rect2f(box.y, box.x, box.height, box.width);
  }
  if (int(box.width) != squares.width || int(box.height) != squares.height) return {};
  for (cv::Point2f& p : on_board) p += cv::Point2f(0.5f - box.x, 0.5f - box.y);
  return cv::findHomography(on_board, pixels);
}

float greyAt(const cv::Mat& image, const Vector2d& p) {
  const int x = std::clamp(int(p.x()), 0, image.cols - 2),
            y = std::clamp(int(p.y()), 0, image.rows - 2);
  const float u = float(p.x()) - float(x), v = float(p.y()) - float(y);
  const float *above = image.ptr<float>(y), *below = image.ptr<float>(y + 1);
  return (1 - v) * ((1 - u) * above[x] + u * above[x + 1]) +
         v * ((1 - u) * below[x] + u * below[x + 1]);
}

/// About a corner the image is the same turned by half a turn, however it is blurred. The edges
/// near it, by which cv::cornerSubPix goes, are not where they seem if it is blurred along a
/// diagonal.
Vector2d centreOfSymmetry(const cv::Mat& image, Vector2d centre, int radius) {
  constexpr int kRounds = 20;
  constexpr double kStill = 0.002;  // pixels
  for (int k = 0; k < kRounds; ++k) {
    Matrix2d normal = Matrix2d::Zero();
    Vector2d right = Vector2d::Zero();
    for (int y = 0; y <= radius; ++y) {
      for (int x = y ? -radius : 1; x <= radius; ++x) {
        const Vector2d there = centre + Vector2d(x, y), opposite = centre - Vector2d(x, y);
        const auto slope = [&](int axis) {
          const Vector2d step = Vector2d::Unit(axis);
          return double(greyAt(image, there + step) - greyAt(image, there - step) -
                        greyAt(image, opposite + step) + greyAt(image, opposite - step)) /
                 2;
        };
        const Vector2d of_centre(slope(0), slope(1));
        normal += of_centre * of_centre.transpose();
        right += of_centre * double(greyAt(image, there) - greyAt(image, opposite));
      }
    }
    const Vector2d step = -normal.ldlt().solve(right);
    if (!step.allFinite()) break;
    centre += step;
    if (step.norm() < kStill) break;
  }
  return centre;
}

/// Corners of rows and columns, each refined in the image as the board's front shows it.
std::vector<cv::Point2f> refined(const cv::Mat& grey, const cv::Mat& to_pixels, cv::Size squares) {
  constexpr double kSide = 24, kMoved = 0.25;  // pixels of a square from the front; of its side
  const cv::Mat front_to_pixels =
      to_pixels * (cv::Mat_<double>(3, 3) << 1 / kSide, 0, 0, 0, 1 / kSide, 0, 0, 0, 1);
  cv::Mat front;
  cv::warpPerspective(grey, front, front_to_pixels,
                      {int(squares.width * kSide), int(squares.height * kSide)},
                      cv::INTER_CUBIC | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  front.convertTo(front, CV_32F);
  std::vector<cv::Point2f> corners, pixels;
  for (int y = 1; y < squares.height; ++y) {
    for (int x = 1; x < squares.width; ++x) {
      const Vector2d expected(x * kSide, y * kSide);
      const Vector2d corner = centreOfSymmetry(front, expected, int(0.9 * kSide));
      if (!((corner - expected).norm() < kMoved * kSide)) return {};
      corners.emplace_back(float(corner.x()), float(corner.y()));
    }
  }
  cv::perspectiveTransform(corners, pixels, front_to_pixels);
  return pixels;
}

std::vector<cv::Point2f> cornersIn(const cv::Mat& dark, const cv::Mat& grey, double magnified,
                                   cv::Size squares) {
  const std::vector<Blob> blobs = blobsOf(dark);
  if (blobs.size() < size_t(squares.area()) / 2) return {};
  std::vector<bool> tried(blobs.size(), false);
  for (size_t seed = 0; seed < blobs.size(); ++seed) {
    if (tried[seed]) continue;
    const Lattice lattice(blobs, seed);
    for (const auto& [key, place] : lattice.places()) tried[place.blob] = true;
    const cv::Mat to_large = boardToPixels(lattice, blobs, squares);
    if (to_large.empty()) continue;
    const double shift = 0.5 / magnified - 0.5;
    const cv::Mat to_grey =
        (cv::Mat_<double>(3, 3) << 1 / magnified, 0, shift, 0, 1 / magnified, shift, 0, 0, 1);
    std::vector<cv::Point2f> corners = refined(grey, to_grey * to_large, squares);
    if (!corners.empty()) return corners;
  }
  return {};
}

}  // namespace

std::vector<cv::Point2f> cornersByDarkSquares(const cv::Mat& grey, cv::Size inner) {
  constexpr int kWidth = 2000;  // pixels to which small images are magnified
  const int magnified = std::clamp(kWidth / std::max(1, grey.cols), 1, 4);
  cv::Mat large, dark, apart;
  cv::resize(grey, large, {}, magnified, magnified, cv::INTER_CUBIC);
  const cv::Size squares(inner.width + 1, inner.height + 1);
  for (const int block : {31, 61, 121}) {
    for (const int darker : {8, 20, 40}) {
      cv::adaptiveThreshold(large, dark, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV,
                            block, darker);
      for (const cv::Size bridge :
           {cv::Size(1, 1), cv::Size(9, 1), cv::Size(1, 9), cv::Size(5, 5)}) {
        cv::morphologyEx(dark, apart, cv::MORPH_OPEN,
                         cv::getStructuringElement(cv::MORPH_RECT, bridge));
        std::vector<cv::Point2f> found = cornersIn(apart, grey, magnified, squares);
        if (!found.empty()) return found;
      }
    }
  }
  return {};
}

}  // namespace markerless_mocap
