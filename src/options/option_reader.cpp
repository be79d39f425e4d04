#include <algorithm>
#include <array>
#include <stdexcept>

#include "markerless_mocap/options/options.h"
#include "options/option_check.h"
#include "options/option_texts.h"
#include "options/renamed_options.h"

namespace markerless_mocap {
namespace {

std::string shown(const YAML::Node& node) {
  YAML::Emitter out;
  out.SetSeqFormat(YAML::Flow);
  out.SetMapFormat(YAML::Flow);
  out << node;
  return out.c_str();
}

/// Writes a node's value to a field's member; throws YAML::Exception on a wrong type.
struct Assign {
  const YAML::Node& node;

  template <class T>
  void operator()(T* value) const {
    *value = node.as<T>();
  }
  void operator()(const OptionField::Range& value) const {
    const auto numbers = node.as<std::array<double, 2>>();
    *value.min = numbers[0];
    *value.max = numbers[1];
  }
  void operator()(Eigen::Vector3d* value) const {
    const auto numbers = node.as<std::array<double, 3>>();
    *value = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  }
};

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

/// "did you mean ...?", or that nothing is allowed.
std::string suggestion(const std::set<std::string>& known, const std::string& key) {
  const auto nearest = std::min_element(
      known.begin(), known.end(),
      [&](const auto& a, const auto& b) { return editDistance(a, key) < editDistance(b, key); });
  return nearest == known.end() ? "none is allowed" : "did you mean " + *nearest + "?";
}

}  // namespace

OptionReader::OptionReader(const YAML::Node& node, std::string where, std::string stage)
    : node_(node), where_(std::move(where)), stage_(stage.empty() ? where_ : std::move(stage)) {
  if (node_ && !node_.IsNull() && !node_.IsMap())
    throwNotAllowed(where_, shown(node_), "a map of keys to values");
}

YAML::Node OptionReader::take(const char* key) {
  allow(key);
  if (!node_ || node_.IsNull()) return YAML::Node(YAML::NodeType::Undefined);
  const YAML::Node& node = node_;  // const: looking up must not add the key
  return node[key];
}

void OptionReader::visitField(const OptionField& field) {
  const YAML::Node node = take(field.key);
  if (!node) return;
  if (node.IsScalar()) throwIfValueWasRenamed({where_, stage_, field.key}, node.Scalar());
  try {
    std::visit(Assign{node}, field.value);
  } catch (const YAML::Exception&) {
    throwNotAllowed(path(field.key), shown(node), allowedText(field));
  }
  checkOption(path(field.key), field);
}

void OptionReader::visitSection(const char* key, const char*, const Fields& fields) {
  const YAML::Node node = take(key);
  if (node && node.IsScalar()) throwIfKeyWasRenamed({where_, stage_, key});
  OptionReader nested(node, path(key), stage_ + "/" + key);
  fields(nested);
  nested.finish();
}

void OptionReader::finish() const {
  if (!node_ || node_.IsNull()) return;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar())
      throw std::invalid_argument(where_ + " has the key " + shortened(shown(entry.first)) +
                                  ", allowed are texts");
    const std::string& key = entry.first.Scalar();
    if (known_.count(key)) continue;
    throwIfKeyWasRenamed({where_, stage_, key});
    const std::string name = shortened(key);
    throw std::invalid_argument(path(name) + " is not an option (value " +
                                shortened(shown(entry.second)) + "), " + suggestion(known_, name));
  }
}

}  // namespace markerless_mocap
