#pragma once

#include <string>

namespace markerless_mocap {

/// A key as it stands in a file.
struct OptionPath {
  std::string where;  ///< path of its map as errors say it
  std::string stage;  ///< path of its map in a configuration file
  std::string key;
};

/// Throws std::invalid_argument with a message that names the new key if the key is one of an
/// earlier release.
void throwIfKeyWasRenamed(const OptionPath& path);

/// The same for a value, a word, of a key that is still there.
void throwIfValueWasRenamed(const OptionPath& path, const std::string& value);

}  // namespace markerless_mocap
