#include "tools/common/film_times.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "files/text_file.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

std::vector<std::string> cellsOf(std::string line) {
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

size_t columnAmong(const std::vector<std::string>& head, const std::vector<std::string>& names,
                   const std::string& path) {
  for (const std::string& name : names) {
    const auto found = std::find(head.begin(), head.end(), name);
    if (found != head.end()) return size_t(found - head.begin());
  }
  throw std::invalid_argument(path + ": there is no column " + names.front() +
                              " in the head line, wanted are cam_id and frame_time");
}

double secondsIn(const std::string& cell, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0' || !std::isfinite(value))
    throw std::invalid_argument(where + ": frame_time is '" + cell + "', allowed are seconds");
  return value;
}

/// The last digits of a name as a number.
std::optional<long> numberOf(const std::string& name) {
  const size_t last = name.find_last_of("0123456789");
  if (last == std::string::npos) return std::nullopt;
  size_t first = last;
  while (first > 0 && std::isdigit(static_cast<unsigned char>(name[first - 1]))) --first;
  return std::strtol(name.substr(first, last + 1 - first).c_str(), nullptr, 10);
}

bool haveOneNumber(const std::string& a, const std::string& b) {
  return numberOf(a) && numberOf(a) == numberOf(b);
}

/// By the names of the cameras in the table.
FrameTimes timesOfCameras(const std::string& path) {
  checkRegularFile(path, path, kMaxTableBytes);
  std::ifstream file(path);
  std::string line;
  if (!file) throw std::runtime_error("cannot read " + path + ": this user may not");
  if (!std::getline(file, line))
    throw std::runtime_error(path + " is empty, wanted is a head line with cam_id and frame_time");
  const auto head = cellsOf(line);
  const size_t camera = columnAmong(head, {"cam_id", "port", "camera"}, path);
  const size_t time = columnAmong(head, {"frame_time"}, path);
  FrameTimes times;
  for (int number = 2; std::getline(file, line); ++number) {
    const auto cells = cellsOf(line);
    if (cells.empty()) continue;
    const std::string where = path + ", line " + std::to_string(number);
    if (cells.size() <= std::max(camera, time))
      throw std::invalid_argument(where + ": there are " + std::to_string(cells.size()) +
                                  " cells, the head line has " + std::to_string(head.size()));
    times[cells[camera]].push_back(secondsIn(cells[time], where));
  }
  for (auto& entry : times) std::sort(entry.second.begin(), entry.second.end());
  return times;
}

}  // namespace

FrameTimes readFrameTimes(const std::string& path, const std::vector<std::string>& films) {
  const FrameTimes of_cameras = timesOfCameras(path);
  std::vector<std::string> cameras;
  for (const auto& entry : of_cameras) cameras.push_back(entry.first);
  const std::vector<std::string> matched = matchNames(films, cameras, "camera of " + path);
  FrameTimes times;
  for (size_t i = 0; i < films.size(); ++i) times[films[i]] = of_cameras.at(matched[i]);
  return times;
}

std::vector<std::string> matchNames(const std::vector<std::string>& wanted,
                                    const std::vector<std::string>& names,
                                    const std::string& what) {
  std::vector<std::string> matched;
  for (const std::string& name : wanted) {
    std::vector<std::string> found;
    for (const std::string& other : names)
      if (other == name) found = {other};
    if (found.empty())
      for (const std::string& other : names)
        if (haveOneNumber(name, other)) found.push_back(other);
    if (found.size() != 1)
      throw std::invalid_argument((found.empty() ? "no " : "more than one ") + what +
                                  " is called like the film " + name + ", there are " +
                                  joined(names) + " and the films " + joined(wanted));
    if (std::find(matched.begin(), matched.end(), found[0]) != matched.end())
      throw std::invalid_argument("two films belong to the " + what + " " + found[0] +
                                  ", the films are " + joined(wanted));
    matched.push_back(found[0]);
  }
  return matched;
}

bool isCalledLikeOne(const std::string& name, const std::vector<std::string>& others) {
  return std::any_of(others.begin(), others.end(), [&](const std::string& other) {
    return other == name || haveOneNumber(name, other);
  });
}

std::string fileBesideFilms(const std::vector<std::string>& inputs,
                            const std::vector<std::string>& names) {
  namespace fs = std::filesystem;
  for (const std::string& input : inputs)
    for (const std::string& name : names)
      if (const fs::path file = fs::path(input) / name; fs::is_regular_file(file))
        return file.string();
  return "";
}

}  // namespace markerless_mocap
