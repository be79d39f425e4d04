#pragma once

#include <string>
#include <vector>

namespace markerless_mocap {

/// Words between commas.
inline std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace markerless_mocap
