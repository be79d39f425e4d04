#include "tools/evaluate/marks_file.h"

#include <stdexcept>

#include "evaluation/body_points.h"
#include "files/text_file.h"
#include "files/yaml_map.h"
#include "files/yaml_text.h"

namespace markerless_mocap {
namespace {

void addCamera(const std::string& camera, YamlMap* marks, MarkedFrame* frame) {
  for (const std::string& name : bodyPointNames()) {
    if (!marks->optional(name)) continue;
    const std::vector<double> pixel = marks->numbers(name, 2, "[u, v] in pixels");
    frame->points[name][camera] = {pixel[0], pixel[1]};
  }
  marks->finish();
}

MarkedFrame frameOf(const YAML::Node& node, const std::string& where) {
  YamlMap map(node, where);
  MarkedFrame frame;
  frame.time_s = map.number("time");
  YamlMap cameras = map.map("marks");
  for (const std::string& name : cameras.keys()) {
    YamlMap marks = cameras.map(name);
    addCamera(name, &marks, &frame);
  }
  map.finish();
  return frame;
}

MarksFile marksOf(const YAML::Node& root, const std::string& path) {
  YamlMap map(root, path);
  MarksFile marks;
  if (map.optional("start")) marks.start_s = map.number("start");
  if (map.optional("sigma_px")) marks.sigma_px = map.number("sigma_px");
  if (marks.sigma_px <= 0.0) map.fail("sigma_px is not above 0");
  const YAML::Node frames = map.optional("frames");
  map.finish();
  if (!frames || !frames.IsSequence() || frames.size() == 0) map.fail("this has no frames");
  for (size_t f = 0; f < frames.size(); ++f) {
    const std::string where = path + ", frame " + std::to_string(f + 1);
    marks.frames.push_back(frameOf(frames[f], where));
    if (f > 0 && marks.frames[f].time_s <= marks.frames[f - 1].time_s)
      throw std::invalid_argument(where + ": its time is not after the one before");
  }
  return marks;
}

}  // namespace

MarksFile readMarks(const std::string& path) {
  const std::string text = readTextFile(path, "the marks " + path);
  return marksOf(yamlFrom(text, path), path);
}

}  // namespace markerless_mocap
