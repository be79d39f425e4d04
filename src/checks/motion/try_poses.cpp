#include <algorithm>
#include <stdexcept>

#include "checks/motion/explanation.h"

namespace markerless_mocap {
namespace {

constexpr double kRival = 0.9;        // of the gain
constexpr double kSuspicious = 0.25;  // mean loss of a camera whose pose may be grossly wrong

const std::vector<ExplanationKind>& poseMistakes() {
  static const std::vector<ExplanationKind> kinds{
      ExplanationKind::kRotationInverted, ExplanationKind::kTranslationInverted,
      ExplanationKind::kPoseInverted, ExplanationKind::kBodyAxes};
  return kinds;
}

/// Source, turn and pose changed at once, and its loss against the same points.
void tryOne(const RigSight& sight, const RigModel& model, const CameraState& state,
            ExplanationKind kind, std::vector<Explanation>* out) {
  Explanation tried;
  tried.kind = kind;
  tried.cameras = {state.camera};
  tried.model = model;
  CameraModel& camera = tried.model[state.camera];
  camera.calibration.T_world_camera = undone(kind, camera.calibration.T_world_camera);
  if (kind == ExplanationKind::kUpsideDown) camera.turn = ImageTurn::kUpsideDown;
  if (kind == ExplanationKind::kMirrored) camera.turn = ImageTurn::kMirrored;
  const CameraLoss loss = lossOf(raysOf(sight, camera), state.points);
  tried.before = state.loss.residual;
  tried.after = loss.residual;
  tried.gain = state.loss.rays * (state.loss.loss - loss.loss);
  out->push_back(std::move(tried));
}

double sumOfRays(const std::vector<CameraState>& states) {
  double sum = 0;
  for (const CameraState& state : states) sum += state.loss.rays;
  return sum;
}

std::vector<Rays> allRays(const RigSight& sight, const RigModel& model) {
  std::vector<Rays> rays;
  for (const CameraModel& camera : model) rays.push_back(raysOf(sight, camera));
  return rays;
}

double largestResidual(const std::vector<CameraState>& states) {
  double most = 0;
  for (const CameraState& state : states) most = std::max(most, state.loss.residual);
  return most;
}

/// In a rig that looks the same when it is turned, two exchanges may explain the same.
void noteRivals(size_t from, std::vector<Explanation>* all) {
  for (size_t a = from; a < all->size(); ++a)
    for (size_t b = from; b < all->size(); ++b)
      if (a != b && (*all)[b].gain > kRival * (*all)[a].gain && (*all)[a].instead.empty())
        (*all)[a].instead = (*all)[b].cameras;
}

}  // namespace

Eigen::Isometry3d undone(ExplanationKind kind, const Eigen::Isometry3d& T) {
  Eigen::Isometry3d out = T;
  Eigen::Matrix3d body_of_optical;
  body_of_optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  switch (kind) {
    case ExplanationKind::kRotationInverted:
      out.linear() = T.linear().transpose();
      break;
    case ExplanationKind::kTranslationInverted:
      out.translation() = -(T.linear() * T.translation());
      break;
    case ExplanationKind::kPoseInverted:
      out = T.inverse();
      break;
    case ExplanationKind::kBodyAxes:
      out.linear() = T.linear() * body_of_optical;
      break;
    default:
      break;
  }
  return out;
}

void tryPoses(const RigSight& sight, const RigModel& model, const CameraState& state,
              std::vector<Explanation>* out) {
  if (state.loss.loss < kSuspicious) return;
  for (const ExplanationKind kind : poseMistakes()) tryOne(sight, model, state, kind, out);
  tryOne(sight, model, state, ExplanationKind::kUpsideDown, out);
  tryOne(sight, model, state, ExplanationKind::kMirrored, out);
}

void tryExchanges(const RigSight& sight, const RigModel& model,
                  const std::vector<CameraState>& states, std::vector<Explanation>* out) {
  std::vector<Rays> rays;
  for (const CameraState& state : states) rays.push_back(state.rays);
  const double total = lossOf(rays), all = sumOfRays(states);
  const size_t from = out->size();
  for (size_t i = 0; i < states.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      if (states[i].loss.loss < kSuspicious || states[j].loss.loss < kSuspicious) continue;
      Explanation tried;
      tried.kind = ExplanationKind::kExchanged;
      tried.cameras = {j, i};
      tried.model = model;
      std::swap(tried.model[i].source, tried.model[j].source);
      std::vector<Rays> changed = rays;
      changed[i] = raysOf(sight, tried.model[i]);
      changed[j] = raysOf(sight, tried.model[j]);
      tried.gain = all * (total - lossOf(changed));
      tried.before = std::max(states[i].loss.residual, states[j].loss.residual);
      out->push_back(std::move(tried));
    }
  noteRivals(from, out);
}

void tryWholeRig(const RigSight& sight, const RigModel& model,
                 const std::vector<CameraState>& states, std::vector<Explanation>* out) {
  std::vector<Rays> rays;
  for (const CameraState& state : states) rays.push_back(state.rays);
  const double total = lossOf(rays), all = sumOfRays(states);
  const auto attempt = [&](Explanation tried) {
    for (size_t i = 0; i < model.size(); ++i) tried.cameras.push_back(i);
    tried.gain = all * (total - lossOf(allRays(sight, tried.model)));
    tried.before = largestResidual(states);
    out->push_back(std::move(tried));
  };
  if (total > kSuspicious)
    for (const ExplanationKind kind : poseMistakes()) {
      Explanation tried;
      tried.kind = kind;
      tried.model = model;
      for (CameraModel& camera : tried.model)
        camera.calibration.T_world_camera = undone(kind, camera.calibration.T_world_camera);
      attempt(std::move(tried));
    }
}

}  // namespace markerless_mocap
