#include <cmath>
#include <stdexcept>

#include "files/text_file.h"
#include "files/yaml_text.h"
#include "tools/calibrate_rig/find_boards.h"

namespace markerless_mocap {
namespace {

size_t cameraNamed(const std::string& name, const std::vector<CameraToCalibrate>& cameras,
                   const std::string& where) {
  for (size_t i = 0; i < cameras.size(); ++i)
    if (cameras[i].name == name) return i;
  throw std::invalid_argument(where + " names the camera " + name + ", of which there is no film");
}

/// Throws unless the node is a list of `count` finite numbers.
std::vector<double> numbersIn(const YAML::Node& node, size_t count, const std::string& what,
                              const std::string& allowed) {
  std::vector<double> numbers;
  bool good = node.IsDefined() && YAML::convert<std::vector<double>>::decode(node, numbers) &&
              numbers.size() == count;
  for (const double number : numbers) good = good && std::isfinite(number);
  if (!good)
    throw std::invalid_argument(what + " is missing or no list of finite numbers, allowed is " +
                                allowed);
  return numbers;
}

KnownPoint pointIn(const YAML::Node& node, const std::vector<CameraToCalibrate>& cameras,
                   const std::string& path) {
  KnownPoint point;
  if (!node.IsMap())
    throw std::invalid_argument(path +
                                ": a point is no map, allowed are the keys name, position, "
                                "pixels and sigma");
  point.name = node["name"] ? node["name"].as<std::string>() : "";
  const auto position = numbersIn(node["position"], 3, path + ": position of point " + point.name,
                                  "[x, y, z] in metres");
  point.position << position[0], position[1], position[2];
  if (node["sigma"]) {
    point.sigma = node["sigma"].as<double>();
    if (!(point.sigma > 0 && point.sigma < 1000))
      throw std::invalid_argument(path + ": sigma of point " + point.name +
                                  " is not between 0 and 1000 pixels");
  }
  for (const auto& entry : node["pixels"]) {
    const auto pixel =
        numbersIn(entry.second, 2, path + ": a pixel of point " + point.name, "CAMERA: [u, v]");
    point.pixels.emplace_back(cameraNamed(entry.first.as<std::string>(), cameras, path),
                              Eigen::Vector2d(pixel[0], pixel[1]));
  }
  return point;
}

}  // namespace

std::vector<KnownPoint> readKnownPoints(const std::string& path,
                                        const std::vector<CameraToCalibrate>& cameras) {
  const std::string text = readTextFile(path, "the points in " + path);
  std::vector<KnownPoint> points;
  try {
    for (const auto& node : yamlFrom(text, path)["points"])
      points.push_back(pointIn(node, cameras, path));
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(path + ": " + sentenceOf(error));
  }
  if (points.empty())
    throw std::invalid_argument(path +
                                " has no list `points` with a name, position and pixels each");
  return points;
}

}  // namespace markerless_mocap
