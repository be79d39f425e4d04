#pragma once

#include <yaml-cpp/yaml.h>

#include <set>
#include <string>
#include <vector>

namespace markerless_mocap {

/// A finite number. Throws std::invalid_argument if it is none, naming where and the key.
double finiteYamlNumber(const YAML::Node& node, const std::string& key, const std::string& where);
/// A list of finite numbers. Throws as finiteYamlNumber().
std::vector<double> finiteYamlNumbers(const YAML::Node& node, const std::string& key,
                                      const std::string& where);

/// A map of a file that somebody has written: no key may be repeated, and after finish() none was
/// left unread. All functions throw std::invalid_argument, naming where and the key.
class YamlMap {
 public:
  /// \param where how sentences name the place, for example the file
  YamlMap(const YAML::Node& node, std::string where);

  const std::string& where() const { return where_; }
  const std::vector<std::string>& keys() const { return keys_; }
  /// The value of a key; undefined if the key is missing.
  YAML::Node optional(const std::string& key);
  YAML::Node required(const std::string& key);
  /// The map of a key; its sentences name it after where().
  YamlMap map(const std::string& key);
  double number(const std::string& key);
  std::vector<double> numbers(const std::string& key);
  std::vector<double> numbers(const std::string& key, size_t wanted, const char* meaning);
  /// Refuses a key that was not asked for.
  void finish() const;
  /// Throws "where: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  YAML::Node node_;
  std::string where_;
  std::vector<std::string> keys_;
  std::set<std::string> known_;
};

}  // namespace markerless_mocap
