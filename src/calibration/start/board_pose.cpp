#include "calibration/start/board_pose.h"

#include <cmath>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "calibration/adjust/residuals.h"
#include "calibration/start/seen_ahead.h"

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

struct Points {
  std::vector<cv::Point3d> places;  ///< m, on the board
  std::vector<cv::Point2d> pixels;
};

Points pointsOf(const Board& board, const BoardCorners& corners) {
  Points points;
  for (size_t i = 0; i < corners.ids.size(); ++i) {
    const Eigen::Vector2d& place = board.corners()[corners.ids[i]];
    points.places.emplace_back(place.x(), place.y(), 0);
    points.pixels.emplace_back(corners.pixels[i].x(), corners.pixels[i].y());
  }
  return points;
}

using PoseError = std::function<double(const Eigen::Isometry3d&)>;  // pixels

double rmsOf(const Points& points, LensType lens, const Intrinsics& in,
             const Eigen::Isometry3d& camera_board) {
  double sum = 0;
  for (size_t i = 0; i < points.pixels.size(); ++i) {
    const cv::Point3d& place = points.places[i];
    const Eigen::Vector3d p = camera_board * Eigen::Vector3d(place.x, place.y, place.z);
    if (!maySee(lens, p.data())) return INFINITY;
    double pixel[2];
    projectPoint(lens, in.data(), p.data(), pixel);
    const double dx = pixel[0] - points.pixels[i].x, dy = pixel[1] - points.pixels[i].y;
    sum += dx * dx + dy * dy;
  }
  return std::sqrt(sum / double(points.pixels.size()));
}

/// The better of the poses that a pinhole camera gives; `turn` takes its frame to the camera's.
BoardPose bestPose(const Points& seen, const cv::Matx33d& K, const cv::Mat& D,
                   const Eigen::Matrix3d& turn, const PoseError& error) {
  std::vector<cv::Mat> rotations, translations;
  cv::solvePnPGeneric(seen.places, seen.pixels, K, D, rotations, translations, false,
                      cv::SOLVEPNP_IPPE);
  BoardPose best;
  best.rms = INFINITY;
  for (size_t i = 0; i < rotations.size(); ++i) {
    if (!cv::checkRange(rotations[i]) || !cv::checkRange(translations[i])) continue;
    cv::solvePnPRefineLM(seen.places, seen.pixels, K, D, rotations[i], translations[i]);
    if (!(translations[i].at<double>(2) > 0)) continue;
    const Eigen::Isometry3d pose = turn * isometryOf(rotations[i], translations[i]);
    const double rms = error(pose);
    if (rms < best.rms) best = {pose, rms};
  }
  return best;
}

/// A pinhole camera that looks at the board sees its corners without distortion.
BoardPose fisheyePose(const Points& points, const Intrinsics& in, const PoseError& error) {
  const AheadView ahead = seenAhead(in, points.pixels);
  if (ahead.seen.size() < points.pixels.size()) return {Eigen::Isometry3d::Identity(), INFINITY};
  return bestPose({points.places, ahead.pixels}, cv::Matx33d::eye(), cv::Mat(), ahead.turn, error);
}

}  // namespace

BoardPose boardPose(const Board& board, const BoardCorners& corners, const Intrinsics& in,
                    LensModel lens) {
  const Points points = pointsOf(board, corners);
  const auto error = [&](const Eigen::Isometry3d& pose) {
    return rmsOf(points, typeOf(lens), in, pose);
  };
  if (lens == LensModel::kFisheye) return fisheyePose(points, in, error);
  const cv::Matx33d K(in[0], 0, in[2], 0, in[1], in[3], 0, 0, 1);
  const cv::Mat D(1, 8, CV_64F, const_cast<double*>(in.data() + 4));
  return bestPose(points, K, D, Eigen::Matrix3d::Identity(), error);
}

}  // namespace markerless_mocap
