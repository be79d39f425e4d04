#include "exports/point_names.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "evaluation/body_points.h"
#include "exports/names/name_sets.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

bool contains(const std::string& text, const char* word) {
  return text.find(word) != std::string::npos;
}

/// Links of bodyPointNames(), and those of the points that are beside them here.
std::string linkName(const std::string& point) {
  if (point == "pelvis") return "body";
  if (point == "waist") return "r_waist";
  if (point == "thorax") return "p_head";
  if (contains(point, "clavicle")) return point.substr(0, 2) + "r_clavicle";
  if (contains(point, "hand")) return point.substr(0, 2) + "wrist";
  if (contains(point, "foot")) return point.substr(0, 2) + "ankle";
  return point == "head_top" ? "head" : point;
}

Eigen::Vector3d placeOf(const std::string& point, const BodyModel& body, const PersonFrame& frame,
                        const Eigen::Matrix3Xd& body_points) {
  static const std::vector<std::string> names = bodyPointNames();
  const auto found = std::find(names.begin(), names.end(), point);
  if (found != names.end()) return body_points.col(found - names.begin());
  if (point.empty()) return Eigen::Vector3d::Constant(NAN);
  return frame.T_world_link[size_t(body.linkIndex(linkName(point)))].translation();
}

}  // namespace

const std::vector<std::string>& nameSets() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const NameSet& set : allNameSets()) out.push_back(set.name);
    return out;
  }();
  return names;
}

const std::vector<NamedPoint>& pointNames(const std::string& set) {
  for (const NameSet& known : allNameSets())
    if (known.name == set) return known.points;
  throw std::invalid_argument("there are no names " + set + ", allowed are " + joined(nameSets()));
}

std::vector<NamedPoint> choosePoints(const std::string& set,
                                     const std::vector<std::string>& names) {
  const std::vector<NamedPoint>& points = pointNames(set);
  std::vector<std::string> known;
  for (const NamedPoint& point : points) known.push_back(point.name);
  std::vector<NamedPoint> chosen;
  for (const std::string& name : names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      throw std::invalid_argument("there is no joint " + name + ", allowed are " + joined(known));
    chosen.push_back(points[size_t(found - known.begin())]);
  }
  return chosen;
}

std::string nameOfPoint(const std::string& set, const std::string& point) {
  for (const std::string& names : {set, std::string("motionbuilder")})
    for (const NamedPoint& known : pointNames(names))
      if (known.point == point && known.towards.empty()) return known.name;
  throw std::invalid_argument("there is no point " + point);
}

Eigen::Matrix3Xd placesOf(const std::vector<NamedPoint>& points, const BodyModel& body,
                          const PersonFrame& frame) {
  const Eigen::Matrix3Xd body_points = bodyPoints(body, frame.T_world_link);
  Eigen::Matrix3Xd places(3, points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d from = placeOf(points[i].point, body, frame, body_points);
    places.col(Eigen::Index(i)) = from;
    if (points[i].towards.empty()) continue;
    const Eigen::Vector3d to = placeOf(points[i].towards, body, frame, body_points);
    places.col(Eigen::Index(i)) = from + points[i].fraction * (to - from);
  }
  return places;
}

int linkOf(const NamedPoint& point, const BodyModel& body) {
  const std::string& last = point.towards.empty() ? point.point : point.towards;
  return last.empty() ? -1 : body.linkIndex(linkName(last));
}

double expectedError(const NamedPoint& point, const PersonFrame& frame) {
  const std::string& last = point.towards.empty() ? point.point : point.towards;
  if (last.empty()) return NAN;
  size_t part = 0;
  if (contains(last, "head")) part = 1;
  for (const char* word : {"clavicle", "shoulder", "elbow", "wrist", "hand"})
    if (contains(last, word)) part = 2;
  for (const char* word : {"hip", "knee", "ankle", "foot"})
    if (contains(last, word)) part = 4;
  if (part >= 2 && last[0] == 'r') ++part;
  return frame.part_sigma_m[part];
}

}  // namespace markerless_mocap
