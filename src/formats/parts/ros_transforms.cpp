#include "formats/parts/ros_transforms.h"

#include <tinyxml2.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "files/xml_text.h"
#include "files/yaml_map.h"
#include "files/yaml_text.h"
#include "formats/parts/camera_parts.h"
#include "formats/parts/yaml_parts.h"
#include "formats/ros_texts.h"
#include "text/joined.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

using tinyxml2::XMLElement;

std::string withoutSlash(const std::string& frame) {
  return !frame.empty() && frame[0] == '/' ? frame.substr(1) : frame;
}

std::string attribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

void forEachPublisher(const XMLElement& element,
                      const std::function<void(const XMLElement&)>& call) {
  for (const XMLElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
    if (std::string(e->Name()) == "node" && attribute(*e, "type") == "static_transform_publisher")
      call(*e);
    forEachPublisher(*e, call);
  }
}

bool isLaunch(const std::string& text) {
  return text.find("<launch") != std::string::npos &&
         text.find("static_transform_publisher") != std::string::npos;
}

Eigen::Quaterniond unitQuaternion(double x, double y, double z, double w,
                                  const std::string& where) {
  const Eigen::Quaterniond q(w, x, y, z);
  if (!(std::abs(q.norm() - 1.0) < 1e-2))
    throwFormatError(where, "a quaternion has length " + numberText(q.norm()) + ", allowed is 1");
  return q.normalized();
}

