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
    "# The body that silhouettes are fitted with: round cones about a skeleton. Every size is\n"
    "# [mean, standard deviation over people] as a share of the stature; deviation 0: never\n"
    "# estimated. Lengths are between joints, as the URDF has them. A cone's end a is the one\n"
    "# nearer to the hips (arms: to the shoulder); its offset is from where the lengths alone "
    "would\n"
    "# put it, in the frame of its segment: x forward, y to the left, z up while standing with\n"
    "# hanging arms, of the left side; the right side mirrors it.\n";

void checkStature(double stature) {
  if (!(stature >= 0.5 && stature <= 2.5))
    throw std::invalid_argument("stature is " + std::to_string(stature) +
                                " m, allowed is 0.5 to 2.5 m");
}

double decimal(double value) {
  return std::round(value * 1e5) * 1e-5;
}

/// Mean and deviation under one key.
void readSize(const YAML::Node& node, const std::string& where, int size, ShapeStatistics& out) {
  const std::string name = where + ": size " + shapeParameterName(size);
  const auto number = [&](size_t i) {
    double value = NAN;
    if (!node.IsSequence() || node.size() != 2 || !YAML::convert<double>::decode(node[i], value) ||
        !std::isfinite(value))
      throw std::invalid_argument(name + " must be two numbers, mean and standard deviation");
    return value;
  };
  out.mean[size] = number(0);
  out.deviation[size] = number(1);
  if (!isOffset(size) && !(out.mean[size] > 0))
    throw std::invalid_argument(name + " must be positive");
  if (out.deviation[size] < 0)
    throw std::invalid_argument(name + " must have a deviation of at least 0");
}

}  // namespace

const std::string& shapeParameterName(int size) {
  static const std::array<std::string, kShapeParameterCount> names = [] {
    std::array<std::string, kShapeParameterCount> out;
    for (size_t i = 0; i < ContourLength::kCount; ++i) out[i] = kLengthNames[i];
    for (int kind = 0; kind < ContourCone::kCount; ++kind)
      for (int end = 0; end < 2; ++end)
        for (int value = 0; value < kValuesPerEnd; ++value)
          out[size_t(radiusIndex(kind, end) + value)] =
              std::string(kConeNames[kind]) + "_cone/" + (end ? "b/" : "a/") + kValueNames[value];
    return out;
  }();
  return names.at(size_t(size));
}

bool isOffset(int size) {
  return size >= ContourLength::kCount && (size - ContourLength::kCount) % kValuesPerEnd != 0;
}

BodyProportions proportionsOf(const ShapeParameters& sizes) {
  BodyProportions p;
  p.torso = sizes[ContourLength::kTorso];
  p.neck = sizes[ContourLength::kNeck];
  p.head = sizes[ContourLength::kHead];
  p.upper_arm = sizes[ContourLength::kUpperArm];
  p.forearm = sizes[ContourLength::kForearm];
  p.hand = sizes[ContourLength::kHand];
  p.thigh = sizes[ContourLength::kThigh];
  p.shank = sizes[ContourLength::kShank];
  p.foot = sizes[ContourLength::kFoot];
  p.ankle_height = sizes[ContourLength::kAnkleHeight];
  p.shoulder_width = sizes[ContourLength::kShoulderWidth];
  p.hip_width = sizes[ContourLength::kHipWidth];
  // The URDF's radii of these ends at girth 1: urdf/human.urdf.in.
  p.girth = (sizes[radiusIndex(ContourCone::kChest, 1)] / 0.109 +
             sizes[radiusIndex(ContourCone::kThigh, 0)] / 0.087 +
             sizes[radiusIndex(ContourCone::kCalf, 0)] / 0.057 +
             sizes[radiusIndex(ContourCone::kUpperArm, 1)] / 0.045) /
            4;
  return p;
}

ShapeStatistics ShapeStatistics::handMade() {
  // Ends of radii at a stature of 1.75 m, as drawn in urdf/human.urdf.in; halves of trunk and
  // pelvis stand side by side.
  constexpr double kRadii[ContourCone::kCount][2] = {
      {0.106, 0.106}, {0.104, 0.109}, {0.058, 0.058}, {0.056, 0.056},
      {0.075, 0.080}, {0.054, 0.045}, {0.042, 0.032}, {0.032, 0.026},
      {0.087, 0.058}, {0.055, 0.055}, {0.052, 0.042}, {0.040, 0.036}};
  constexpr double kDrawn = 1.75, kPelvisSide = 0.073, kChestSide = 0.075;
  const BodyProportions p = BodyProportions::fromStature(1.0);
  ShapeStatistics made;
  made.mean.head<ContourLength::kCount>() << p.torso, p.neck, p.head, p.upper_arm, p.forearm,
      p.hand, p.thigh, p.shank, p.foot, p.ankle_height, p.shoulder_width, p.hip_width;
  for (int kind = 0; kind < ContourCone::kCount; ++kind)
    for (int end = 0; end < 2; ++end) {
      made.mean[radiusIndex(kind, end)] = kRadii[kind][end] / kDrawn;
      if (kind == ContourCone::kPelvis || kind == ContourCone::kChest)
        made.mean[offsetIndex(kind, end) + 1] =
            (kind == ContourCone::kPelvis ? kPelvisSide : kChestSide) / kDrawn;
    }
  for (int i = 0; i < kShapeParameterCount; ++i)
    made.deviation[i] =
        isOffset(i) ? 0.0 : made.mean[i] * (i < ContourLength::kCount ? 0.06 : 0.25);
  return made;
}

ShapeStatistics ShapeStatistics::fromPeople(const std::vector<ShapeParameters>& sizes,
                                            const std::vector<double>& statures) {
  if (sizes.empty() || sizes.size() != statures.size())
    throw std::invalid_argument("a template needs at least one person and each one's stature");
  for (const double stature : statures) checkStature(stature);
  const double people = double(sizes.size());
  ShapeStatistics out;
  for (size_t i = 0; i < sizes.size(); ++i) out.mean += sizes[i] / statures[i] / people;
  ShapeParameters variance = ShapeParameters::Zero();
  for (size_t i = 0; i < sizes.size(); ++i)
    variance.array() += (sizes[i] / statures[i] - out.mean).array().square() / people;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    if (isOffset(i))
      out.deviation[i] = out.mean[i] == 0 && variance[i] == 0
                             ? 0.0
                             : std::hypot(2.0 * std::sqrt(variance[i]), 0.002);
    else
      out.deviation[i] = out.mean[i] * (i < ContourLength::kCount ? 0.05 : 0.25);
  }
  return out;
}

ShapeParameters ShapeStatistics::sizes(double stature) const {
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
  if (!root.IsMap()) throw std::invalid_argument(where + " must map names of sizes to two numbers");
  std::set<std::string> known;
  for (int i = 0; i < kShapeParameterCount; ++i) known.insert(shapeParameterName(i));
  std::set<std::string> seen;
  for (const auto& entry : root) {
    const std::string key = entry.first.as<std::string>("");
    if (!known.count(key)) throw std::invalid_argument(where + " has the unknown size " + key);
    if (!seen.insert(key).second) throw std::invalid_argument(where + " has two sizes " + key);
  }
  ShapeStatistics out;
  for (int i = 0; i < kShapeParameterCount; ++i) {
    const YAML::Node node = root[shapeParameterName(i)];
    if (!node) throw std::invalid_argument(where + " lacks the size " + shapeParameterName(i));
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
