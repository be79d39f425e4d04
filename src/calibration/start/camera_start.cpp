#include "calibration/start/camera_start.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "calibration/start/board_pose.h"

namespace markerless_mocap {
namespace {

/// Where and how the board appears: the affine map from the board to the image, in board sizes.
using Appearance = Eigen::Matrix<double, 6, 1>;

Appearance appearanceOf(const Board& board, const BoardCorners& corners) {
  const double size = board.size().maxCoeff();
  Eigen::Matrix<double, Eigen::Dynamic, 3> places(corners.ids.size(), 3);
  Eigen::Matrix<double, Eigen::Dynamic, 2> pixels(corners.ids.size(), 2);
  for (size_t i = 0; i < corners.ids.size(); ++i) {
    const Eigen::Vector2d place = (board.corners()[corners.ids[i]] - board.centre()) / size;
    places.row(i) << place.x(), place.y(), 1;
    pixels.row(i) = corners.pixels[i].transpose();
  }
  const Eigen::Matrix<double, 3, 2> affine =
      (places.transpose() * places).ldlt().solve(places.transpose() * pixels);
  return Eigen::Map<const Appearance>(affine.data());
}

void addView(const Board& board, const BoardCorners& corners,
             std::vector<std::vector<cv::Point3f>>* places,
             std::vector<std::vector<cv::Point2f>>* pixels) {
  places->emplace_back();
  pixels->emplace_back();
  for (size_t i = 0; i < corners.ids.size(); ++i) {
    const Eigen::Vector2d& place = board.corners()[corners.ids[i]];
    places->back().emplace_back(float(place.x()), float(place.y()), 0.0f);
    pixels->back().emplace_back(float(corners.pixels[i].x()), float(corners.pixels[i].y()));
  }
}

}  // namespace

std::vector<size_t> differentViews(const Board& board, const std::vector<const BoardView*>& views,
                                   size_t count) {
  if (views.empty()) return {};
  std::vector<Appearance> appearances;
  for (const BoardView* view : views) appearances.push_back(appearanceOf(board, view->corners));
  std::vector<double> distance(views.size(), std::numeric_limits<double>::infinity());
  std::vector<size_t> chosen;
  size_t next = 0;
  for (size_t i = 1; i < views.size(); ++i)
    if (views[i]->corners.ids.size() > views[next]->corners.ids.size()) next = i;
  while (chosen.size() < std::min(count, views.size())) {
    chosen.push_back(next);
    for (size_t i = 0; i < views.size(); ++i)
      distance[i] = std::min(distance[i], (appearances[i] - appearances[next]).norm());
    distance[next] = -1;
    next = size_t(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return chosen;
}

Intrinsics startIntrinsics(const Board& board, const CameraToCalibrate& camera,
                           const std::vector<const BoardView*>& views) {
  constexpr size_t kViews = 25;
  std::vector<std::vector<cv::Point3f>> places;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const size_t i : differentViews(board, views, kViews))
    addView(board, views[i]->corners, &places, &pixels);
  cv::Mat K, D;
  std::vector<cv::Mat> rotations, translations;
  cv::calibrateCamera(places, pixels, {camera.width, camera.height}, K, D, rotations, translations,
                      cv::CALIB_FIX_K3 | cv::CALIB_ZERO_TANGENT_DIST);
  return {K.at<double>(0, 0), K.at<double>(1, 1), K.at<double>(0, 2),
          K.at<double>(1, 2), D.at<double>(0),    D.at<double>(1)};
}

Intrinsics startFisheye(const Board& board, const CameraToCalibrate& camera,
                        const std::vector<const BoardView*>& views) {
  constexpr size_t kViews = 25;
  constexpr double kWidest = 3.8, kNarrowest = 1.0, kStep = 0.92;  // rad, across the image
  const std::vector<size_t> different = differentViews(board, views, kViews);
  Intrinsics best{};
  double least = std::numeric_limits<double>::infinity();
  for (double angle = kWidest; angle > kNarrowest; angle *= kStep) {
    const double focal = camera.width / angle;
    const Intrinsics in{focal, focal, (camera.width - 1) / 2.0, (camera.height - 1) / 2.0};
    double sum = 0;
    for (const size_t i : different)
      sum += std::min(boardPose(board, views[i]->corners, in, LensModel::kFisheye).rms,
                      double(camera.width));
    if (!(sum < least)) continue;
    least = sum;
    best = in;
  }
  return best;
}

}  // namespace markerless_mocap
