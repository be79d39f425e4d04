#include "files/yaml_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "text/joined.h"

namespace markerless_mocap {
namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw std::invalid_argument(where + ": " + what);
}

}  // namespace

double finiteYamlNumber(const YAML::Node& node, const std::string& key, const std::string& where) {
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value))
    refuse(where, "'" + key + "' holds " +
                      (node.IsScalar() ? node.Scalar()
                       : node.IsNull() ? "nothing"
                                       : "a list or map") +
                      ", allowed are finite numbers");
  return value;
}

std::vector<double> finiteYamlNumbers(const YAML::Node& node, const std::string& key,
                                      const std::string& where) {
  if (!node.IsSequence()) refuse(where, "'" + key + "' is no list of numbers");
  std::vector<double> values;
  for (const auto& entry : node) values.push_back(finiteYamlNumber(entry, key, where));
  return values;
}

YamlMap::YamlMap(const YAML::Node& node, std::string where)
    : node_(node), where_(std::move(where)) {
  if (!node_.IsMap()) fail("this is no map of keys to values");
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) fail("this has a key that is no name");
    keys_.push_back(entry.first.Scalar());
    if (std::count(keys_.begin(), keys_.end(), keys_.back()) > 1)
      fail("key '" + keys_.back() + "' is repeated");
  }
}

YAML::Node YamlMap::optional(const std::string& key) {
  known_.insert(key);
  return node_[key];
}

YAML::Node YamlMap::required(const std::string& key) {
  const YAML::Node value = optional(key);
  if (!value) fail("key '" + key + "' is missing");
  return value;
}

YamlMap YamlMap::map(const std::string& key) {
  return YamlMap(required(key), where_ + ", " + key);
}

double YamlMap::number(const std::string& key) {
  return finiteYamlNumber(required(key), key, where_);
}

std::vector<double> YamlMap::numbers(const std::string& key) {
  return finiteYamlNumbers(required(key), key, where_);
}

std::vector<double> YamlMap::numbers(const std::string& key, size_t wanted, const char* meaning) {
  std::vector<double> values = numbers(key);
  if (values.size() != wanted)
    fail("'" + key + "' has " + std::to_string(values.size()) + " numbers, wanted are " +
         std::to_string(wanted) + ": " + meaning);
  return values;
}

void YamlMap::finish() const {
  for (const std::string& key : keys_)
    if (known_.count(key) == 0)
      fail("key '" + key + "' is unknown, allowed are " + joined({known_.begin(), known_.end()}));
}

void YamlMap::fail(const std::string& what) const {
  refuse(where_, what);
}

}  // namespace markerless_mocap
