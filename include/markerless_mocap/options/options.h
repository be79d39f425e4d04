#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace markerless_mocap {

/// One option: its key, its meaning, the member that holds it, and what is allowed.
struct OptionField {
  /// Two members that one key sets as [min, max].
  struct Range {
    double* min;
    double* max;
  };
  using Value = std::variant<bool*, int*, double*, Range, Eigen::Vector3d*, std::string*,
                             std::vector<std::string>*>;

  const char* key;         ///< as in YAML, without its section
  const char* meaning;     ///< with the unit; the comment at the member says the same
  Value value;             ///< never null
  double min_value = 0.0;  ///< allowed for numbers, inclusive
  double max_value = 0.0;  ///< allowed for numbers, inclusive
  std::vector<std::string> allowed = {};  ///< for a text; empty: any text
};

/// An options struct has `static constexpr const char* kStage`, the path of its section such as
/// "pose_fitting/contour", and `void visit(OptionVisitor&)`, which calls field(), range() and
/// section() for each of its members.
class OptionVisitor {
 public:
  using Fields = std::function<void(OptionVisitor&)>;

  virtual ~OptionVisitor() = default;
  virtual void visitField(const OptionField& field) = 0;
  /// \param fields shows the fields of the section to a visitor
  virtual void visitSection(const char* key, const char* meaning, const Fields& fields) = 0;

  void field(const char* key, bool& value, const char* meaning);
  void field(const char* key, int& value, int min_value, int max_value, const char* meaning);
  void field(const char* key, double& value, double min_value, double max_value,
             const char* meaning);
  /// The same range for each coordinate.
  void field(const char* key, Eigen::Vector3d& value, double min_value, double max_value,
             const char* meaning);
  /// `allowed` empty: any text.
  void field(const char* key, std::string& value, const std::vector<std::string>& allowed,
             const char* meaning);
  void field(const char* key, std::vector<std::string>& value, const char* meaning);
  /// A pair [min, max] under one key; min may not be greater than max.
  void range(const char* key, double& min, double& max, double min_value, double max_value,
             const char* meaning);
  /// The fields of another options struct under a key.
  template <class OptionsT>
  void section(const char* key, OptionsT& nested, const char* meaning) {
    visitSection(key, meaning, [&](OptionVisitor& v) { nested.visit(v); });
  }
};

/// Fills fields from a YAML map. Throws std::invalid_argument with a message that names the path
/// of the key, the value and what is allowed: on a wrong type, a value out of range, a key that no
/// field asked for, and a key or value of an earlier release, with its new name.
class OptionReader : public OptionVisitor {
 public:
  /// \param node map of key to value; an undefined or null node leaves all defaults
  /// \param where path of the map, for error messages
  /// \param stage kStage of the options, which renamed keys are looked up by; empty: `where`
  OptionReader(const YAML::Node& node, std::string where, std::string stage = "");
  void visitField(const OptionField& field) override;
  void visitSection(const char* key, const char* meaning, const Fields& fields) override;
  /// Accepts a key without reading it.
  void allow(const char* key) { known_.insert(key); }
  /// Throws if the map holds a key that no field asked for, naming the nearest known key.
  void finish() const;

 private:
  YAML::Node take(const char* key);
  std::string path(const std::string& key) const { return where_ + "/" + key; }

  YAML::Node node_;
  std::string where_, stage_;
  std::set<std::string> known_;
};

/// Checks ranges of fields that were set in code. Throws std::invalid_argument as OptionReader.
class OptionChecker : public OptionVisitor {
 public:
  explicit OptionChecker(std::string where) : where_(std::move(where)) {}
  void visitField(const OptionField& field) override;
  void visitSection(const char* key, const char* meaning, const Fields& fields) override;

 private:
  std::string where_;
};

/// Range check of all fields; for use in a struct's own validate().
template <class OptionsT>
void checkFields(OptionsT options) {
  OptionChecker checker(OptionsT::kStage);
  options.visit(checker);
}

/// Defaults overlaid with the map's values, validated.
template <class OptionsT>
OptionsT loadOptions(const YAML::Node& node) {
  OptionsT options;
  OptionReader reader(node, OptionsT::kStage);
  options.visit(reader);
  reader.finish();
  options.validate();
  return options;
}

}  // namespace markerless_mocap
