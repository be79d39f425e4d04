#include "markerless_mocap/tracking/shape_parameters.h"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr const char* kLengthNames[] = {"torso",   "neck",         "head",           "upper_arm",
                                        "forearm", "hand",         "thigh",          "shank",
                                        "foot",    "ankle_height", "shoulder_width", "hip_width"};
constexpr const char* kConeNames[] = {"pelvis",  "chest", "yoke",  "neck", "head", "upper_arm",
                                      "forearm", "hand",  "thigh", "calf", "shin", "foot"};
constexpr const char* kValueNames[] = {"radius", "offset_x", "offset_y", "offset_z"};

constexpr const char* kMeaning =
    "# The contour body: round cones about a skeleton. Each shape parameter is given as\n"
    "# [mean, standard deviation over people], as fractions of the stature. A parameter of\n"
    "# deviation 0 is not estimated. Lengths are between joints, as in the URDF. End a of a cone\n"
    "# is the one nearer to the hips (arms: to the shoulder). An offset is relative to the point\n"
    "# that the lengths alone determine, in the frame of the segment: x forward, y to the left,\n"
    "# z up while standing with hanging arms, for the left side; the right side is mirrored.\n";

void checkStature(double stature) {
  if (!(stature >= 0.5 && stature <= 2.5))
    throw std::invalid_argument("stature is " + std::to_string(stature) +
                                " m, allowed is 0.5 to 2.5 m");
}

double decimal(double value) {
  return std::round(value * 1e5) * 1e-5;
}

/// Mean and standard deviation of one parameter.
void readSize(const YAML::Node& node, const std::string& where, int parameter,
              ShapeStatistics& out) {
  const std::string name = where + ": shape parameter " + shapeParameterName(parameter);
  const auto number = [&](size_t i) {
    double value = NAN;
    if (!node.IsSequence() || node.size() != 2 || !YAML::convert<double>::decode(node[i], value) ||
        !std::isfinite(value))
      throw std::invalid_argument(name + " must be two numbers, mean and standard deviation");
    return value;
  };
  out.mean[parameter] = number(0);
  out.deviation[parameter] = number(1);
  if (!isOffset(parameter) && !(out.mean[parameter] > 0))
    throw std::invalid_argument(name + " must be positive");
  if (out.deviation[parameter] < 0)
    throw std::invalid_argument(name + " must have a deviation of at least 0");
}

}  // namespace

const std::string& shapeParameterName(int parameter) {
  static const std::array<std::string, kShapeParameterCount> names = [] {
    std::array<std::string, kShapeParameterCount> out;
    for (size_t i = 0; i < BodyLength::kCount; ++i) out[i] = kLengthNames[i];
    for (int kind = 0; kind < BodyCone::kCount; ++kind)
      for (int end = 0; end < 2; ++end)
        for (int value = 0; value < kValuesPerEnd; ++value)
          out[size_t(radiusIndex(kind, end) + value)] =
              std::string(kConeNames[kind]) + "_cone/" + (end ? "b/" : "a/") + kValueNames[value];
    return out;
  }();
  return names.at(size_t(parameter));
}

bool isOffset(int parameter) {
  return parameter >= BodyLength::kCount && (parameter - BodyLength::kCount) % kValuesPerEnd != 0;
}

BodyProportions proportionsOf(const ShapeParameters& shape) {
  BodyProportions p;
  p.torso = shape[BodyLength::kTorso];
  p.neck = shape[BodyLength::kNeck];
  p.head = shape[BodyLength::kHead];
  p.upper_arm = shape[BodyLength::kUpperArm];
  p.forearm = shape[BodyLength::kForearm];
  p.hand = shape[BodyLength::kHand];
  p.thigh = shape[BodyLength::kThigh];
  p.shank = shape[BodyLength::kShank];
  p.foot = shape[BodyLength::kFoot];
  p.ankle_height = shape[BodyLength::kAnkleHeight];
  p.shoulder_width = shape[BodyLength::kShoulderWidth];
  p.hip_width = shape[BodyLength::kHipWidth];
  // The radii of these cone ends in urdf/human.urdf.in at girth 1.
  p.girth = (shape[radiusIndex(BodyCone::kChest, 1)] / 0.109 +
             shape[radiusIndex(BodyCone::kThigh, 0)] / 0.087 +
             shape[radiusIndex(BodyCone::kCalf, 0)] / 0.057 +
             shape[radiusIndex(BodyCone::kUpperArm, 1)] / 0.045) /
            4;
  return p;
}

