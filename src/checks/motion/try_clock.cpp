#include "checks/motion/clock_search.h"
#include "checks/motion/explanation.h"

namespace markerless_mocap {
namespace {

constexpr double kLargest = 1.0;     // s
constexpr double kMostGrowth = 0.5;  // s, by a drift from the middle to the end
constexpr double kSharp = 0.03;      // gain of loss against other times that shows a time at all
constexpr double kFine = 0.25;       // part of a period

/// \param error of the model's clock
Explanation explanationOf(ExplanationKind kind, const RigModel& model, size_t camera,
                          const ClockError& error, double since_first) {
  Explanation tried;
  tried.kind = kind;
  tried.cameras = {camera};
  tried.model = model;
  tried.model[camera].offset += error.offset - error.drift * since_first;
  tried.model[camera].drift += error.drift;
  tried.amount = kind == ExplanationKind::kDrift ? error.drift : error.offset;
  tried.deviation = error.deviation;
  return tried;
}

void finish(const RigSight& sight, const CameraState& state, Explanation tried,
            std::vector<Explanation>* out) {
  const CameraLoss loss = lossOf(raysOf(sight, tried.model[state.camera]), state.points);
  tried.before = state.loss.residual;
  tried.after = loss.residual;
  tried.gain = state.loss.rays * (state.loss.loss - loss.loss);
  out->push_back(std::move(tried));
}

}  // namespace

void tryClock(const RigSight& sight, const RigModel& model, const CameraState& state,
              std::vector<Explanation>* out) {
  const CameraModel& camera = model[state.camera];
  const PersonTrack& track = sight.tracks[camera.source];
  const double length = sight.moments.back() - sight.moments.front();
  if (track.period <= 0 || length <= 0) return;
  const ClockSearch coarse(sight, camera, state, kLargest, track.period);
  if (coarse.sharpness() < kSharp) return;
  const double since_first = coarse.middle() - track.seconds.front();
  const auto add = [&](ExplanationKind kind, ClockError error) {
    CameraModel near = camera;
    near.offset += error.offset - error.drift * since_first;
    near.drift += error.drift;
    const ClockSearch fine(sight, near, state, 2 * track.period, kFine * track.period);
    error.offset += fine.offset().offset;
    finish(sight, state, explanationOf(kind, model, state.camera, error, since_first), out);
  };
  add(ExplanationKind::kTimeOffset, coarse.offset());
  add(ExplanationKind::kDrift, coarse.offsetAndDrift(2 * kMostGrowth / length));
}

}  // namespace markerless_mocap
