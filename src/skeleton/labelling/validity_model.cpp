#include "skeleton/labelling/validity_model.h"

#include <cmath>

#include "skeleton/labelling/model_reader.h"

namespace markerless_mocap {

double ValidityModel::probability(const ValidityFeatures& features) const {
  double odds = intercept;
  for (size_t i = 0; i < features.size(); ++i) odds += curves[i](features[i]);
  return 1.0 / (1.0 + std::exp(-odds));
}

ValidityModel ValidityModel::fromYaml(const std::string& yaml, const std::string& where) {
  ValidityModel model;
  ModelReader file(yaml, where);
  model.intercept = file.number("intercept");
  model.curves = file.curves<ValidityFeature, kValidityFeatureCount>("curves");
  file.finish();
  return model;
}

}  // namespace markerless_mocap
