#include "calibration/time/offset_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "calibration/start/spanning_tree.h"
#include "calibration/time/instants.h"

namespace markerless_mocap {
namespace {

/// The way of the board's centre in the frame of a camera.
struct CentreTrack {
  std::vector<double> times;
  std::vector<Eigen::Vector3d> places;
  double interval = 0.0;

  /// Empty where the board was not seen before and after.
  std::optional<Eigen::Vector3d> at(double time) const {
    const auto next = std::lower_bound(times.begin(), times.end(), time);
    if (next == times.begin() || next == times.end()) return std::nullopt;
    const size_t i = next - times.begin();
    const double gap = times[i] - times[i - 1], part = (time - times[i - 1]) / gap;
    if (gap > 2.5 * interval) return std::nullopt;
    return (1 - part) * places[i - 1] + part * places[i];
  }
};

CentreTrack trackOf(const Board& board, size_t camera, const std::vector<BoardView>& views,
                    const std::vector<BoardPose>& poses) {
  std::vector<size_t> film;
  for (size_t i = 0; i < views.size(); ++i)
    if (views[i].camera == camera && !views[i].alone && std::isfinite(poses[i].rms))
      film.push_back(i);
  std::sort(film.begin(), film.end(),
            [&](size_t a, size_t b) { return views[a].time < views[b].time; });
  CentreTrack track;
  track.interval = viewInterval(views, camera);
  const Eigen::Vector3d centre(board.centre().x(), board.centre().y(), 0);
  for (const size_t i : film) {
    track.times.push_back(views[i].time);
    track.places.push_back(poses[i].camera_board * centre);
  }
  return track;
}

using Places = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// How well a shift fits: distances between both tracks that are left after a rigid motion.
struct ShiftFit {
  double median = std::numeric_limits<double>::infinity();  ///< m
  int pairs = 0;
};

double medianDistance(const Places& a, const Places& b, std::vector<int>* nearer_half) {
  const Eigen::Matrix4d T = Eigen::umeyama(Places(b(Eigen::all, *nearer_half)),
                                           Places(a(Eigen::all, *nearer_half)), false);
  const Places moved = (T.topLeftCorner<3, 3>() * b).colwise() + T.topRightCorner<3, 1>();
  const Eigen::RowVectorXd left = (a - moved).colwise().norm();
  std::vector<int> order(left.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = int(i);
  std::sort(order.begin(), order.end(), [&](int i, int k) { return left[i] < left[k]; });
  nearer_half->assign(order.begin(), order.begin() + std::max<size_t>(order.size() * 3 / 4, 4));
  return left[order[order.size() / 2]];
}

/// \param shift s, added to the clock of b
ShiftFit fitOf(const CentreTrack& a, const CentreTrack& b, double shift) {
  constexpr int kLeast = 8;
  Places in_a(3, a.times.size()), in_b(3, a.times.size());
  int pairs = 0;
  for (size_t i = 0; i < a.times.size(); ++i)
    if (const auto place = b.at(a.times[i] - shift)) {
      in_a.col(pairs) = a.places[i];
      in_b.col(pairs++) = *place;
    }
  if (pairs < kLeast) return {};
  in_a.conservativeResize(3, pairs);
  in_b.conservativeResize(3, pairs);
  std::vector<int> taken(pairs);
  for (int i = 0; i < pairs; ++i) taken[i] = i;
  ShiftFit fit;
  for (int round = 0; round < 3; ++round) fit.median = medianDistance(in_a, in_b, &taken);
  fit.pairs = pairs;
  return fit;
}

struct BestShift {
  double shift = NAN;
  ShiftFit fit;
};

/// Shifts with few pairs fit by chance, so only those with at least half of the most count.
BestShift bestShift(const CentreTrack& a, const CentreTrack& b, double around, double reach,
                    double step) {
  std::vector<BestShift> tried;
  int most = 0;
  for (double shift = around - reach; shift <= around + reach; shift += step) {
    tried.push_back({shift, fitOf(a, b, shift)});
    most = std::max(most, tried.back().fit.pairs);
  }
  BestShift best;
  for (const BestShift& one : tried)
    if (2 * one.fit.pairs >= most && one.fit.median < best.fit.median) best = one;
  return best;
}

}  // namespace

std::vector<double> searchOffsets(const Board& board, size_t cameras,
                                  const std::vector<BoardView>& views,
                                  const std::vector<BoardPose>& poses, double largest) {
  std::vector<CentreTrack> tracks;
  for (size_t camera = 0; camera < cameras; ++camera)
    tracks.push_back(trackOf(board, camera, views, poses));
  std::vector<Link> links;
  std::vector<double> shifts;
  for (size_t a = 0; a < cameras; ++a)
    for (size_t b = a + 1; b < cameras; ++b) {
      const double step = std::max(tracks[a].interval, tracks[b].interval) / 4;
      if (!(step > 0)) continue;
      BestShift best = bestShift(tracks[a], tracks[b], 0.0, largest, step);
      if (!std::isfinite(best.shift)) continue;
      best = bestShift(tracks[a], tracks[b], best.shift, step, step / 8);
      links.push_back({a, b, best.fit.pairs / (best.fit.median + 1e-3)});
      shifts.push_back(best.shift);
    }
  const std::vector<size_t> groups(cameras, 0);
  const size_t root = strongestNode(links, groups, 0);
  std::vector<double> offsets(cameras, NAN);
  offsets[root] = 0.0;
  for (const TreeStep& step : spanningTree(cameras, links, root)) {
    const bool forward = links[step.link].a == step.parent;
    offsets[step.child] = offsets[step.parent] + (forward ? 1 : -1) * shifts[step.link];
  }
  return offsets;
}

}  // namespace markerless_mocap
