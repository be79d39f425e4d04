#include "markerless_mocap/options/options.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace markerless_mocap {
namespace {

template <class T>
std::string text(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string text(const Eigen::Vector3d& v) {
  return "[" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + "]";
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

std::string shown(const YAML::Node& node) {
  YAML::Emitter out;
  out.SetSeqFormat(YAML::Flow);
  out.SetMapFormat(YAML::Flow);
  out << node;
  return out.c_str();
}

[[noreturn]] void refuse(const std::string& where, const char* key, const std::string& value,
                         const std::string& allowed) {
  throw std::invalid_argument(where + "/" + key + " is " + value + ", allowed is " + allowed);
}

template <class T>
std::string rangeText(T lowest, T highest) {
  return text(lowest) + " to " + text(highest);
}

template <class T>
void checkRange(const std::string& where, const char* key, T value, T lowest, T highest) {
  if (!(value >= lowest && value <= highest))  // NaN fails too
    refuse(where, key, text(value), rangeText(lowest, highest));
}

void checkVector(const std::string& where, const char* key, const Eigen::Vector3d& v, double lowest,
                 double highest) {
  if (!v.allFinite() || v.minCoeff() < lowest || v.maxCoeff() > highest)
    refuse(where, key, text(v), "three numbers, each " + rangeText(lowest, highest));
}

void checkChoice(const std::string& where, const char* key, const std::string& value,
                 const std::vector<std::string>& allowed) {
  if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), value) == allowed.end())
    refuse(where, key, '"' + value + '"', "one of " + joined(allowed));
}

/// The node's value, or a sentence that says which type is wanted.
template <class T>
T converted(const YAML::Node& node, const std::string& where, const char* key,
            const std::string& wanted) {
  try {
    return node.as<T>();
  } catch (const YAML::Exception&) {
    refuse(where, key, shown(node), wanted);
  }
}

size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
      diagonal = above;
    }
  }
  return row.back();
}

}  // namespace

OptionReader::OptionReader(const YAML::Node& node, std::string where)
    : node_(node), where_(std::move(where)) {
  if (node_ && !node_.IsNull() && !node_.IsMap())
    throw std::invalid_argument(where_ + " is " + shown(node_) +
                                ", allowed is a map of keys to values");
}

YAML::Node OptionReader::take(const char* key) {
  known_.insert(key);
  if (!node_ || node_.IsNull()) return YAML::Node(YAML::NodeType::Undefined);
  const YAML::Node& node = node_;  // const: looking up must not add the key
  return node[key];
}

void OptionReader::field(const char* key, bool& value, const char*) {
  if (const YAML::Node n = take(key)) value = converted<bool>(n, where_, key, "true or false");
}

void OptionReader::field(const char* key, int& value, int lowest, int highest, const char*) {
  const YAML::Node n = take(key);
  if (!n) return;
  value = converted<int>(n, where_, key, "a whole number, " + rangeText(lowest, highest));
  checkRange(where_, key, value, lowest, highest);
}

void OptionReader::field(const char* key, double& value, double lowest, double highest,
                         const char*) {
  const YAML::Node n = take(key);
  if (!n) return;
  value = converted<double>(n, where_, key, "a number, " + rangeText(lowest, highest));
  checkRange(where_, key, value, lowest, highest);
}

void OptionReader::field(const char* key, std::string& value,
                         const std::vector<std::string>& allowed, const char*) {
  const YAML::Node n = take(key);
  if (!n) return;
  value = converted<std::string>(n, where_, key,
                                 allowed.empty() ? "a text" : "one of " + joined(allowed));
  checkChoice(where_, key, value, allowed);
}

void OptionReader::field(const char* key, std::vector<std::string>& value, const char*) {
  if (const YAML::Node n = take(key))
    value = converted<std::vector<std::string>>(n, where_, key, "a list of texts");
}

