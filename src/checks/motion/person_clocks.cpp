#include "checks/motion/person_clocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "checks/motion/refined_clocks.h"
#include "checks/motion/sight_grid.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr double kStep = 0.15;  // s
constexpr int kFewMarks = 40;
constexpr int kMoments = 160;
// m. Of somebody who stays on the spot only the hands tell the time, and much fits them.
constexpr double kLeastWalk = 0.75;

/// Losses against shifts.
struct Curve {
  std::vector<double> mean;  ///< 1 where there are too few marks
  std::vector<int> count;

  void add(const GridLoss& loss) {
    const bool enough = loss.count >= kFewMarks;
    mean.push_back(enough ? loss.sum / loss.count : 1.0);
    count.push_back(enough ? loss.count : 0);
  }
  double usual() const {
    std::vector<double> known;
    for (size_t i = 0; i < mean.size(); ++i)
      if (count[i] > 0) known.push_back(mean[i]);
    return known.empty() ? 1.0 : nearestQuantile(known, 0.5);
  }
  /// What speaks for each shift: how much less is lost than usually, in standard deviations but for
  /// a factor.
  std::vector<double> evidence() const {
    const double all = usual();
    std::vector<double> out;
    for (size_t i = 0; i < mean.size(); ++i)
      out.push_back(std::max(0.0, all - mean[i]) * std::sqrt(double(count[i])));
    return out;
  }
};

size_t greatest(const std::vector<double>& values) {
  return size_t(std::max_element(values.begin(), values.end()) - values.begin());
}

/// Two cameras that meet a third one's points, or one that meets the rays of another.
struct Trial {
  std::vector<size_t> cameras;
  std::vector<int> shifts;
  double evidence = 0.0, certainty = 0.0;
};

class PersonClocks {
 public:
  PersonClocks(const std::vector<PersonTrack>& tracks, const RigModel& model, double largest)
      : tracks_(tracks), model_(model), reach_(int(std::ceil(largest / kStep))) {
    for (const CameraModel& camera : model)
      grids_.push_back(sightGridOf(tracks[camera.source], camera, kStep));
    std::vector<double> marks;
    for (const SightGrid& grid : grids_) marks.push_back(grid.marks);
    root_ = greatest(marks);
    shifts_.assign(model.size(), 0);
    known_.assign(model.size(), false);
    known_[root_] = true;
  }

  FilmClocks run() {
    FilmClocks clocks;
    clocks.offsets.assign(model_.size(), NAN);
    clocks.certainty.assign(model_.size(), 0.0);
    const Trial start = model_.size() == 2 ? bestPair() : bestTriple();
    for (size_t k = 0; k < start.cameras.size(); ++k) {
      shifts_[start.cameras[k]] = start.shifts[k];
      known_[start.cameras[k]] = true;
    }
    if (model_.size() > 2)
      while (addCamera()) {
      }
    for (size_t i = 0; i < model_.size(); ++i)
      if (known_[i] && start.evidence > 0) {
        clocks.offsets[i] = offsetOf(i, shifts_[i]);
        clocks.certainty[i] = model_.size() == 2 ? start.certainty : certaintyOf(i);
        if (model_.size() == 3)
          clocks.certainty[i] = std::min(clocks.certainty[i], start.certainty);
      }
    clocks.for_none = forNone();
    const RigSight sight = this->sight();
    refineOffsets(sight, model_, root_, kStep, &clocks.offsets);
    if (walkedAt(sight, model_, clocks.offsets) < kLeastWalk)
      clocks.certainty.assign(model_.size(), 0.0);
    return clocks;
  }

 private:
  // A shift is added to the index of a camera's grid to get that of the root's.
  double offsetOf(size_t i, int shift) const {
    return shift * kStep - grids_[i].first + grids_[root_].first;
  }
  int shiftOf(size_t i, double offset) const {
    return int(std::lround((offset + grids_[i].first - grids_[root_].first) / kStep));
  }
  int lowest(size_t i) const { return std::max(shiftOf(i, 0) - reach_, 1 - grids_[i].size()); }
  int highest(size_t i) const { return std::min(shiftOf(i, 0) + reach_, grids_[root_].size() - 1); }
  int everyOfRoot() const { return std::max(1, grids_[root_].marks / kBodyMarks / kMoments); }

  /// The cameras that see most of the person beside the root.
  std::vector<size_t> others() const {
    constexpr size_t kMost = 4;
    std::vector<size_t> list;
    for (size_t i = 0; i < grids_.size(); ++i)
      if (i != root_) list.push_back(i);
    std::stable_sort(list.begin(), list.end(),
                     [&](size_t a, size_t b) { return grids_[a].marks > grids_[b].marks; });
    if (list.size() > kMost) list.resize(kMost);
    return list;
  }

  Trial bestPair() const {
    Trial best;
    const size_t b = others().front();
    Curve curve;
    for (int shift = lowest(b); shift <= highest(b); ++shift) {
      GridLoss loss;
      for (const GridPoint& point : pointsOf(grids_[root_], grids_[b], shift, 0, everyOfRoot())) {
        loss.sum += lossOf(std::isfinite(point.missed) ? std::sqrt(point.missed) : 1e6);
        ++loss.count;
      }
      curve.add(loss);
    }
    const std::vector<double> evidence = curve.evidence();
    if (evidence.empty()) return best;
    const size_t at = greatest(evidence);
    best.cameras = {b};
    best.shifts = {lowest(b) + int(at)};
    best.evidence = evidence[at];
    best.certainty = peakRatio(evidence, at);
    return best;
  }

  Trial bestTriple() const {
    Trial best;
    const std::vector<size_t> list = others();
    for (size_t b = 0; b < list.size(); ++b)
      for (size_t c = b + 1; c < list.size(); ++c) {
        Trial trial = searchTriple(list[b], list[c]);
        if (trial.certainty > best.certainty) best = std::move(trial);
      }
    return best;
  }

