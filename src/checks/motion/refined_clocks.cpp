#include "checks/motion/refined_clocks.h"

#include <algorithm>
#include <cmath>

#include "checks/motion/clock_search.h"
#include "checks/motion/walked.h"

namespace markerless_mocap {
namespace {

constexpr int kRounds = 3;

/// The cameras whose offsets are known.
struct TimedCameras {
  std::vector<size_t> indices;
  RigModel model;

  TimedCameras(const RigModel& all, const std::vector<double>& offsets) {
    for (size_t i = 0; i < all.size(); ++i) {
      if (!std::isfinite(offsets[i])) continue;
      indices.push_back(i);
      model.push_back(all[i]);
      model.back().offset = offsets[i];
      model.back().drift = 0;
    }
  }
  std::vector<Rays> rays(const RigSight& sight) const {
    std::vector<Rays> rays;
    for (const CameraModel& one : model) rays.push_back(raysOf(sight, one));
    return rays;
  }
};

double finer(const RigSight& sight, const TimedCameras& timed, size_t camera, double reach) {
  const std::vector<Rays> rays = timed.rays(sight);
  CameraState state;
  state.camera = camera;
  state.points =
      pointsOf(rays, rays.size() > 2 ? std::vector<size_t>{camera} : std::vector<size_t>{});
  state.rays = rays[camera];
  const CameraModel& model = timed.model[camera];
  const double period = sight.tracks[model.source].period;
  return ClockSearch(sight, model, state, reach, std::min(period, reach) / 4).offset().offset;
}

}  // namespace

void refineOffsets(const RigSight& sight, const RigModel& model, size_t root, double reach,
                   std::vector<double>* offsets) {
  if (sight.moments.empty()) return;
  TimedCameras timed(model, *offsets);
  for (int round = 0; round < kRounds; ++round, reach /= 2)
    for (size_t k = 0; k < timed.model.size(); ++k)
      if (timed.indices[k] != root) timed.model[k].offset += finer(sight, timed, k, reach);
  for (size_t k = 0; k < timed.model.size(); ++k)
    (*offsets)[timed.indices[k]] = timed.model[k].offset;
}

double walkedAt(const RigSight& sight, const RigModel& model, const std::vector<double>& offsets) {
  std::vector<CameraState> states;
  for (const Rays& rays : TimedCameras(model, offsets).rays(sight)) {
    states.emplace_back();
    states.back().rays = rays;
  }
  return states.empty() ? 0.0 : walkedIn(states);
}

}  // namespace markerless_mocap
