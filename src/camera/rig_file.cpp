#include "markerless_mocap/camera/rig_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "files/text_file.h"
#include "files/whole_file.h"
#include "files/yaml_map.h"
#include "files/yaml_text.h"
#include "text/joined.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

constexpr const char* kHead =
    "# A rig of calibrated cameras.\n"
    "# World: metres, z up, floor at z = 0. A camera's optical frame: x right, y down, z forward.\n"
    "# size: width and height, pixels. fx fy cx cy skew: pixels; integer coordinates are pixel\n"
    "# centres. distortion: OpenCV's k1 k2 p1 p2 [k3 [k4 k5 k6]], [] for none. lens: fisheye for\n"
    "# OpenCV's fisheye model, whose distortion is k1 k2 k3 k4; without it polynomial.\n"
    "# position and orientation: of the optical frame in the world, m and quaternion x y z w.\n"
    "# time_offset: s, added to the camera's stamps; without it 0.\n";

[[noreturn]] void throwError(const std::string& where, const std::string& what) {
  throw std::invalid_argument(where + ": " + what);
}

template <class Numbers>
std::string list(const Numbers& numbers) {
  return '[' + numbersText(numbers) + ']';
}

std::string quoted(const std::string& name) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << name;
  return out.c_str();
}

/// The rotation's quaternion with three components rounded to a grid of 1e-13; the largest
/// component is positive and completes them to length 1. The quaternion of its matrix differs by
/// less than the grid, so writing and reading again gives the same numbers.
Eigen::Quaterniond onGrid(const Eigen::Matrix3d& rotation) {
  constexpr double kSteps = 1e13;
  Eigen::Vector4d v =
      (Eigen::Quaterniond(rotation).normalized().coeffs() * kSteps).array().round() / kSteps;
  Eigen::Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  if (v[largest] < 0.0) v = -v;
  v[largest] = 0.0;
  v[largest] = std::sqrt(1.0 - v.squaredNorm());
  return Eigen::Quaterniond((v.array() + 0.0).matrix());  // no -0
}

std::string cameraText(const CameraCalibration& c) {
  const Eigen::Vector3d& t = c.T_world_camera.translation();
  const Eigen::Quaterniond q = onGrid(c.T_world_camera.linear());
  std::ostringstream out;
  out << "- name: " << quoted(c.name) << "\n  size: [" << c.width << ", " << c.height << "]\n";
  const std::pair<const char*, double> pinhole[] = {{"fx", c.K(0, 0)},
                                                    {"fy", c.K(1, 1)},
                                                    {"cx", c.K(0, 2)},
                                                    {"cy", c.K(1, 2)},
                                                    {"skew", c.K(0, 1)}};
  for (const auto& [key, value] : pinhole) out << "  " << key << ": " << numberText(value) << '\n';
  if (c.lens == LensType::kFisheye) out << "  lens: fisheye\n";
  out << "  distortion: " << list(c.D) << "\n  position: " << list(std::array{t.x(), t.y(), t.z()})
      << "\n  orientation: " << list(std::array{q.x(), q.y(), q.z(), q.w()}) << '\n';
  if (c.time_offset != 0.0) out << "  time_offset: " << numberText(c.time_offset) << '\n';
  return out.str();
}

int pixelsOf(double value, const YamlMap& camera) {
  if (!(value >= 1.0 && value <= 65536.0 && value == std::floor(value)))
    camera.fail("'size' holds " + numberText(value) +
                ", allowed are whole numbers from 1 to 65536");
  return int(value);
}

LensType lensIn(YamlMap& camera) {
  const YAML::Node node = camera.optional("lens");
  const std::string name = node ? node.as<std::string>("") : "polynomial";
  if (name != "polynomial" && name != "fisheye")
    camera.fail("'lens' is " + (name.empty() ? "no word" : name) +
                ", allowed are polynomial and fisheye");
  return name == "fisheye" ? LensType::kFisheye : LensType::kPolynomial;
}

Eigen::Quaterniond orientationIn(YamlMap& camera) {
  constexpr double kTolerance = 1e-3;  // for quaternions that are written with few digits
  const auto v = camera.numbers("orientation", 4, "a quaternion x y z w");
  const Eigen::Quaterniond q(v[3], v[0], v[1], v[2]);
  const double length = q.norm();
  if (!(std::abs(length - 1.0) <= kTolerance))
    camera.fail("'orientation' is a quaternion of length " + numberText(length) +
                ", allowed are rotations, whose length is 1");
  return q.normalized();
}

