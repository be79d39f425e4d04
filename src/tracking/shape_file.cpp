#include "markerless_mocap/tracking/shape_file.h"

#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "files/yaml_text.h"

namespace markerless_mocap {

double statureOf(const ShapeParameters& shape) {
  using L = BodyLength;
  return shape[L::kAnkleHeight] + shape[L::kShank] + shape[L::kThigh] + shape[L::kTorso] +
         shape[L::kNeck] + shape[L::kHead];
}

std::string shapeToYaml(const ShapeParameters& shape) {
  std::string text =
      "# Body shape of one person, metres: distances between joints, then the round cones. Each\n"
      "# end of a cone has a radius and an offset from the joint (x forward, y outward or to the\n"
      "# left, z up the limb).\n";
  for (int i = 0; i < kShapeParameterCount; ++i) {
    char line[96];
    std::snprintf(line, sizeof line, "%s: %.6f\n", shapeParameterName(i).c_str(), shape[i]);
    text += line;
  }
  return text;
}

constexpr double kLongest = 2.0;  // of a part of a person, metres

ShapeParameters shapeFromYaml(const std::string& yaml, const std::string& where) {
  const YAML::Node root = yamlFrom(yaml, where);
  if (!root.IsMap())
    throw std::invalid_argument(where + " must map names of shape parameters to metres");
  ShapeParameters shape;
  std::set<std::string> known;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    const std::string& name = shapeParameterName(i);
    known.insert(name);
    const YAML::Node node = root[name];
    if (!node) throw std::invalid_argument(where + " lacks the shape parameter " + name);
    shape[i] = node.IsScalar() ? node.as<double>(NAN) : NAN;
    if (!std::isfinite(shape[i]) || (!isOffset(i) && !(shape[i] > 0)))
      throw std::invalid_argument(where + ": " + name + " must be a " +
                                  (isOffset(i) ? "" : "positive ") + "number of metres");
    if (std::abs(shape[i]) > kLongest)
      throw std::invalid_argument(where + ": " + name + " is " + node.Scalar() +
                                  " m, allowed are up to 2 m");
  }
  for (const auto& entry : root)
    if (const auto key = entry.first.as<std::string>(""); !known.count(key))
      throw std::invalid_argument(where + " has the unknown shape parameter " + key);
  return shape;
}

}  // namespace markerless_mocap
