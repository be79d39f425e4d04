#pragma once

#include <Eigen/Core>
#include <regex>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Reads plots back as a person does: where the axes' labels stand and what lies between them.

struct SvgRect {
  double x, y, width, height;
  std::string title;
};

inline std::string attributeOf(const std::string& tag, const std::string& name) {
  std::smatch match;
  return std::regex_search(tag, match, std::regex("[ <]" + name + "=\"([^\"]*)\"")) ? match[1].str()
                                                                                    : "";
}

inline std::vector<std::string> tagsOf(const std::string& svg, const std::string& kind) {
  std::vector<std::string> tags;
  const std::regex tag("<" + kind + "( [^>]*)>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it)
    tags.push_back(it->str());
  return tags;
}

inline std::vector<SvgRect> rectsOf(const std::string& svg) {
  std::vector<SvgRect> rects;
  const std::regex rect("(<rect [^>]*>)(<title>([^<]*)</title>)?");
  for (std::sregex_iterator it(svg.begin(), svg.end(), rect), end; it != end; ++it) {
    const std::string tag = (*it)[1];
    const auto value = [&](const char* name) { return std::stod(attributeOf(tag, name)); };
    rects.push_back({value("x"), value("y"), value("width"), value("height"), (*it)[3]});
  }
  return rects;
}

/// The strokes of a path of commands M, L and h, each the points that it joins.
using Strokes = std::vector<std::vector<Eigen::Vector2d>>;
inline Strokes strokesOf(const std::string& path) {
  Strokes strokes;
  const std::regex command("([MLh])([-0-9.e]+)(?:[ ,]([-0-9.e]+))?");
  for (std::sregex_iterator it(path.begin(), path.end(), command), end; it != end; ++it) {
    if ((*it)[1] == "h") continue;  // of no length, it makes a dot
    if ((*it)[1] == "M") strokes.emplace_back();
    strokes.back().push_back({std::stod((*it)[2]), std::stod((*it)[3])});
  }
  return strokes;
}

/// The strokes of the curves of a colour.
inline Strokes strokesOf(const std::string& svg, const std::string& color) {
  Strokes strokes;
  for (const std::string& tag : tagsOf(svg, "path"))
    if (attributeOf(tag, "stroke") == color)
      for (const auto& stroke : strokesOf(attributeOf(tag, "d"))) strokes.push_back(stroke);
  return strokes;
}

/// An axis, told by the first and last of its grid lines that have a number as label.
struct ReadAxis {
  double first_at = 0, first_value = 0, last_at = 0, last_value = 0;
  int labels = 0;
  double valueAt(double at) const {
    return first_value + (last_value - first_value) * (at - first_at) / (last_at - first_at);
  }
};

/// \param vertical the axis of values, whose grid lines are horizontal
inline ReadAxis axisOf(const std::string& svg, bool vertical) {
  ReadAxis axis;
  const std::regex labelled("(<path [^>]*>)<text [^>]*>([^<]*)</text>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), labelled), end; it != end; ++it) {
    const std::vector<Eigen::Vector2d> line = strokesOf(attributeOf((*it)[1], "d")).at(0);
    if ((line.front().y() == line.back().y()) != vertical) continue;
    axis.last_at = vertical ? line.front().y() : line.front().x();
    axis.last_value = std::stod((*it)[2]);
    if (axis.labels++ > 0) continue;
    axis.first_at = axis.last_at;
    axis.first_value = axis.last_value;
  }
  return axis;
}

/// What a plot's curves of a colour say: seconds and value of each point, by stroke.
inline Strokes dataOf(const std::string& svg, const std::string& color) {
  const ReadAxis seconds = axisOf(svg, false), values = axisOf(svg, true);
  Strokes data = strokesOf(svg, color);
  for (auto& stroke : data)
    for (Eigen::Vector2d& point : stroke)
      point = {seconds.valueAt(point.x()), values.valueAt(point.y())};
  return data;
}

}  // namespace markerless_mocap
