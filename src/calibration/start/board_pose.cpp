#include "calibration/start/board_pose.h"

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

namespace markerless_mocap {
namespace {

Eigen::Isometry3d isometryOf(const cv::Mat& rotation_vector, const cv::Mat& translation) {
  cv::Matx33d R;
  cv::Rodrigues(rotation_vector, R);
  Eigen::Matrix3d rotation;
  cv::cv2eigen(R, rotation);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotation;
  for (int i = 0; i < 3; ++i) T.translation()[i] = translation.at<double>(i);
  return T;
}

double rmsOf(const std::vector<cv::Point3d>& places, const std::vector<cv::Point2d>& pixels,
             const cv::Matx33d& K, const cv::Mat& D, const cv::Mat& r, const cv::Mat& t) {
  std::vector<cv::Point2d> projected;
  cv::projectPoints(places, r, t, K, D, projected);
  double sum = 0;
  for (size_t i = 0; i < pixels.size(); ++i) {
    const cv::Point2d d = projected[i] - pixels[i];
    sum += d.dot(d);
  }
  return std::sqrt(sum / double(pixels.size()));
}

}  // namespace

BoardPose boardPose(const Board& board, const BoardCorners& corners, const Intrinsics& in) {
  const cv::Matx33d K(in[0], 0, in[2], 0, in[1], in[3], 0, 0, 1);
  const cv::Mat D(1, 8, CV_64F, const_cast<double*>(in.data() + 4));
  std::vector<cv::Point3d> places;
  std::vector<cv::Point2d> pixels;
  for (size_t i = 0; i < corners.ids.size(); ++i) {
    const Eigen::Vector2d& place = board.corners()[corners.ids[i]];
    places.emplace_back(place.x(), place.y(), 0);
    pixels.emplace_back(corners.pixels[i].x(), corners.pixels[i].y());
  }
  std::vector<cv::Mat> rotations, translations;
  cv::solvePnPGeneric(places, pixels, K, D, rotations, translations, false, cv::SOLVEPNP_IPPE);
  BoardPose best;
  best.rms = INFINITY;
  for (size_t i = 0; i < rotations.size(); ++i) {
    if (!cv::checkRange(rotations[i]) || !cv::checkRange(translations[i])) continue;
    cv::solvePnPRefineLM(places, pixels, K, D, rotations[i], translations[i]);
    const double rms = rmsOf(places, pixels, K, D, rotations[i], translations[i]);
    if (translations[i].at<double>(2) > 0 && rms < best.rms)
      best = {isometryOf(rotations[i], translations[i]), rms};
  }
  return best;
}

}  // namespace markerless_mocap
