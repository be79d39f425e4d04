#include "calibration/board/marker_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace markerless_mocap {
namespace {

std::array<cv::Point2f, 4> placesOf(const Board& board, size_t marker) {
  const Eigen::Vector2d at = board.markers()[marker].upper_left;
  const float x = float(at.x()), y = float(at.y()), side = float(board.options().marker);
  return {cv::Point2f(x, y), cv::Point2f(x + side, y), cv::Point2f(x + side, y - side),
          cv::Point2f(x, y - side)};
}

/// Homography from the board to the image by some of its markers; empty if there is none.
cv::Mat homographyOf(const Board& board, const FoundMarkers& found,
                     const std::vector<size_t>& markers) {
  std::vector<cv::Point2f> places, pixels;
  for (const size_t marker : markers) {
    const auto corners = placesOf(board, marker);
    places.insert(places.end(), corners.begin(), corners.end());
    pixels.insert(pixels.end(), found.at(marker).begin(), found.at(marker).end());
  }
  return cv::findHomography(places, pixels);
}

cv::Point2f mapped(const cv::Mat& homography, const Eigen::Vector2d& place) {
  const cv::Matx33d H = homography;
  const cv::Vec3d p = H * cv::Vec3d(place.x(), place.y(), 1);
  return {float(p[0] / p[2]), float(p[1] / p[2])};
}

double distanceTo(const Board& board, size_t marker, const Eigen::Vector2d& place) {
  const double half = board.options().marker / 2;
  return (board.markers()[marker].upper_left + Eigen::Vector2d(half, -half) - place).norm();
}

/// Found markers near a place, nearest first, at most four; none if the nearest does not touch it.
std::vector<size_t> markersNear(const Board& board, const FoundMarkers& found,
                                const Eigen::Vector2d& place) {
  const double square = board.options().square;
  std::vector<std::pair<double, size_t>> near;
  for (const auto& [marker, corners] : found)
    if (const double d = distanceTo(board, marker, place); d < 2.3 * square)
      near.emplace_back(d, marker);
  std::sort(near.begin(), near.end());
  if (near.size() < 2 || near.front().first > 0.8 * square) return {};
  near.resize(std::min<size_t>(near.size(), 4));
  std::vector<size_t> markers;
  for (const auto& [distance, marker] : near) markers.push_back(marker);
  return markers;
}

/// Half the side of the window in which a corner is searched: the marker must stay outside.
int windowAround(const cv::Point2f& corner, const std::vector<cv::Point2f>& marker) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const cv::Point2f& p : marker) nearest = std::min(nearest, cv::norm(p - corner));
  return std::clamp(int(0.6 * nearest), 2, 10);
}

/// Moves a corner to the crossing of its edges; false if it would leave its window.
bool refine(const cv::Mat& grey, int window, cv::Point2f* corner) {
  const float border = float(window) + 2;
  if (corner->x < border || corner->y < border || corner->x > float(grey.cols) - border ||
      corner->y > float(grey.rows) - border)
    return false;
  std::vector<cv::Point2f> points = {*corner};
  cv::cornerSubPix(grey, points, {window, window}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.003});
  const bool stays = cv::norm(points[0] - *corner) < window;
  *corner = points[0];
  return stays;
}

/// Turns the corners of the markers by the quarter turns that fit a board best: printed AprilTags
/// do not all begin with the same corner.
void alignFirstCorners(const Board& board, FoundMarkers* found) {
  if (found->size() < 2) return;
  double least = std::numeric_limits<double>::infinity();
  FoundMarkers best;
  for (int turn = 0; turn < 4; ++turn) {
    FoundMarkers turned = *found;
    std::vector<size_t> all;
    for (auto& [marker, corners] : turned) {
      std::rotate(corners.begin(), corners.begin() + turn, corners.end());
      all.push_back(marker);
    }
    const cv::Mat H = homographyOf(board, turned, all);
    if (H.empty()) continue;
    double error = 0;
    for (const size_t marker : all)
      for (int i = 0; i < 4; ++i) {
        const cv::Point2f place = placesOf(board, marker)[i];
        error += cv::norm(mapped(H, {place.x, place.y}) - turned[marker][i]);
      }
    if (error < least) {
      least = error;
      best = turned;
    }
  }
  if (!best.empty()) *found = best;
}

/// \param smallest perimeter of a marker, pixels
FoundMarkers markersIn(const Board& board, const cv::Ptr<cv::aruco::Dictionary>& dictionary,
                       const cv::Mat& grey, double smallest) {
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->markerBorderBits = board.options().border_bits;
  parameters->minMarkerPerimeterRate = smallest / std::max(grey.cols, grey.rows);
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> numbers;
  cv::aruco::detectMarkers(grey, dictionary, corners, numbers, parameters);
  FoundMarkers found;
  for (size_t i = 0; i < numbers.size(); ++i) {
    const int index = numbers[i] - board.options().first_marker;
    if (index >= 0 && index < int(board.markers().size())) found[index] = corners[i];
  }
  if (board.options().kind == "markers") alignFirstCorners(board, &found);
  return found;
}

