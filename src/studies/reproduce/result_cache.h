#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "pages/page.h"

namespace markerless_mocap {

/// Files named by what they were made of.
class ResultCache {
 public:
  /// Makes the folder. Throws std::runtime_error if it cannot.
  explicit ResultCache(std::filesystem::path folder);

  /// <folder>/<name>-<hash of the settings><ending>
  std::filesystem::path file(const std::string& name, const Json& settings,
                             const std::string& ending) const;
  /// A result that is there; a damaged file counts as missing.
  std::optional<Json> find(const std::string& name, const Json& settings) const;
  void keep(const std::string& name, const Json& settings, const Json& result) const;

 private:
  std::filesystem::path folder_;
};

/// 16 hexadecimal digits that differ where the settings do (FNV-1a, 64 bits).
std::string settingsHash(const Json& settings);

/// Numbers of a result; null, which stands for what is not finite, becomes NaN.
std::vector<double> numbersOf(const Json& array);
double numberOf(const Json& value);

}  // namespace markerless_mocap
