#include "tools/offline/reason_counts.h"

#include <algorithm>
#include <cctype>

namespace markerless_mocap {
namespace {

std::string withoutNumbers(const std::string& message) {
  std::string out;
  for (const char c : message)
    if (!std::isdigit(static_cast<unsigned char>(c))) out += c;
  return out;
}

}  // namespace

void ReasonCounts::add(const std::string& message) {
  Reason& reason = reasons_[withoutNumbers(message)];
  if (reason.count++ == 0) reason.example = message;
}

std::vector<ReasonCounts::Reason> ReasonCounts::sorted() const {
  std::vector<Reason> reasons;
  for (const auto& entry : reasons_) reasons.push_back(entry.second);
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const Reason& a, const Reason& b) { return a.count > b.count; });
  return reasons;
}

}  // namespace markerless_mocap
