#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "files/text_file.h"
#include "tools/calibrate_rig/find_boards.h"

namespace markerless_mocap {
namespace {

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    while (!cell.empty() && isspace(cell.back())) cell.pop_back();
    cells.push_back(cell);
  }
  return cells;
}

size_t columnNamed(const std::vector<std::string>& head, const std::string& name,
                   const std::string& path) {
  const auto found = std::find(head.begin(), head.end(), name);
  if (found == head.end()) throw std::runtime_error(path + " has no column " + name);
  return size_t(found - head.begin());
}

/// Whether a camera's name is the id or ends with it after something that is no digit.
bool isNamedBy(const std::string& camera, const std::string& id) {
  if (camera == id) return true;
  if (camera.size() <= id.size() || isdigit(camera[camera.size() - id.size() - 1])) return false;
  return camera.compare(camera.size() - id.size(), id.size(), id) == 0;
}

double secondsIn(const std::string& cell, const std::string& path, int line) {
  try {
    size_t end = 0;
    const double seconds = std::stod(cell, &end);
    if (end == cell.size() && std::isfinite(seconds)) return seconds;
  } catch (const std::logic_error&) {
    // Reported below.
  }
  throw std::runtime_error(path + ", line " + std::to_string(line) + ": '" + cell +
                           "' is no time in seconds");
}

size_t cameraNamed(const std::string& name, const std::vector<CameraToCalibrate>& cameras,
                   const std::string& where) {
  for (size_t i = 0; i < cameras.size(); ++i)
    if (cameras[i].name == name) return i;
  throw std::invalid_argument(where + " names the camera " + name + ", of which there is no film");
}

KnownPoint pointIn(const YAML::Node& node, const std::vector<CameraToCalibrate>& cameras,
                   const std::string& path) {
  KnownPoint point;
  point.name = node["name"] ? node["name"].as<std::string>() : "";
  const auto position = node["position"].as<std::vector<double>>();
  if (position.size() != 3)
    throw std::invalid_argument(path + ": position of point " + point.name + " is not x, y, z");
  point.position << position[0], position[1], position[2];
  if (node["sigma"]) {
    point.sigma = node["sigma"].as<double>();
    if (!(point.sigma > 0 && point.sigma < 1000))
      throw std::invalid_argument(path + ": sigma of point " + point.name +
                                  " is not between 0 and 1000 pixels");
  }
  for (const auto& entry : node["pixels"]) {
    const auto pixel = entry.second.as<std::vector<double>>();
    if (pixel.size() != 2)
      throw std::invalid_argument(path + ": a pixel of point " + point.name + " is not u, v");
    point.pixels.emplace_back(cameraNamed(entry.first.as<std::string>(), cameras, path),
                              Eigen::Vector2d(pixel[0], pixel[1]));
  }
  return point;
}

}  // namespace

FrameTimes readFrameTimes(const std::string& path, const std::vector<FilmSource>& films) {
  checkRegularFile(path, "the times in " + path, kMaxTableBytes);
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error("cannot read the times in " + path);
  const std::vector<std::string> head = cellsOf(line);
  const size_t id_at = columnNamed(head, "cam_id", path);
  const size_t time_at = columnNamed(head, "frame_time", path);
  FrameTimes times;
  for (int number = 2; std::getline(file, line); ++number) {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() <= std::max(id_at, time_at) || cells[time_at].empty()) continue;
    for (const FilmSource& film : films)
      if (isNamedBy(film.camera, cells[id_at]))
        times[film.camera].push_back(secondsIn(cells[time_at], path, number));
  }
  for (const FilmSource& film : films)
    if (times.count(film.camera) == 0)
      throw std::runtime_error(path + " has no times of " + film.camera);
  for (auto& [camera, own] : times) std::sort(own.begin(), own.end());
  return times;
}

std::vector<KnownPoint> readKnownPoints(const std::string& path,
                                        const std::vector<CameraToCalibrate>& cameras) {
  const std::string text = readTextFile(path, "the points in " + path);
  std::vector<KnownPoint> points;
  try {
    for (const auto& node : YAML::Load(text)["points"])
      points.push_back(pointIn(node, cameras, path));
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
  if (points.empty()) throw std::invalid_argument(path + " has no list `points`");
  return points;
}

}  // namespace markerless_mocap