  /// Both shifts at once: two cameras at the height of a chest say little of time.
  Trial searchTriple(size_t b, size_t c) const {
    std::vector<Curve> rows;  // of shifts of b
    for (int of_b = lowest(b); of_b <= highest(b); ++of_b) {
      const std::vector<GridPoint> points =
          pointsOf(grids_[root_], grids_[b], of_b, 0, everyOfRoot());
      rows.emplace_back();
      for (int of_c = lowest(c); of_c <= highest(c); ++of_c)
        rows.back().add(lossOf(grids_[c], points, of_c));
    }
    Curve all;
    for (const Curve& row : rows) {
      all.mean.insert(all.mean.end(), row.mean.begin(), row.mean.end());
      all.count.insert(all.count.end(), row.count.begin(), row.count.end());
    }
    if (all.mean.empty()) return {};
    const std::vector<double> evidence = all.evidence();
    const size_t columns = rows.front().mean.size(), at = greatest(evidence);
    const int row = int(at / columns), column = int(at % columns);
    Trial trial{{b, c}, {lowest(b) + row, lowest(c) + column}, evidence[at], 0.0};
    trial.certainty = trial.evidence / rivalOf(evidence, columns, row, column);
    return trial;
  }

  /// Of shifts that both or one of them differ by a second.
  static double rivalOf(const std::vector<double>& evidence, size_t columns, int row, int column) {
    constexpr int kApart = int(1.0 / kStep);
    double rival = 1e-9;
    for (size_t i = 0; i < evidence.size(); ++i)
      if (std::abs(int(i / columns) - row) > kApart || std::abs(int(i % columns) - column) > kApart)
        rival = std::max(rival, evidence[i]);
    return rival;
  }

  /// Points by the known cameras without one, by the root's clock: of all pairs that see a mark, by
  /// the one whose rays cross most steeply; each time counts once, however many see it.
  std::vector<GridPoint> pointsWithout(size_t left_out, const std::vector<int>& shifts) const {
    const int every = everyOfRoot();
    std::map<std::pair<int, int>, GridPoint> best;
    for (size_t a = 0; a < grids_.size(); ++a)
      for (size_t b = a + 1; b < grids_.size(); ++b) {
        if (!known_[a] || !known_[b] || a == left_out || b == left_out) continue;
        const int first = (every - shifts[a] % every) % every;
        for (GridPoint point :
             pointsOf(grids_[a], grids_[b], shifts[b] - shifts[a], first, every)) {
          point.index += shifts[a];
          const auto [known, added] = best.try_emplace({point.mark, point.index}, point);
          if (!added && point.sine2 > known->second.sine2) known->second = point;
        }
      }
    std::vector<GridPoint> all;
    for (const auto& entry : best) all.push_back(entry.second);
    return all;
  }

  Curve curveOf(size_t camera, const std::vector<int>& shifts, int around) const {
    const std::vector<GridPoint> points = pointsWithout(camera, shifts);
    Curve curve;
    for (int shift = around - reach_; shift <= around + reach_; ++shift)
      curve.add(lossOf(grids_[camera], points, shift));
    return curve;
  }

  /// Of all that are not known, the one that is most certain.
  bool addCamera() {
    double most = 0.0;
    size_t best = 0;
    int shift = 0;
    for (size_t i = 0; i < grids_.size(); ++i) {
      if (known_[i]) continue;
      const int around = shiftOf(i, 0);
      const std::vector<double> evidence = curveOf(i, shifts_, around).evidence();
      const size_t at = greatest(evidence);
      const double certainty = peakRatio(evidence, at);
      if (certainty <= most) continue;
      most = certainty;
      best = i;
      shift = around - reach_ + int(at);
    }
    if (most <= 0.0) return false;
    shifts_[best] = shift;
    known_[best] = true;
    return true;
  }

  double certaintyOf(size_t camera) const {
    const std::vector<double> evidence = curveOf(camera, shifts_, shifts_[camera]).evidence();
    return peakRatio(evidence, size_t(reach_));
  }

  /// What speaks for no offset, as a part of what speaks for those found.
  double forNone() const {
    std::vector<int> none;
    for (size_t i = 0; i < grids_.size(); ++i) none.push_back(shiftOf(i, 0));
    double found = 1e-9, without = 0.0;
    for (size_t i = 0; i < grids_.size(); ++i) {
      if (!known_[i]) continue;
      found += curveOf(i, shifts_, shifts_[i]).evidence()[size_t(reach_)];
      without += curveOf(i, none, none[i]).evidence()[size_t(reach_)];
    }
    return without / found;
  }

  /// Moments of the root's film at which all cameras are looked at.
  RigSight sight() const {
    constexpr int kMostMoments = 900;
    RigSight sight;
    sight.tracks = tracks_;
    const SightGrid& root = grids_[root_];
    const double length = root.size() * kStep;
    const int moments = std::min(kMostMoments, int(length / tracks_[model_[root_].source].period));
    for (int i = 0; i < moments; ++i)
      sight.moments.push_back(root.first + (i + 0.5) * length / moments);
    return sight;
  }

  const std::vector<PersonTrack>& tracks_;
  const RigModel& model_;
  int reach_;  ///< steps
  std::vector<SightGrid> grids_;
  size_t root_ = 0;
  std::vector<int> shifts_;
  std::vector<bool> known_;
};

}  // namespace

FilmClocks searchPersonClocks(const std::vector<PersonTrack>& tracks, const RigModel& model,
                              double largest) {
  return PersonClocks(tracks, model, largest).run();
}

}  // namespace markerless_mocap
