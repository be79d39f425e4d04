#include <algorithm>
#include <cmath>

#include "checks/motion/explanation.h"
#include "checks/motion/walked.h"

namespace markerless_mocap {
namespace {

constexpr int kFewRays = 40;
constexpr double kLoose = 0.45;  // mean loss of a camera that may be turned, and others with it
constexpr double kLeastTurn = 0.6 * M_PI / 180;
constexpr double kMostTurnOfAll = 20 * M_PI / 180;  // beyond it a rig is not loose, but wrong
constexpr double kFarOff =
    40;  // px of kModelWidth: more than what is not the person moves its marks
constexpr double kLeastOffset = 0.010;  // s
constexpr double kLeastOffsetPeriods = 0.4;
constexpr double kDeviations = 4;
// Of clocks less are asked: in good recordings they gain at most half of what they must.
constexpr double kDeviationsOfClock = 3, kDeviationsOfName = 2;
constexpr double kClearlyMore = 1.25;
// What a change of one camera must take away of the camera's own loss and median residual: where
// silhouettes are spoiled, some clock or lens always fits a little better by chance.
constexpr double kLeastShare = 0.12, kLeastFall = 0.2;

/// Gain of the mean loss that a change must give; more where it has more freedom.
double leastGain(ExplanationKind kind) {
  switch (kind) {
    case ExplanationKind::kTimeOffset:
      return 0.04;
    case ExplanationKind::kDrift:
      return 0.06;
    case ExplanationKind::kTurned:
    case ExplanationKind::kFocalLength:
      return 0.15;
    case ExplanationKind::kDistortion:
      return 0.07;
    default:
      return 0.2;
  }
}

/// What the candidates of a round are judged by.
struct Round {
  std::vector<CameraState> states;
  bool on_one_spot = false;
};

/// Towards one spot any rig can be turned, camera by camera: nothing is told of all cameras by
/// somebody who stays there as the turned ones see it.
/// \param deviations that a clock's error must have
bool isLargeEnough(const Explanation& tried, const RigSight& sight, const Round& round,
                   double deviations) {
  const size_t camera = tried.cameras.front();
  const PersonTrack& track = sight.tracks[tried.model[camera].source];
  const double length = track.seconds.back() - track.seconds.front();
  const double amount = std::abs(tried.amount);
  switch (tried.kind) {
    case ExplanationKind::kTimeOffset:
      return amount > std::max(kLeastOffset, kLeastOffsetPeriods * track.period) &&
             amount > deviations * tried.deviation;
    case ExplanationKind::kDrift:
      return amount * length > track.period && amount > deviations * tried.deviation;
    case ExplanationKind::kTurned:
      if (!tried.amounts.empty() &&
          (amount > kMostTurnOfAll || walkedIn(statesOf(sight, tried.model)) < kOneSpot))
        return false;
      return amount > kLeastTurn && amount > kDeviations * tried.deviation &&
             (!round.on_one_spot || tried.before > kFarOff);
    case ExplanationKind::kFocalLength:
    case ExplanationKind::kDistortion:
      return !round.on_one_spot;
    default:
      return true;
  }
}

bool isClearlyBetter(const Explanation& tried, const std::vector<CameraState>& states) {
  if (tried.cameras.size() > 1) return true;  // their least gain is a large share of any loss
  const CameraLoss& loss = states[tried.cameras.front()].loss;
  return tried.gain > kLeastShare * loss.loss * loss.rays &&
         tried.after < (1 - kLeastFall) * tried.before;
}

std::vector<Explanation> candidatesOf(const RigSight& sight, const RigModel& model,
                                      const std::vector<CameraState>& states) {
  std::vector<Explanation> all;
  tryWholeRig(sight, model, states, &all);
  tryExchanges(sight, model, states, &all);
  if (std::any_of(states.begin(), states.end(),
                  [](const CameraState& state) { return state.loss.loss > kLoose; }))
    tryAllTurns(sight, model, states, &all);
  for (const CameraState& state : states) {
    if (state.loss.rays < kFewRays) continue;
    tryPoses(sight, model, state, &all);
    tryClock(sight, model, state, &all);
    tryTurn(sight, model, state, &all);
    tryLens(sight, model, state, &all);
  }
  return all;
}

/// Rays of the cameras that an explanation changes.
double raysOfChanged(const Explanation& tried, const std::vector<CameraState>& states) {
  double rays = 0;
  for (const size_t camera : tried.cameras) rays += states[camera].loss.rays;
  return rays;
}

/// A drift in place of an offset of the same camera, if it explains clearly more: that the clock is
/// wrong is then known, and only its name is in question.
bool isRatherDrift(const Explanation& drift, const Explanation& offset, const RigSight& sight,
                   const Round& round) {
  return drift.kind == ExplanationKind::kDrift && drift.cameras == offset.cameras &&
         drift.gain > kClearlyMore * offset.gain &&
         isLargeEnough(drift, sight, round, kDeviationsOfName);
}

std::optional<Explanation> strongest(const RigSight& sight, const RigModel& model,
                                     const Round& round) {
  const std::vector<Explanation> all = candidatesOf(sight, model, round.states);
  const Explanation* best = nullptr;
  double most = 0;
  for (const Explanation& tried : all) {
    const double excess = tried.gain - leastGain(tried.kind) * raysOfChanged(tried, round.states);
    if (excess <= most || !isLargeEnough(tried, sight, round, kDeviationsOfClock) ||
        !isClearlyBetter(tried, round.states))
      continue;
    most = excess;
    best = &tried;
  }
  if (!best) return std::nullopt;
  if (best->kind == ExplanationKind::kTimeOffset)
    for (const Explanation& tried : all)
      if (isRatherDrift(tried, *best, sight, round)) return tried;
  return *best;
}

void toPixelsOfCamera(Explanation* found) {
  const double scale = found->model[found->cameras.front()].calibration.width / kModelWidth;
  found->before *= scale;
  found->after *= scale;
}

}  // namespace

std::vector<CameraState> statesOf(const RigSight& sight, const RigModel& model) {
  std::vector<Rays> rays;
  for (const CameraModel& camera : model) rays.push_back(raysOf(sight, camera));
  std::vector<CameraState> states;
  for (size_t k = 0; k < model.size(); ++k) {
    CameraState state;
    state.camera = k;
    state.rays = rays[k];
    state.points = pointsOf(rays, {k});
    state.loss = lossOf(state.rays, state.points);
    states.push_back(std::move(state));
  }
  return states;
}

std::vector<Explanation> explain(const RigSight& sight, const RigModel& given, RigModel* final,
                                 std::vector<CameraState>* left) {
  *final = given;
  std::vector<Explanation> found = undoWideOffsets(sight, final);
  for (Explanation& wide : found) toPixelsOfCamera(&wide);
  for (size_t i = 0; i < 2 * given.size(); ++i) {
    Round round{statesOf(sight, *final)};
    round.on_one_spot = walkedIn(round.states) < kOneSpot;
    std::optional<Explanation> best = strongest(sight, *final, round);
    if (!best) break;
    *final = best->model;
    toPixelsOfCamera(&*best);
    found.push_back(std::move(*best));
    if (!found.back().amounts.empty()) break;  // what is left is too uncertain to tell more
  }
  *left = statesOf(sight, *final);
  return found;
}

}  // namespace markerless_mocap
