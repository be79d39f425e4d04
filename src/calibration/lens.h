#pragma once

#include <array>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Lens models. Each has the coefficients of the ones before it, but for the fisheye, which is a
/// family of its own.
enum class LensModel { kNone, kRadial1, kRadial2, kTangential, kPlumbBob, kFisheye, kRational };

constexpr std::array<LensModel, 7> kLensModels = {
    LensModel::kNone,     LensModel::kRadial1, LensModel::kRadial2, LensModel::kTangential,
    LensModel::kPlumbBob, LensModel::kFisheye, LensModel::kRational};

/// "none", "k1", "k1 k2", "k1 k2 p1 p2", "k1 k2 p1 p2 k3", "fisheye" or "rational".
std::string nameOf(LensModel model);
/// Throws std::invalid_argument, listing the names.
LensModel lensModelNamed(const std::string& name);
/// Number of distortion coefficients that are estimated.
int coefficientsOf(LensModel model);

inline LensType typeOf(LensModel model) {
  return model == LensModel::kFisheye ? LensType::kFisheye : LensType::kPolynomial;
}
/// The model of a calibration with its type of lens and its length of D, whatever the values.
LensModel modelOf(const CameraCalibration& calibration);

/// How well a lens model predicts views that it was not estimated from.
struct LensTrial {
  LensModel lens = LensModel::kNone;
  double rms = 0.0;  ///< pixels, on views left out
};

/// fx fy cx cy (pixels) and OpenCV's k1 k2 p1 p2 k3 k4 k5 k6; of a fisheye k1 k2 k3 k4 and zeros.
using Intrinsics = std::array<double, 12>;

/// Indices of Intrinsics that a model holds fixed.
std::vector<int> fixedIntrinsics(LensModel model);

/// K, D and type of a calibration's lens; D has the length that the model needs: 0, 4, 5 or 8.
void setIntrinsics(const Intrinsics& intrinsics, LensModel model, CameraCalibration* calibration);
/// Throws std::invalid_argument if K has a skew.
Intrinsics intrinsicsOf(const CameraCalibration& calibration);

}  // namespace markerless_mocap