constexpr float kMoved = 0.35f;       // of the board's size, from one image to the next
constexpr double kMostOfImage = 0.6;  // that is searched first

cv::Rect2f boxOf(const std::vector<cv::Point2f>& pixels) {
  cv::Point2f low = pixels.front(), high = low;
  for (const cv::Point2f& pixel : pixels) {
    low = {std::min(low.x, pixel.x), std::min(low.y, pixel.y)};
    high = {std::max(high.x, pixel.x), std::max(high.y, pixel.y)};
  }
  return {low, high};
}

cv::Rect2f boxOf(const BoardCorners& corners) {
  std::vector<cv::Point2f> pixels;
  for (const Eigen::Vector2d& pixel : corners.pixels)
    pixels.emplace_back(float(pixel.x()), float(pixel.y()));
  return boxOf(pixels);
}

/// Where all markers of the board must be if some are found, pixels; none if too few are.
std::optional<cv::Rect2f> placeOfBoard(const Board& board, const FoundMarkers& found) {
  constexpr size_t kFew = 4;
  if (found.size() < kFew) return std::nullopt;
  std::vector<size_t> markers;
  for (const auto& [marker, corners] : found) markers.push_back(marker);
  const cv::Mat homography = homographyOf(board, found, markers);
  if (homography.empty()) return std::nullopt;
  const cv::Matx33d H = homography;
  std::vector<cv::Point2f> pixels;
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (size_t marker = 0; marker < board.markers().size(); ++marker)
    for (const cv::Point2f& place : placesOf(board, marker)) {
      const double depth = (H * cv::Vec3d(place.x, place.y, 1))[2];
      least = std::min(least, depth);
      most = std::max(most, depth);
      pixels.push_back(mapped(homography, {place.x, place.y}));
    }
  if (least * most <= 0) return std::nullopt;  // part of it would be behind the camera
  return boxOf(pixels);
}

/// The place with a share of its size and some pixels around it.
cv::Rect partAround(const cv::Rect2f& place, float share, const cv::Size& image) {
  constexpr float kPixels = 16;  // more than the windows of the detector
  const float margin = share * std::max(place.width, place.height) + kPixels;
  const cv::Rect2f all(0, 0, float(image.width), float(image.height));
  return cv::Rect(cv::Rect2f(place.x - margin, place.y - margin, place.width + 2 * margin,
                             place.height + 2 * margin) &
                  all);
}

/// Whether what was found there leaves no marker outside.
bool holdsBoard(const Board& board, const FoundMarkers& found, const cv::Rect& part,
                const cv::Size& image) {
  constexpr float kAround = 0.05f;
  const auto place = placeOfBoard(board, found);
  return place && (partAround(*place, kAround, image) & part) == partAround(*place, kAround, image);
}

}  // namespace

FoundMarkers findMarkers(const Board& board, const cv::Ptr<cv::aruco::Dictionary>& dictionary,
                         const cv::Mat& grey, const BoardCorners* before) {
  const double smallest = 0.02 * std::max(grey.cols, grey.rows);
  if (before && !before->pixels.empty()) {
    const cv::Rect part = partAround(boxOf(*before), kMoved, grey.size());
    if (part.area() > 0 && part.area() < kMostOfImage * double(grey.total())) {
      FoundMarkers found = markersIn(board, dictionary, grey(part), smallest);
      for (auto& [marker, corners] : found)
        for (cv::Point2f& corner : corners) corner += cv::Point2f(part.tl());
      if (holdsBoard(board, found, part, grey.size())) return found;
    }
  }
  return markersIn(board, dictionary, grey, smallest);
}

BoardCorners cornersBetweenMarkers(const Board& board, const FoundMarkers& markers,
                                   const cv::Mat& grey) {
  BoardCorners out;
  for (size_t id = 0; id < board.corners().size(); ++id) {
    const Eigen::Vector2d& place = board.corners()[id];
    const std::vector<size_t> near = markersNear(board, markers, place);
    if (near.empty()) continue;
    const cv::Mat H = homographyOf(board, markers, near);
    if (H.empty()) continue;
    cv::Point2f corner = mapped(H, place);
    if (!refine(grey, windowAround(corner, markers.at(near[0])), &corner)) continue;
    out.ids.push_back(int(id));
    out.pixels.emplace_back(corner.x, corner.y);
  }
  return out;
}

BoardCorners refinedMarkerCorners(const FoundMarkers& markers, const cv::Mat& grey) {
  const double cells = 8;  // a marker has about so many, and a window must not reach the next one
  BoardCorners out;
  for (const auto& [marker, corners] : markers)
    for (int i = 0; i < 4; ++i) {
      const double side = cv::norm(corners[i] - corners[(i + 1) % 4]);
      cv::Point2f corner = corners[i];
      if (!refine(grey, std::clamp(int(side / cells), 2, 8), &corner)) continue;
      out.ids.push_back(int(4 * marker) + i);
      out.pixels.emplace_back(corner.x, corner.y);
    }
  return out;
}

}  // namespace markerless_mocap
