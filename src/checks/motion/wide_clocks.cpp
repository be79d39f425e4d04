#include <algorithm>
#include <cmath>

#include "checks/motion/explanation.h"
#include "checks/motion/person_clocks.h"

namespace markerless_mocap {
namespace {

constexpr double kLoose = 0.45;     // mean loss of a camera that may be timed wrongly
constexpr double kLeast = 0.8;      // s: what is less, the search around the stamps finds
constexpr double kTogether = 0.1;   // s
constexpr double kLeastGain = 0.2;  // of the mean loss

bool isAnyLoose(const std::vector<CameraState>& states) {
  return std::any_of(states.begin(), states.end(),
                     [](const CameraState& state) { return state.loss.loss > kLoose; });
}

/// The offset that most cameras share.
double usualOffset(const std::vector<double>& offsets) {
  double usual = offsets.front();
  long most = 0;
  for (const double one : offsets) {
    const long alike = std::count_if(offsets.begin(), offsets.end(), [&](double other) {
      return std::abs(other - one) < kTogether;
    });
    if (alike <= most) continue;
    most = alike;
    usual = one;
  }
  return usual;
}

Explanation offsetOf(const RigModel& model, const CameraState& before, const CameraState& after,
                     double amount) {
  Explanation found;
  found.kind = ExplanationKind::kTimeOffset;
  found.cameras = {before.camera};
  found.model = model;
  found.amount = amount;
  found.before = before.loss.residual;
  found.after = after.loss.residual;
  found.gain = after.loss.rays * (before.loss.loss - after.loss.loss);
  return found;
}

}  // namespace

std::vector<Explanation> undoWideOffsets(const RigSight& sight, RigModel* model) {
  const std::vector<CameraState> states = statesOf(sight, *model);
  if (!isAnyLoose(states)) return {};
  const FilmClocks clocks = searchPersonClocks(sight.tracks, *model, kLargestFilmOffset);
  if (!clocks.certain()) return {};
  const double usual = usualOffset(clocks.offsets);
  RigModel changed = *model;
  for (size_t i = 0; i < changed.size(); ++i)
    if (std::abs(clocks.offsets[i] - usual - changed[i].offset) > kLeast)
      changed[i].offset = clocks.offsets[i] - usual;
  const std::vector<CameraState> after = statesOf(sight, changed);
  std::vector<Explanation> found;
  for (size_t i = 0; i < changed.size(); ++i) {
    if (changed[i].offset == (*model)[i].offset) continue;
    if (states[i].loss.loss - after[i].loss.loss < kLeastGain) return {};
    found.push_back(offsetOf(changed, states[i], after[i], changed[i].offset));
  }
  *model = changed;
  return found;
}

}  // namespace markerless_mocap
