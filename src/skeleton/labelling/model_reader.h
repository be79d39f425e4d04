#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <set>
#include <string>

#include "skeleton/labelling/piecewise_linear.h"

namespace markerless_mocap {

/// Reads a map of a model file. Throws std::invalid_argument with a message that names the file,
/// the key and the expected value.
class ModelReader {
 public:
  /// \param where name of the file, for error messages
  ModelReader(const std::string& yaml, const std::string& where);

  ModelReader map(const std::string& key);
  double number(const std::string& key);
  PiecewiseLinear curve(const std::string& key);
  /// One curve for each feature, under the key toString(Feature). The map must have no other keys.
  template <class Feature, size_t kCount>
  std::array<PiecewiseLinear, kCount> curves(const std::string& key);
  /// Throws if the map has a key that was not read, or a repeated one.
  void finish() const;

 private:
  ModelReader(const YAML::Node& node, const std::string& file, const std::string& path);
  YAML::Node take(const std::string& key, const char* expected);
  [[noreturn]] void fail(const std::string& key, const std::string& fault) const;

  YAML::Node node_;
  std::string file_;
  std::string path_;  ///< prefix of keys, empty or ending in a slash
  std::set<std::string> known_;
};

template <class Feature, size_t kCount>
std::array<PiecewiseLinear, kCount> ModelReader::curves(const std::string& key) {
  ModelReader section = map(key);
  std::array<PiecewiseLinear, kCount> out;
  for (size_t i = 0; i < kCount; ++i) out[i] = section.curve(toString(Feature(i)));
  section.finish();
  return out;
}

}  // namespace markerless_mocap
