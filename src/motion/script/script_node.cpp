#include "motion/script/script_node.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "text/joined.h"

namespace markerless_mocap {
namespace {

std::string shown(const YAML::Node& node) {
  if (!node || node.IsNull()) return "empty";
  YAML::Emitter out;
  out.SetSeqFormat(YAML::Flow);
  out.SetMapFormat(YAML::Flow);
  out << node;
  const std::string text = out.c_str();
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

/// The number of a node; NaN if it is none.
double numberOrNan(const YAML::Node& node) {
  double value = std::nan("");
  if (node.IsScalar() && YAML::convert<double>::decode(node, value)) return value;
  return std::nan("");
}

}  // namespace

std::string formatNumber(double number) {
  std::ostringstream out;
  out << number;
  return out.str();
}

ScriptNode::ScriptNode(const YAML::Node& node, std::string address)
    : node_(node), address_(std::move(address)) {}

void ScriptNode::fail(const std::string& allowed) const {
  throw std::invalid_argument(address_ + " is " + shown(node_) + ", allowed is " + allowed);
}

void ScriptNode::allowKeys(const std::vector<std::string>& keys) const {
  for (const std::string& key : this->keys())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw std::invalid_argument(address_ + " has the unknown key " + key + ", allowed are " +
                                  joined(keys));
}

bool ScriptNode::has(const std::string& key) const {
  return node_.IsMap() && node_[key].IsDefined();
}

ScriptNode ScriptNode::need(const std::string& key) const {
  if (!node_.IsMap()) fail("a map with " + key);
  if (!has(key)) throw std::invalid_argument(address_ + " misses the key " + key);
  return {node_[key], address_ + "/" + key};
}

std::vector<ScriptNode> ScriptNode::items() const {
  if (!node_.IsSequence()) fail("a list");
  std::vector<ScriptNode> found;
  for (size_t i = 0; i < node_.size(); ++i)
    found.emplace_back(node_[i], address_ + "[" + std::to_string(i) + "]");
  return found;
}

std::vector<std::string> ScriptNode::keys() const {
  if (!node_.IsMap()) fail("a map");
  std::vector<std::string> found;
  for (const auto& entry : node_) {
    found.push_back(entry.first.IsScalar() ? entry.first.Scalar() : shown(entry.first));
    if (std::count(found.begin(), found.end(), found.back()) > 1)
      throw std::invalid_argument(address_ + " has the key " + found.back() +
                                  " twice, allowed is once");
  }
  return found;
}

double ScriptNode::number(double minimum, double maximum) const {
  const double value = numberOrNan(node_);
  if (!(value >= minimum && value <= maximum))
    fail("a number from " + formatNumber(minimum) + " to " + formatNumber(maximum));
  return value;
}

double ScriptNode::number(const std::string& key, double otherwise, double minimum,
                          double maximum) const {
  return has(key) ? need(key).number(minimum, maximum) : otherwise;
}

int ScriptNode::whole(const std::string& key, int otherwise, int minimum, int maximum) const {
  if (!has(key)) return otherwise;
  const ScriptNode node = need(key);
  const double value = numberOrNan(node.node_);
  if (!(value >= minimum && value <= maximum && value == std::floor(value)))
    node.fail("a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum));
  return int(value);
}

bool ScriptNode::flag(const std::string& key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const ScriptNode node = need(key);
  bool value = false;
  if (!node.node_.IsScalar() || !YAML::convert<bool>::decode(node.node_, value))
    node.fail("true or false");
  return value;
}

std::string ScriptNode::word(const std::vector<std::string>& allowed) const {
  if (!node_.IsScalar() ||
      std::find(allowed.begin(), allowed.end(), node_.Scalar()) == allowed.end())
    fail("one of " + joined(allowed));
  return node_.Scalar();
}

std::vector<double> ScriptNode::numbers(size_t count, const std::string& meaning) const {
  const std::string allowed = std::to_string(count) + " numbers: " + meaning;
  if (!node_.IsSequence() || node_.size() != count) fail(allowed);
  std::vector<double> found;
  for (const YAML::Node& item : node_) {
    found.push_back(numberOrNan(item));
    if (!std::isfinite(found.back())) fail(allowed);
  }
  return found;
}

}  // namespace markerless_mocap
