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

[[noreturn]] void throwError(const std::string& where, const char* key, const std::string& value,
                             const std::string& allowed) {
  throw std::invalid_argument(where + "/" + key + " is " + value + ", allowed is " + allowed);
}

template <class T>
std::string rangeText(T min_value, T max_value) {
  return text(min_value) + " to " + text(max_value);
}

template <class T>
void checkRange(const std::string& where, const char* key, T value, T min_value, T max_value) {
  if (!(value >= min_value && value <= max_value))  // NaN fails too
    throwError(where, key, text(value), rangeText(min_value, max_value));
}

void checkVector(const std::string& where, const char* key, const Eigen::Vector3d& v,
                 double min_value, double max_value) {
  if (!v.allFinite() || v.minCoeff() < min_value || v.maxCoeff() > max_value)
    throwError(where, key, text(v), "three numbers, each " + rangeText(min_value, max_value));
}

void checkChoice(const std::string& where, const char* key, const std::string& value,
                 const std::vector<std::string>& allowed) {
  if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), value) == allowed.end())
    throwError(where, key, '"' + value + '"', "one of " + joined(allowed));
}

/// The node's value, or a sentence that says which type is wanted.
template <class T>
T converted(const YAML::Node& node, const std::string& where, const char* key,
            const std::string& wanted) {
  try {
    return node.as<T>();
  } catch (const YAML::Exception&) {
    throwError(where, key, shown(node), wanted);
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

void OptionReader::field(const char* key, int& value, int min_value, int max_value, const char*) {
  const YAML::Node n = take(key);
  if (!n) return;
  value = converted<int>(n, where_, key, "a whole number, " + rangeText(min_value, max_value));
  checkRange(where_, key, value, min_value, max_value);
}

void OptionReader::field(const char* key, double& value, double min_value, double max_value,
                         const char*) {
  const YAML::Node n = take(key);
  if (!n) return;
  value = converted<double>(n, where_, key, "a number, " + rangeText(min_value, max_value));
  checkRange(where_, key, value, min_value, max_value);
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

void OptionReader::field(const char* key, Eigen::Vector3d& value, double min_value,
                         double max_value, const char*) {
  const YAML::Node n = take(key);
  if (!n) return;
  const std::string wanted = "three numbers, each " + rangeText(min_value, max_value);
  const auto numbers = converted<std::vector<double>>(n, where_, key, wanted);
  if (numbers.size() != 3) throwError(where_, key, shown(n), wanted);
  value = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  checkVector(where_, key, value, min_value, max_value);
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

void OptionChecker::field(const char* key, int& value, int min_value, int max_value, const char*) {
  checkRange(where_, key, value, min_value, max_value);
}

void OptionChecker::field(const char* key, double& value, double min_value, double max_value,
                          const char*) {
  checkRange(where_, key, value, min_value, max_value);
}

void OptionChecker::field(const char* key, std::string& value,
                          const std::vector<std::string>& allowed, const char*) {
  checkChoice(where_, key, value, allowed);
}

void OptionChecker::field(const char*, std::vector<std::string>&, const char*) {}

void OptionChecker::field(const char* key, Eigen::Vector3d& value, double min_value,
                          double max_value, const char*) {
  checkVector(where_, key, value, min_value, max_value);
}

void OptionDescriber::row(const char* key, const std::string& value, const std::string& allowed,
                          const char* meaning) {
  rows_ += "| `" + std::string(key) + "` | " + value + " | " + allowed + " | " + meaning + " |\n";
}

void OptionDescriber::field(const char* key, bool& value, const char* meaning) {
  row(key, value ? "true" : "false", "true, false", meaning);
}

void OptionDescriber::field(const char* key, int& value, int min_value, int max_value,
                            const char* meaning) {
  row(key, text(value), rangeText(min_value, max_value), meaning);
}

void OptionDescriber::field(const char* key, double& value, double min_value, double max_value,
                            const char* meaning) {
  row(key, text(value), rangeText(min_value, max_value), meaning);
}

void OptionDescriber::field(const char* key, std::string& value,
                            const std::vector<std::string>& allowed, const char* meaning) {
  row(key, value.empty() ? "(empty)" : value, allowed.empty() ? "any text" : joined(allowed),
      meaning);
}

void OptionDescriber::field(const char* key, std::vector<std::string>& value, const char* meaning) {
  row(key, "[" + joined(value) + "]", "list of texts", meaning);
}

void OptionDescriber::field(const char* key, Eigen::Vector3d& value, double min_value,
                            double max_value, const char* meaning) {
  row(key, text(value), "each " + rangeText(min_value, max_value), meaning);
}

void PrefixedVisitor::field(const char* key, bool& value, const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, meaning);
}

void PrefixedVisitor::field(const char* key, int& value, int min_value, int max_value,
                            const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, min_value, max_value, meaning);
}

void PrefixedVisitor::field(const char* key, double& value, double min_value, double max_value,
                            const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, min_value, max_value, meaning);
}

void PrefixedVisitor::field(const char* key, std::string& value,
                            const std::vector<std::string>& allowed, const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, allowed, meaning);
}

void PrefixedVisitor::field(const char* key, std::vector<std::string>& value, const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, meaning);
}

void PrefixedVisitor::field(const char* key, Eigen::Vector3d& value, double min_value,
                            double max_value, const char* meaning) {
  inner_.field((prefix_ + key).c_str(), value, min_value, max_value, meaning);
}

}  // namespace markerless_mocap
