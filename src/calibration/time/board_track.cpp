#include "calibration/time/board_track.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "calibration/time/instants.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr size_t kLeastViews = 8;
constexpr int kLeastSteps = 4;
constexpr double kFloor = 0.005;  // m, to which poses of a board are not known better

BoardPlace placeOf(const Board& board, const Eigen::Isometry3d& camera_board) {
  const double lever = board.size().norm() / 2;
  const Eigen::Vector3d centre(board.centre().x(), board.centre().y(), 0);
  BoardPlace place(3, board.looksSameTurned() ? 2 : 3);
  place.col(0) = camera_board * centre;
  place.col(1) = camera_board * (centre + lever * Eigen::Vector3d::UnitZ());
  if (place.cols() > 2) place.col(2) = camera_board * (centre + lever * Eigen::Vector3d::UnitX());
  return place;
}

/// Places of both tracks at the same times, those of each view side by side.
struct CommonPlaces {
  BoardPlace a, b;
  Eigen::Index points = 0;  // of each view
  size_t views = 0;
  int steps = 0;
};

CommonPlaces commonPlaces(const BoardTrack& a, const BoardTrack& b, double shift) {
  CommonPlaces common;
  if (a.places.empty() || b.places.empty()) return common;
  common.points = a.places.front().cols();
  common.a.resize(3, common.points * Eigen::Index(a.times.size()));
  common.b.resize(3, common.a.cols());
  std::set<long> steps;
  for (size_t i = 0; i < a.times.size(); ++i) {
    const auto place = b.at(a.times[i] - shift);
    if (!place) continue;
    const Eigen::Index first = common.points * Eigen::Index(common.views++);
    common.a.middleCols(first, common.points) = a.places[i];
    common.b.middleCols(first, common.points) = *place;
    steps.insert(std::lround(a.times[i] / kFitStep));
  }
  common.steps = int(steps.size());
  return common;
}

BoardPlace ofViews(const BoardPlace& all, Eigen::Index points, const std::vector<size_t>& views) {
  BoardPlace chosen(3, points * Eigen::Index(views.size()));
  for (size_t k = 0; k < views.size(); ++k)
    chosen.middleCols(points * Eigen::Index(k), points) =
        all.middleCols(points * Eigen::Index(views[k]), points);
  return chosen;
}

std::vector<double> distances(const BoardPlace& a, const BoardPlace& b,
                              const CommonPlaces& common) {
  const Eigen::RowVectorXd apart = (a - b).colwise().norm();
  std::vector<double> means;
  for (size_t k = 0; k < common.views; ++k)
    means.push_back(apart.segment(common.points * Eigen::Index(k), common.points).mean());
  return means;
}

/// After the rigid motion that joins both ways best, of most views.
double medianAfterMotion(const CommonPlaces& common) {
  constexpr int kRounds = 3;
  std::vector<size_t> order(common.views);
  std::iota(order.begin(), order.end(), 0);
  std::vector<size_t> nearer = order;
  std::vector<double> left;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Matrix4d T = Eigen::umeyama(ofViews(common.b, common.points, nearer),
                                             ofViews(common.a, common.points, nearer), false);
    const BoardPlace moved =
        (T.topLeftCorner<3, 3>() * common.b).colwise() + T.topRightCorner<3, 1>();
    left = distances(common.a, moved, common);
    std::sort(order.begin(), order.end(), [&](size_t i, size_t k) { return left[i] < left[k]; });
    nearer.assign(order.begin(), order.begin() + std::ptrdiff_t(common.views * 3 / 4));
  }
  return medianOf(left);
}

/// Of a board that stays where it is on average.
double medianWithoutMotion(const CommonPlaces& common) {
  const Eigen::Index columns = common.points * Eigen::Index(common.views);
  BoardPlace means = BoardPlace::Zero(3, common.points);
  for (Eigen::Index k = 0; k < columns; k += common.points)
    means += common.a.middleCols(k, common.points) / double(common.views);
  return medianOf(distances(common.a, means.replicate(1, Eigen::Index(common.views)), common));
}

}  // namespace

std::optional<BoardPlace> BoardTrack::at(double time) const {
  constexpr double kLongestGap = 2.5;  // intervals
  const auto next = std::lower_bound(times.begin(), times.end(), time);
  if (next == times.begin() || next == times.end()) return std::nullopt;
  const size_t i = size_t(next - times.begin());
  const double gap = times[i] - times[i - 1], part = (time - times[i - 1]) / gap;
  if (gap > kLongestGap * interval) return std::nullopt;
  return BoardPlace((1 - part) * places[i - 1] + part * places[i]);
}

BoardTrack boardTrackOf(const Board& board, size_t camera, const std::vector<BoardView>& views,
                        const std::vector<BoardPose>& poses) {
  std::vector<size_t> film;
  for (size_t i = 0; i < views.size(); ++i)
    if (views[i].camera == camera && !views[i].alone && std::isfinite(poses[i].rms))
      film.push_back(i);
  std::sort(film.begin(), film.end(),
            [&](size_t a, size_t b) { return views[a].time < views[b].time; });
  BoardTrack track;
  track.interval = viewInterval(views, camera);
  for (const size_t i : film) {
    track.times.push_back(views[i].time);
    track.places.push_back(placeOf(board, poses[i].camera_board));
  }
  return track;
}

ShiftFit fitOf(const BoardTrack& a, const BoardTrack& b, double shift) {
  CommonPlaces common = commonPlaces(a, b, shift);
  if (common.views < kLeastViews || common.steps < kLeastSteps) return {};
  const Eigen::Index columns = common.points * Eigen::Index(common.views);
  common.a.conservativeResize(3, columns);
  common.b.conservativeResize(3, columns);
  return {common.steps,
          std::log((medianWithoutMotion(common) + kFloor) / (medianAfterMotion(common) + kFloor))};
}

}  // namespace markerless_mocap
