#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace markerless_mocap {

/// A node of a YAML file with its address, "file/key[2]/key". All functions throw
/// std::invalid_argument with the address, the value and the allowed values if the node is not as
/// required.
class ScriptNode {
 public:
  ScriptNode(const YAML::Node& node, std::string address);

  /// Requires a map with no other keys than these.
  void allowKeys(const std::vector<std::string>& keys) const;
  bool has(const std::string& key) const;
  /// The value of a required key.
  ScriptNode need(const std::string& key) const;
  /// The entries of a list.
  std::vector<ScriptNode> items() const;
  /// Keys of a map in the order of the file.
  std::vector<std::string> keys() const;

  double number(double minimum, double maximum) const;
  double number(const std::string& key, double otherwise, double minimum, double maximum) const;
  int whole(const std::string& key, int otherwise, int minimum, int maximum) const;
  bool flag(const std::string& key, bool otherwise) const;
  std::string word(const std::vector<std::string>& allowed) const;
  /// A list of `count` finite numbers.
  std::vector<double> numbers(size_t count, const std::string& meaning) const;

  const std::string& address() const { return address_; }
  [[noreturn]] void fail(const std::string& allowed) const;

 private:
  YAML::Node node_;
  std::string address_;
};

/// A number as text, without trailing zeros.
std::string formatNumber(double number);

}  // namespace markerless_mocap
