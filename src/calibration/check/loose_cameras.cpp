#include "calibration/check/loose_cameras.h"

#include <algorithm>
#include <cmath>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

/// How the corners of one view lie from where they should be.
struct Shift {
  double time;
  Eigen::Vector2d pixels;
};

template <class Iterator>
Eigen::Vector2d medianShift(Iterator begin, Iterator end) {
  std::vector<double> x, y;
  for (auto it = begin; it != end; ++it) {
    x.push_back(it->pixels.x());
    y.push_back(it->pixels.y());
  }
  return {medianOf(x), medianOf(y)};
}

template <class Iterator>
void addDistances(Iterator begin, Iterator end, std::vector<double>* distances) {
  const Eigen::Vector2d middle = medianShift(begin, end);
  for (auto it = begin; it != end; ++it) distances->push_back((it->pixels - middle).norm());
}

/// Median over the corners of each view that other cameras saw as well, by time.
std::vector<Shift> shiftsOf(const Board& board, const RigState& state, size_t camera) {
  std::vector<Shift> shifts;
  for (const Instant& instant : state.instants) {
    const auto used = std::count_if(instant.views.begin(), instant.views.end(),
                                    [](const ViewSight& view) { return view.used; });
    if (!instant.located || used < 2) continue;
    for (const ViewSight& view : instant.views) {
      if (view.camera != camera || !view.used) continue;
      std::vector<Shift> corners;
      for (const CornerSight& corner : view.corners) {
        const Eigen::Vector2d r = residualOf(state, board, instant, view, corner);
        if (r.allFinite()) corners.push_back({instant.time, r});
      }
      if (!corners.empty())
        shifts.push_back({instant.time, medianShift(corners.begin(), corners.end())});
    }
  }
  std::sort(shifts.begin(), shifts.end(),
            [](const Shift& a, const Shift& b) { return a.time < b.time; });
  return shifts;
}

/// The split at which the shifts before and after differ most, in units of their scatter.
std::optional<LooseCamera> jumpOf(const std::vector<Shift>& shifts, double* clearness) {
  constexpr int kLeast = 5;
  constexpr double kLeastPixels = 1.0, kClear = 3.0;
  std::optional<LooseCamera> jump;
  *clearness = kClear;
  for (size_t split = kLeast; split + kLeast <= shifts.size(); ++split) {
    const auto middle = shifts.begin() + long(split);
    const double pixels =
        (medianShift(middle, shifts.end()) - medianShift(shifts.begin(), middle)).norm();
    if (pixels < kLeastPixels) continue;
    std::vector<double> distances;
    addDistances(shifts.begin(), middle, &distances);
    addDistances(middle, shifts.end(), &distances);
    double mean = 0;
    for (const double distance : distances) mean += distance / double(distances.size());
    const double clear = pixels / (mean + 0.1);
    if (clear < *clearness) continue;
    *clearness = clear;
    jump = LooseCamera{0, middle->time, split >= shifts.size() - split, pixels};
  }
  return jump;
}

/// Of the views of the part that is left out.
void setUsed(const LooseCamera& loose, bool used, RigState* state) {
  for (Instant& instant : state->instants)
    for (ViewSight& view : instant.views)
      if (view.camera == loose.camera && (instant.time >= loose.time) == loose.later_part)
        view.used = used;
}

}  // namespace

std::optional<LooseCamera> loosestCamera(const Board& board, const RigState& state) {
  std::optional<LooseCamera> loosest;
  for (size_t camera = 0; camera < state.cameras.size(); ++camera) {
    double clearness = 0;
    std::optional<LooseCamera> jump = jumpOf(shiftsOf(board, state, camera), &clearness);
    if (!jump || (loosest && jump->pixels <= loosest->pixels)) continue;
    jump->camera = camera;
    loosest = jump;
  }
  return loosest;
}

std::vector<LooseCamera> leaveOutLooseViews(const Board& board, const BundleOptions& options,
                                            RigState* state) {
  std::vector<LooseCamera> found;
  while (found.size() < state->cameras.size()) {
    const std::optional<LooseCamera> loose = loosestCamera(board, *state);
    if (!loose) break;
    found.push_back(*loose);
    setUsed(*loose, false, state);
    adjustBundle(board, options, state);
  }
  if (found.size() < 2) return found;
  // A loose camera pulls others with it, and one of these may have been found before it.
  std::vector<LooseCamera> confirmed = {found.back()};
  for (auto earlier = found.rbegin() + 1; earlier != found.rend(); ++earlier) {
    setUsed(*earlier, true, state);
    adjustBundle(board, options, state);
    const std::optional<LooseCamera> again = loosestCamera(board, *state);
    if (!again) continue;
    setUsed(*earlier, false, state);
    adjustBundle(board, options, state);
    confirmed.push_back(*earlier);
  }
  return confirmed;
}

}  // namespace markerless_mocap
