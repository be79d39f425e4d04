#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "checks/motion/explanation.h"

namespace markerless_mocap {
namespace {

/// Cosine to the vertical above which shoulders hide the body, which looks like another lens.
constexpr double kSteep = 0.6;

const std::vector<double>& focalSteps() {
  static const std::vector<double> steps{0.5,  0.6,  0.7,  0.8,  0.87, 0.93, 0.97,
                                         1.03, 1.07, 1.15, 1.25, 1.4,  1.6,  2.0};
  return steps;
}

const std::vector<double>& bendSteps() {
  static const std::vector<double> steps{-0.5, -0.4, -0.3, -0.2, -0.12, -0.06,
                                         0.06, 0.12, 0.2,  0.3,  0.4,   0.5};
  return steps;
}

void scaleFocal(CameraCalibration* camera, double factor) {
  camera->K(0, 0) *= factor;
  camera->K(1, 1) *= factor;
}

void addBend(CameraCalibration* camera, double k1) {
  if (camera->D.empty()) camera->D.assign(4, 0.0);
  camera->D[0] += k1;
}

/// The best of the steps for one camera; distortions that no lens has are passed over.
void tryCamera(const RigSight& sight, const RigModel& model, const CameraState& state,
               ExplanationKind kind, const std::vector<double>& steps,
               const std::function<void(CameraCalibration*, double)>& change,
               std::vector<Explanation>* out) {
  Explanation best;
  best.kind = kind;
  best.cameras = {state.camera};
  best.before = state.loss.residual;
  for (const double step : steps) try {
      CameraModel camera = model[state.camera];
      change(&camera.calibration, step);
      const CameraLoss loss = lossOf(raysOf(sight, camera), state.points);
      const double gain = state.loss.rays * (state.loss.loss - loss.loss);
      if (gain <= best.gain) continue;
      best.gain = gain;
      best.amount = step;
      best.after = loss.residual;
      best.model = model;
      best.model[state.camera] = camera;
    } catch (const std::invalid_argument&) {
    }
  if (best.gain > 0) out->push_back(std::move(best));
}

}  // namespace

void tryLens(const RigSight& sight, const RigModel& model, const CameraState& state,
             std::vector<Explanation>* out) {
  const Eigen::Isometry3d& pose = model[state.camera].calibration.T_world_camera;
  if (std::abs(pose.linear()(2, 2)) > kSteep) return;
  tryCamera(sight, model, state, ExplanationKind::kFocalLength, focalSteps(), scaleFocal, out);
  tryCamera(sight, model, state, ExplanationKind::kDistortion, bendSteps(), addBend, out);
}

}  // namespace markerless_mocap
