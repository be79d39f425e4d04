#include "skeleton/labelling/validity_model.h"

#include <cmath>

#include "files/yaml_text.h"
#include "skeleton/labelling/model_curves.h"

namespace markerless_mocap {

double ValidityModel::probability(const ValidityFeatures& features) const {
  double odds = intercept;
  for (size_t i = 0; i < features.size(); ++i) odds += curves[i](features[i]);
  return 1.0 / (1.0 + std::exp(-odds));
}

ValidityModel ValidityModel::fromYaml(const std::string& yaml, const std::string& where) {
  ValidityModel model;
  YamlMap file(yamlFrom(yaml, where), where);
  model.intercept = file.number("intercept");
  model.curves = curvesIn<ValidityFeature, kValidityFeatureCount>(file.map("curves"));
  file.finish();
  return model;
}

}  // namespace markerless_mocap
