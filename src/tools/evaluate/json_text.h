#pragma once

#include <string>

namespace markerless_mocap {

/// Builds the text of a JSON object member by member; numbers that are not finite become null.
class JsonObject {
 public:
  void add(const std::string& key, double value);
  void add(const std::string& key, size_t value);
  void add(const std::string& key, const std::string& value);
  void add(const std::string& key, const char* value) { add(key, std::string(value)); }
  void add(const std::string& key, const JsonObject& value);
  /// \param values JSON values, separated by commas
  void addList(const std::string& key, const std::string& values);

  /// \param indent spaces before each line
  std::string text(int indent = 0) const;

  static std::string number(double value);
  static std::string quoted(const std::string& text);

 private:
  void put(const std::string& key, std::string value);

  std::string members_;
};

}  // namespace markerless_mocap
