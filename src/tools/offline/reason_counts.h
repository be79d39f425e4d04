#pragma once

#include <map>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Counts messages. Messages that differ only in their numbers count as the same.
class ReasonCounts {
 public:
  struct Reason {
    int count = 0;
    std::string example;  ///< the first message
  };

  void add(const std::string& message);
  /// The most frequent first.
  std::vector<Reason> sorted() const;

 private:
  std::map<std::string, Reason> reasons_;  ///< key: message without numbers
};

}  // namespace markerless_mocap
