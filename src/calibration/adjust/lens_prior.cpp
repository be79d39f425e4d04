#include "calibration/adjust/lens_prior.h"

#include <limits>

namespace markerless_mocap {

LensPrior commonLens(const CameraState& camera, double noise) {
  constexpr double kCentre = 0.03;       // of the diagonal
  constexpr double kTangential = 0.002;  // p1 p2
  constexpr double kCoefficient = 3.0;
  LensPrior prior;
  prior.noise = noise;
  prior.sigma.fill(std::numeric_limits<double>::infinity());
  for (size_t i = 4; i < prior.sigma.size(); ++i) prior.sigma[i] = kCoefficient;
  if (typeOf(camera.lens) == LensType::kPolynomial) prior.sigma[6] = prior.sigma[7] = kTangential;
  if (camera.size.isZero()) return prior;
  for (int i = 0; i < 2; ++i) {
    prior.mean[2 + i] = 0.5 * (camera.size[i] - 1);
    prior.sigma[2 + i] = kCentre * camera.size.norm();
  }
  return prior;
}

}  // namespace markerless_mocap
