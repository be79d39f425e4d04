#include "markerless_mocap/tracking/shape_file.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>

namespace markerless_mocap {

double statureOf(const ShapeParameters& sizes) {
  using L = ContourLength;
  return sizes[L::kAnkleHeight] + sizes[L::kShank] + sizes[L::kThigh] + sizes[L::kTorso] +
         sizes[L::kNeck] + sizes[L::kHead];
}

std::string shapeToYaml(const ShapeParameters& sizes) {
  std::string text =
      "# Sizes of one person, metres: distances between joints, then radii of round cones' ends "
      "and\n"
      "# what these ends are away from the joints (x forward, y outward or left, z up the limb).\n";
  for (int i = 0; i < kShapeParameterCount; ++i) {
    char line[96];
    std::snprintf(line, sizeof line, "%s: %.6f\n", shapeParameterName(i).c_str(), sizes[i]);
    text += line;
  }
  return text;
}

ShapeParameters shapeFromYaml(const std::string& yaml, const std::string& where) {
  YAML::Node root;
  try {
    root = YAML::Load(yaml);
  } catch (const YAML::Exception& fault) {
    throw std::invalid_argument(where + " is not YAML: " + fault.msg);
  }
  if (!root.IsMap()) throw std::invalid_argument(where + " must map names of sizes to metres");
  ShapeParameters sizes;
  std::set<std::string> known;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    const std::string& name = shapeParameterName(i);
    known.insert(name);
    const YAML::Node node = root[name];
    if (!node) throw std::invalid_argument(where + " lacks the size " + name);
    sizes[i] = node.IsScalar() ? node.as<double>(NAN) : NAN;
    if (!std::isfinite(sizes[i]) || (!isOffset(i) && !(sizes[i] > 0)))
      throw std::invalid_argument(where + ": " + name + " must be a " +
                                  (isOffset(i) ? "" : "positive ") + "number of metres");
  }
  for (const auto& entry : root)
    if (const auto key = entry.first.as<std::string>(""); !known.count(key))
      throw std::invalid_argument(where + " has the unknown size " + key);
  return sizes;
}

}  // namespace markerless_mocap