void OptionReader::field(const char* key, Eigen::Vector3d& value, double lowest, double highest,
                         const char*) {
  const YAML::Node n = take(key);
  if (!n) return;
  const std::string wanted = "three numbers, each " + rangeText(lowest, highest);
  const auto numbers = converted<std::vector<double>>(n, where_, key, wanted);
  if (numbers.size() != 3) refuse(where_, key, shown(n), wanted);
  value = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  checkVector(where_, key, value, lowest, highest);
}

void OptionReader::finish() const {
  if (!node_ || node_.IsNull()) return;
  for (const auto& entry : node_) {
    const std::string key = entry.first.as<std::string>();
    if (known_.count(key)) continue;
    const auto nearest = std::min_element(known_.begin(), known_.end(),
                                          [&](const std::string& a, const std::string& b) {
                                            return editDistance(a, key) < editDistance(b, key);
                                          });
    throw std::invalid_argument(
        where_ + "/" + key + " is not an option (value " + shown(entry.second) + "), " +
        (nearest == known_.end() ? "none is allowed" : "did you mean " + *nearest + "?"));
  }
}

void OptionChecker::field(const char*, bool&, const char*) {}

void OptionChecker::field(const char* key, int& value, int lowest, int highest, const char*) {
  checkRange(where_, key, value, lowest, highest);
}

void OptionChecker::field(const char* key, double& value, double lowest, double highest,
                          const char*) {
  checkRange(where_, key, value, lowest, highest);
}

void OptionChecker::field(const char* key, std::string& value,
                          const std::vector<std::string>& allowed, const char*) {
  checkChoice(where_, key, value, allowed);
}

void OptionChecker::field(const char*, std::vector<std::string>&, const char*) {}

void OptionChecker::field(const char* key, Eigen::Vector3d& value, double lowest, double highest,
                          const char*) {
  checkVector(where_, key, value, lowest, highest);
}

void OptionDescriber::row(const char* key, const std::string& value, const std::string& allowed,
                          const char* meaning) {
  rows_ += "| `" + std::string(key) + "` | " + value + " | " + allowed + " | " + meaning + " |\n";
}

void OptionDescriber::field(const char* key, bool& value, const char* meaning) {
  row(key, value ? "true" : "false", "true, false", meaning);
}

void OptionDescriber::field(const char* key, int& value, int lowest, int highest,
                            const char* meaning) {
  row(key, text(value), rangeText(lowest, highest), meaning);
}

void OptionDescriber::field(const char* key, double& value, double lowest, double highest,
                            const char* meaning) {
  row(key, text(value), rangeText(lowest, highest), meaning);
}

void OptionDescriber::field(const char* key, std::string& value,
                            const std::vector<std::string>& allowed, const char* meaning) {
  row(key, value.empty() ? "(empty)" : value, allowed.empty() ? "any text" : joined(allowed),
      meaning);
}

void OptionDescriber::field(const char* key, std::vector<std::string>& value, const char* meaning) {
  row(key, "[" + joined(value) + "]", "list of texts", meaning);
}

void OptionDescriber::field(const char* key, Eigen::Vector3d& value, double lowest, double highest,
                            const char* meaning) {
  row(key, text(value), "each " + rangeText(lowest, highest), meaning);
}

void PrefixedVisitor::field(const char* key, bool& value, const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, meaning);
}

void PrefixedVisitor::field(const char* key, int& value, int lowest, int highest,
                            const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, lowest, highest, meaning);
}

void PrefixedVisitor::field(const char* key, double& value, double lowest, double highest,
                            const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, lowest, highest, meaning);
}

void PrefixedVisitor::field(const char* key, std::string& value,
                            const std::vector<std::string>& allowed, const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, allowed, meaning);
}

void PrefixedVisitor::field(const char* key, std::vector<std::string>& value, const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, meaning);
}

void PrefixedVisitor::field(const char* key, Eigen::Vector3d& value, double lowest, double highest,
                            const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, lowest, highest, meaning);
}

}  // namespace markerless_mocap
