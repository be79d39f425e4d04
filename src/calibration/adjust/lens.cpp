#include "calibration/lens.h"

#include <stdexcept>

#include "text/joined.h"

namespace markerless_mocap {
namespace {

struct ModelFacts {
  const char* name;
  int coefficients;
  size_t length;  ///< of D
};

const ModelFacts& factsOf(LensModel model) {
  static constexpr ModelFacts kFacts[] = {
      {"none", 0, 0},           {"k1", 1, 4},      {"k1 k2", 2, 4},   {"k1 k2 p1 p2", 4, 4},
      {"k1 k2 p1 p2 k3", 5, 5}, {"fisheye", 4, 4}, {"rational", 8, 8}};
  return kFacts[size_t(model)];
}

}  // namespace

std::string nameOf(LensModel model) {
  return factsOf(model).name;
}

LensModel lensModelNamed(const std::string& name) {
  std::string known;
  for (const LensModel model : kLensModels) {
    if (nameOf(model) == name) return model;
    addWord(&known, nameOf(model));
  }
  throw std::invalid_argument("there is no lens model '" + name + "', allowed are " + known);
}

int coefficientsOf(LensModel model) {
  return factsOf(model).coefficients;
}

LensModel modelOf(const CameraCalibration& calibration) {
  if (calibration.lens == LensType::kFisheye) return LensModel::kFisheye;
  const size_t coefficients = calibration.D.size();
  return coefficients == 8   ? LensModel::kRational
         : coefficients == 5 ? LensModel::kPlumbBob
         : coefficients == 4 ? LensModel::kTangential
                             : LensModel::kNone;
}

std::vector<int> fixedIntrinsics(LensModel model) {
  std::vector<int> fixed;
  for (int i = 4 + coefficientsOf(model); i < 12; ++i) fixed.push_back(i);
  return fixed;
}

void setIntrinsics(const Intrinsics& in, LensModel model, CameraCalibration* calibration) {
  calibration->K << in[0], 0, in[2], 0, in[1], in[3], 0, 0, 1;
  calibration->lens = typeOf(model);
  calibration->D.assign(in.begin() + 4, in.begin() + 4 + factsOf(model).length);
}

Intrinsics intrinsicsOf(const CameraCalibration& calibration) {
  const Eigen::Matrix3d& K = calibration.K;
  if (K(0, 1) != 0)
    throw std::invalid_argument("camera '" + calibration.name +
                                "': its K has a skew, which a calibration by boards cannot keep");
  Intrinsics in{K(0, 0), K(1, 1), K(0, 2), K(1, 2)};
  std::copy(calibration.D.begin(), calibration.D.end(), in.begin() + 4);
  return in;
}

}  // namespace markerless_mocap