/// x y z and yaw pitch roll, or x y z and a quaternion x y z w.
Eigen::Isometry3d transformFrom(const std::vector<double>& v, const std::string& where) {
  Eigen::Isometry3d T(Eigen::Translation3d(v[0], v[1], v[2]));
  if (v.size() == 7)
    T.linear() = unitQuaternion(v[3], v[4], v[5], v[6], where).toRotationMatrix();
  else
    T.linear() = (Eigen::AngleAxisd(v[3], Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(v[4], Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(v[5], Eigen::Vector3d::UnitX()))
                     .toRotationMatrix();
  return T;
}

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// Calls `call` with every map that is a transform of a child frame.
void forEachTransform(const YAML::Node& node, const std::function<void(const YAML::Node&)>& call) {
  if (node.IsMap() && node["child_frame_id"] && node["transform"]) return call(node);
  if (node.IsMap())
    for (const auto& entry : node) forEachTransform(entry.second, call);
  else if (node.IsSequence())
    for (const YAML::Node& entry : node) forEachTransform(entry, call);
}

std::vector<double> fieldsOf(const YAML::Node& map, const std::vector<const char*>& keys,
                             const std::string& where) {
  std::vector<double> values;
  for (const char* key : keys)
    values.push_back(finiteYamlNumber(yamlRequired(map, key, where), key, where));
  return values;
}

}  // namespace

bool holdsTransforms(const std::string& text) {
  return isLaunch(text) || (text.find("child_frame_id") != std::string::npos && yamlMap(text));
}

void StaticTransforms::add(const TextFile& file) {
  isLaunch(file.text) ? addLaunch(file) : addYaml(file);
}

void StaticTransforms::addLink(const std::string& parent, const std::string& child,
                               const Eigen::Isometry3d& T, const std::string& where) {
  const auto [known, is_new] = links_.emplace(withoutSlash(child), Link{withoutSlash(parent), T});
  if (!is_new && (known->second.parent != withoutSlash(parent) ||
                  !known->second.T_parent_child.isApprox(T, 1e-9)))
    throwFormatError(where, "frame " + child + " has two different transforms");
}

void StaticTransforms::addLaunch(const TextFile& file) {
  tinyxml2::XMLDocument document;
  readXml(file.text, file.path, &document);
  forEachPublisher(*document.RootElement(), [&](const XMLElement& node) {
    const std::string where = file.path + ", line " + std::to_string(node.GetLineNum());
    std::vector<std::string> words = wordsOf(attribute(node, "args"));
    if (attribute(node, "pkg") == "tf" && !words.empty()) words.pop_back();  // the period
    if (words.size() != 8 && words.size() != 9)
      throwFormatError(where,
                       "static_transform_publisher has the args '" + attribute(node, "args") +
                           "', allowed are x y z yaw pitch roll or x y z qx qy qz qw, and the "
                           "parent and child frame");
    std::string numbers;
    for (size_t i = 0; i + 2 < words.size(); ++i) numbers += words[i] + ' ';
    const std::vector<double> values = numbersIn(numbers);
    if (values.size() + 2 != words.size())
      throwFormatError(where, "'" + numbers + "' has words that are no numbers");
    addLink(words[words.size() - 2], words.back(), transformFrom(values, where), where);
  });
}

void StaticTransforms::addYaml(const TextFile& file) {
  for (const YAML::Node& document : yamlDocumentsFrom(file.text, file.path))
    forEachTransform(document, [&](const YAML::Node& node) {
      const std::string child = node["child_frame_id"].as<std::string>("");
      const std::string where = file.path + ", frame " + child;
      const YAML::Node header = yamlRequired(node, "header", where);
      const YAML::Node T = node["transform"];
      auto v = fieldsOf(yamlRequired(T, "translation", where), {"x", "y", "z"}, where);
      const auto q = fieldsOf(yamlRequired(T, "rotation", where), {"x", "y", "z", "w"}, where);
      v.insert(v.end(), q.begin(), q.end());
      addLink(yamlRequired(header, "frame_id", where).as<std::string>(""), child,
              transformFrom(v, where), where);
    });
}

std::string StaticTransforms::frameOfCamera(const std::string& camera, const std::string& where,
                                            std::vector<std::string>* remarks) const {
  std::string name = withoutSlash(camera);
  for (const char* ending : {"_optical_frame", "_optical"})
    if (links_.count(name + ending) > 0) return name + ending;
  if (links_.count(name) > 0) {
    remarks->push_back("frame " + name + " is taken as the optical frame (z forward) of camera " +
                       name);
    return name;
  }
  std::string known;
  for (const auto& [child, link] : links_) addWord(&known, child);
  throwFormatError(where, "no static transform leads to frame " + name + "_optical, " +
                              (known.empty() ? "give the launch file or YAML of tf_static, too"
                                             : "the frames are " + known));
}

Eigen::Isometry3d StaticTransforms::poseOfCamera(const std::string& camera,
                                                 const std::string& where,
                                                 std::vector<std::string>* remarks) {
  std::string frame = frameOfCamera(camera, where, remarks);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (size_t steps = 0; links_.count(frame) > 0; ++steps) {
    if (steps > links_.size()) throwFormatError(where, "the transforms go round in a ring");
    T = links_[frame].T_parent_child * T;
    frame = links_[frame].parent;
  }
  if (root_.empty()) root_ = frame;
  if (root_ != frame)
    throwFormatError(where, "camera " + camera + " stands in frame " + frame +
                                ", the cameras before it in " + root_);
  return T;
}

std::string transformsLaunchText(const std::vector<CameraCalibration>& rig,
                                 const std::string& world_frame) {
  tinyxml2::XMLPrinter out;
  out.PushComment(
      " Where the cameras stand: world to optical frame; x y z (m), quaternion x y z w. ");
  out.OpenElement("launch");
  for (const CameraCalibration& camera : rig) {
    const Eigen::Vector3d& t = camera.T_world_camera.translation();
    const Eigen::Quaterniond q(camera.T_world_camera.linear());
    std::string name = fileNameOf(camera);
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    std::string args;
    for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
      args += numberText(value) + ' ';
    out.OpenElement("node");
    out.PushAttribute("pkg", "tf2_ros");
    out.PushAttribute("type", "static_transform_publisher");
    out.PushAttribute("name", (name + "_pose").c_str());
    out.PushAttribute("args", (args + world_frame + ' ' + camera.name + "_optical").c_str());
    out.CloseElement();
  }
  out.CloseElement();
  return out.CStr();
}

}  // namespace markerless_mocap