ShapeStatistics ShapeStatistics::handMade() {
  // Radii of the two ends at a stature of 1.75 m, as in urdf/human.urdf.in. Pelvis and chest
  // consist of two cones each, side by side.
  constexpr double kRadii[BodyCone::kCount][2] = {{0.106, 0.106}, {0.104, 0.109}, {0.058, 0.058},
                                                  {0.056, 0.056}, {0.075, 0.080}, {0.054, 0.045},
                                                  {0.042, 0.032}, {0.032, 0.026}, {0.087, 0.058},
                                                  {0.055, 0.055}, {0.052, 0.042}, {0.040, 0.036}};
  constexpr double kDrawn = 1.75, kPelvisSide = 0.073, kChestSide = 0.075;
  const BodyProportions p = BodyProportions::fromStature(1.0);
  ShapeStatistics made;
  made.mean.head<BodyLength::kCount>() << p.torso, p.neck, p.head, p.upper_arm, p.forearm, p.hand,
      p.thigh, p.shank, p.foot, p.ankle_height, p.shoulder_width, p.hip_width;
  for (int kind = 0; kind < BodyCone::kCount; ++kind)
    for (int end = 0; end < 2; ++end) {
      made.mean[radiusIndex(kind, end)] = kRadii[kind][end] / kDrawn;
      if (kind == BodyCone::kPelvis || kind == BodyCone::kChest)
        made.mean[offsetIndex(kind, end) + 1] =
            (kind == BodyCone::kPelvis ? kPelvisSide : kChestSide) / kDrawn;
    }
  for (int i = 0; i < kShapeParameterCount; ++i)
    made.deviation[i] = isOffset(i) ? 0.0 : made.mean[i] * (i < BodyLength::kCount ? 0.06 : 0.25);
  return made;
}

ShapeStatistics ShapeStatistics::fromPeople(const std::vector<ShapeParameters>& shapes,
                                            const std::vector<double>& statures) {
  if (shapes.empty() || shapes.size() != statures.size())
    throw std::invalid_argument(
        "shape statistics need at least one person, and one stature per person");
  for (const double stature : statures) checkStature(stature);
  const double people = double(shapes.size());
  ShapeStatistics out;
  for (size_t i = 0; i < shapes.size(); ++i) out.mean += shapes[i] / statures[i] / people;
  ShapeParameters variance = ShapeParameters::Zero();
  for (size_t i = 0; i < shapes.size(); ++i)
    variance.array() += (shapes[i] / statures[i] - out.mean).array().square() / people;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    if (isOffset(i))
      out.deviation[i] = out.mean[i] == 0 && variance[i] == 0
                             ? 0.0
                             : std::hypot(2.0 * std::sqrt(variance[i]), 0.002);
    else
      out.deviation[i] = out.mean[i] * (i < BodyLength::kCount ? 0.05 : 0.25);
  }
  return out;
}

ShapeParameters ShapeStatistics::meanShape(double stature) const {
  checkStature(stature);
  return stature * mean;
}

ShapeStatistics ShapeStatistics::fromYaml(const std::string& yaml, const std::string& where) {
  YAML::Node root;
  try {
    root = YAML::Load(yaml);
  } catch (const YAML::Exception& fault) {
    throw std::invalid_argument(where + " is not YAML: " + fault.msg);
  }
  if (!root.IsMap())
    throw std::invalid_argument(where + " must map names of shape parameters to two numbers");
  std::set<std::string> known;
  for (int i = 0; i < kShapeParameterCount; ++i) known.insert(shapeParameterName(i));
  std::set<std::string> seen;
  for (const auto& entry : root) {
    const std::string key = entry.first.as<std::string>("");
    if (!known.count(key))
      throw std::invalid_argument(where + " has the unknown shape parameter " + key);
    if (!seen.insert(key).second)
      throw std::invalid_argument(where + " gives twice the shape parameter " + key);
  }
  ShapeStatistics out;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    const YAML::Node node = root[shapeParameterName(i)];
    if (!node)
      throw std::invalid_argument(where + " lacks the shape parameter " + shapeParameterName(i));
    readSize(node, where, i, out);
  }
  return out;
}

std::string ShapeStatistics::text() const {
  std::string out = kMeaning;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    char line[128];
    std::snprintf(line, sizeof line, "%s: [%.5f, %.5f]\n", shapeParameterName(i).c_str(),
                  decimal(mean[i]) + 0.0, decimal(deviation[i]) + 0.0);
    out += line;
  }
  return out;
}

}  // namespace markerless_mocap
