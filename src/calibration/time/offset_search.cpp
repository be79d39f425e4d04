#include "calibration/time/offset_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/start/spanning_tree.h"
#include "calibration/time/board_track.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

/// What speaks for each shift between two cameras: shift = (index - middle) * step.
struct PairCurve {
  size_t a = 0, b = 0;  ///< the shift is added to the clock of b
  double usual = 0.0;   ///< gain of most shifts: a rigid motion always fits somewhat
  std::vector<double> evidence;

  double evidenceOf(const ShiftFit& fit) const {
    constexpr int kAlwaysFit = 3;  // steps: so short a way is about an arc
    return std::max(0, fit.steps - kAlwaysFit) * std::max(0.0, fit.gain - usual);
  }
};

class OffsetSearch {
 public:
  OffsetSearch(std::vector<BoardTrack> tracks, double largest) : tracks_(std::move(tracks)) {
    double interval = 0.0, length = 0.0;
    for (const BoardTrack& track : tracks_) {
      interval = std::max(interval, track.interval);
      if (!track.times.empty()) length = std::max(length, track.times.back() - track.times.front());
    }
    step_ = std::clamp(interval / 4, 0.02, std::max(0.05, interval / 8));
    reach_ = int(std::ceil(std::min(largest, length) / step_));
    middle_ = int(std::ceil(std::min(2 * largest, length) / step_));
    for (size_t a = 0; a < tracks_.size(); ++a)
      for (size_t b = a + 1; b < tracks_.size(); ++b) curves_.push_back({a, b, 0.0, {}});
    tbb::parallel_for(size_t(0), curves_.size(), [&](size_t i) { fill(&curves_[i]); });
  }

  FilmClocks run() {
    FilmClocks clocks;
    clocks.offsets.assign(tracks_.size(), NAN);
    clocks.certainty.assign(tracks_.size(), 0.0);
    const std::vector<Link> links = linksOf();
    const size_t root = strongestNode(links, std::vector<size_t>(tracks_.size(), 0), 0);
    const std::vector<TreeStep> tree = spanningTree(tracks_.size(), links, root);
    clocks.offsets[root] = 0.0;
    clocks.certainty[root] = std::numeric_limits<double>::infinity();
    for (const TreeStep& step : tree)
      clocks.offsets[step.child] = clocks.offsets[step.parent] + shiftOf(step);
    for (const TreeStep& step : tree) judge(tree, step, &clocks);
    clocks.for_none =
        sumOf(std::vector<double>(tracks_.size(), 0.0)) / std::max(sumOf(clocks.offsets), 1e-9);
    return clocks;
  }

 private:
  double shiftAt(int index) const { return (index - middle_) * step_; }

  void fill(PairCurve* curve) const {
    std::vector<ShiftFit> fits;
    std::vector<double> gains;
    for (int i = 0; i <= 2 * middle_; ++i) {
      fits.push_back(fitOf(tracks_[curve->a], tracks_[curve->b], shiftAt(i)));
      if (fits.back().steps > 0) gains.push_back(fits.back().gain);
    }
    if (!gains.empty()) curve->usual = medianOf(gains);
    for (const ShiftFit& fit : fits) curve->evidence.push_back(curve->evidenceOf(fit));
  }

  int bestOf(const std::vector<double>& values) const {
    const auto from = values.begin() + middle_ - reach_, to = values.begin() + middle_ + reach_ + 1;
    return int(std::max_element(from, to) - values.begin());
  }

  std::vector<Link> linksOf() const {
    std::vector<Link> links;
    for (const PairCurve& curve : curves_)
      if (const double most = curve.evidence[bestOf(curve.evidence)]; most > 0)
        links.push_back({curve.a, curve.b, most});
    return links;
  }

  const PairCurve& curveOf(size_t a, size_t b) const {
    return *std::find_if(curves_.begin(), curves_.end(), [&](const PairCurve& curve) {
      return curve.a == std::min(a, b) && curve.b == std::max(a, b);
    });
  }

  /// Of the child's clock against that of its parent, to a part of a step.
  double shiftOf(const TreeStep& step) const {
    constexpr int kParts = 8;
    const PairCurve& curve = curveOf(step.parent, step.child);
    const double coarse = shiftAt(bestOf(curve.evidence));
    double best = coarse, most = 0.0;
    for (int i = -kParts; i <= kParts; ++i) {
      const double shift = coarse + i * step_ / kParts;
      const double found = curve.evidenceOf(fitOf(tracks_[curve.a], tracks_[curve.b], shift));
      if (found <= most) continue;
      most = found;
      best = shift;
    }
    return curve.b == step.child ? best : -best;
  }

  /// 0 beyond what was searched.
  double evidenceAt(const PairCurve& curve, double shift) const {
    const int i = middle_ + int(std::lround(shift / step_));
    return i < 0 || i > 2 * middle_ ? 0.0 : curve.evidence[size_t(i)];
  }

  double sumOf(const std::vector<double>& offsets) const {
    double sum = 0;
    for (const PairCurve& curve : curves_)
      if (const double shift = offsets[curve.b] - offsets[curve.a]; std::isfinite(shift))
        sum += evidenceAt(curve, shift);
    return sum;
  }

  /// The child and all that hangs on it are moved against the rest: nothing else may fit as well.
  void judge(const std::vector<TreeStep>& tree, const TreeStep& step, FilmClocks* clocks) const {
    std::vector<bool> moved(tracks_.size(), false);
    moved[step.child] = true;
    for (const TreeStep& later : tree)
      if (moved[later.parent]) moved[later.child] = true;
    std::vector<double> sums(size_t(2 * reach_ + 1), 0.0);
    for (const PairCurve& curve : curves_) {
      if (moved[curve.a] == moved[curve.b]) continue;
      const double now = clocks->offsets[curve.b] - clocks->offsets[curve.a];
      if (!std::isfinite(now)) continue;
      for (int i = -reach_; i <= reach_; ++i)
        sums[size_t(i + reach_)] += evidenceAt(curve, now + (moved[curve.b] ? i : -i) * step_);
    }
    const double own = clocks->certainty[step.parent];
    clocks->certainty[step.child] = std::min(own, peakRatio(sums, size_t(reach_)));
  }

  std::vector<BoardTrack> tracks_;
  double step_ = 0.0;  ///< s
  int reach_ = 0;      ///< steps between two films that are joined
  int middle_ = 0;     ///< steps between two films that a third one joins
  std::vector<PairCurve> curves_;
};

}  // namespace

FilmClocks searchOffsets(const Board& board, size_t cameras, const std::vector<BoardView>& views,
                         const std::vector<BoardPose>& poses, double largest) {
  std::vector<BoardTrack> tracks;
  for (size_t camera = 0; camera < cameras; ++camera)
    tracks.push_back(boardTrackOf(board, camera, views, poses));
  return OffsetSearch(std::move(tracks), largest).run();
}

}  // namespace markerless_mocap
