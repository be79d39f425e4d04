#pragma once

#include <array>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Lens models, each with the coefficients of the ones before it.
enum class LensModel { kNone, kRadial1, kRadial2, kTangential, kPlumbBob, kRational };

constexpr std::array<LensModel, 6> kLensModels = {LensModel::kNone,     LensModel::kRadial1,
                                                  LensModel::kRadial2,  LensModel::kTangential,
                                                  LensModel::kPlumbBob, LensModel::kRational};

/// "none", "k1", "k1 k2", "k1 k2 p1 p2", "k1 k2 p1 p2 k3" or "rational".
std::string nameOf(LensModel model);
/// Throws std::invalid_argument, listing the names.
LensModel lensModelNamed(const std::string& name);
/// Number of distortion coefficients that are estimated.
int coefficientsOf(LensModel model);

/// fx fy cx cy (pixels) and OpenCV's k1 k2 p1 p2 k3 k4 k5 k6.
using Intrinsics = std::array<double, 12>;

/// Indices of Intrinsics that a model holds fixed.
std::vector<int> fixedIntrinsics(LensModel model);

/// K and D of a calibration; D has the length that the model needs: 0, 4, 5 or 8.
void setIntrinsics(const Intrinsics& intrinsics, LensModel model, CameraCalibration* calibration);
/// Throws std::invalid_argument if K has a skew.
Intrinsics intrinsicsOf(const CameraCalibration& calibration);

}  // namespace markerless_mocap