CameraCalibration cameraIn(const YAML::Node& node, size_t index, const std::string& where) {
  const std::string place = where + ", camera " + std::to_string(index);
  if (!node.IsMap()) throwError(place, "this is no map of keys to values");
  const YAML::Node name = node["name"];
  if (!name || !name.IsScalar() || name.Scalar().empty())
    throwError(place, "key 'name' is missing or empty, each camera needs a name");
  CameraCalibration c;
  c.name = name.Scalar();
  YamlMap camera(node, where + ", camera '" + c.name + "'");
  camera.required("name");
  const auto size = camera.numbers("size", 2, "width and height, pixels");
  c.width = pixelsOf(size[0], camera);
  c.height = pixelsOf(size[1], camera);
  // Read first: an exception inside of Eigen's comma initialiser ends in its assertion.
  const double fx = camera.number("fx"), s = camera.optional("skew") ? camera.number("skew") : 0.0;
  const double cx = camera.number("cx"), fy = camera.number("fy"), cy = camera.number("cy");
  c.K << fx, s, cx, 0, fy, cy, 0, 0, 1;
  c.D = camera.numbers("distortion");
  c.lens = lensIn(camera);
  const auto t = camera.numbers("position", 3, "x y z, m");
  c.T_world_camera.translation() << t[0], t[1], t[2];
  c.T_world_camera.linear() = orientationIn(camera).toRotationMatrix();
  if (camera.optional("time_offset")) c.time_offset = camera.number("time_offset");
  camera.finish();
  return c;
}

void checkRig(const std::vector<CameraCalibration>& rig, const std::string& where) {
  if (rig.empty())
    throwError(where, "the rig has no cameras, key 'cameras' must list at least one");
  std::set<std::string> names;
  for (const CameraCalibration& camera : rig) {
    if (camera.name.empty()) throwError(where, "a camera has no name");
    if (!names.insert(camera.name).second)
      throwError(where,
                 "two cameras are named '" + camera.name + "', each needs a name of its own");
    try {
      camera.validate();
    } catch (const std::invalid_argument& error) {
      throwError(where, error.what());
    }
  }
}

}  // namespace

std::string rigText(const std::vector<CameraCalibration>& rig) {
  checkRig(rig, "rig");
  std::string out = std::string(kHead) + "cameras:\n";
  for (const CameraCalibration& camera : rig) out += cameraText(camera);
  return out;
}

std::vector<CameraCalibration> rigFromText(const std::string& text, const std::string& where) {
  const YAML::Node root = yamlFrom(text, where);
  if (!root.IsMap())
    throwError(where, "the rig has no cameras, key 'cameras' must list at least one");
  YamlMap top(root, where);
  const YAML::Node cameras = top.optional("cameras");
  top.finish();
  if (!cameras || !cameras.IsSequence()) checkRig({}, where);
  std::vector<CameraCalibration> rig;
  for (size_t i = 0; i < cameras.size(); ++i) rig.push_back(cameraIn(cameras[i], i, where));
  checkRig(rig, where);
  return rig;
}

void writeRig(const std::string& path, const std::vector<CameraCalibration>& rig) {
  const std::string text = rigText(rig);
  writeWholeFile(path, text);
}

std::vector<CameraCalibration> readRig(const std::string& path) {
  return rigFromText(readTextFile(path, "the rig " + path), path);
}

std::vector<CameraCalibration> camerasNamed(const std::vector<std::string>& names,
                                            const std::vector<CameraCalibration>& rig,
                                            const std::string& where) {
  std::vector<CameraCalibration> chosen;
  std::string lacking;
  for (const std::string& name : names) {
    const auto found = std::find_if(rig.begin(), rig.end(), [&](const CameraCalibration& camera) {
      return camera.name == name;
    });
    if (found != rig.end())
      chosen.push_back(*found);
    else
      addWord(&lacking, name);
  }
  if (!lacking.empty())
    throwError(where, "the rig lacks " + lacking + ", its cameras are " +
                          joined(rig, [](const CameraCalibration& one) { return one.name; }));
  return chosen;
}

}  // namespace markerless_mocap
