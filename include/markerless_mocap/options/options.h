#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

namespace markerless_mocap {

/// What every options struct shows its fields to. Each `field` call gives the key as it stands in
/// YAML, the member, the allowed range (inclusive), and one sentence with the unit.
class OptionVisitor {
 public:
  virtual ~OptionVisitor() = default;
  virtual void field(const char* key, bool& value, const char* meaning) = 0;
  virtual void field(const char* key, int& value, int min_value, int max_value,
                     const char* meaning) = 0;
  virtual void field(const char* key, double& value, double min_value, double max_value,
                     const char* meaning) = 0;
  /// `allowed` empty: any text.
  virtual void field(const char* key, std::string& value, const std::vector<std::string>& allowed,
                     const char* meaning) = 0;
  virtual void field(const char* key, std::vector<std::string>& value, const char* meaning) = 0;
  virtual void field(const char* key, Eigen::Vector3d& value, double min_value, double max_value,
                     const char* meaning) = 0;
};

/// Fills fields from a YAML map. Throws std::invalid_argument with one sentence that names the
/// key, the value and what is allowed: on a wrong type, a value out of range, or (in `finish`) a
/// key that no field asked for.
class OptionReader : public OptionVisitor {
 public:
  /// \param node map of key to value; an undefined or null node leaves all defaults
  /// \param where name of the stage, used in error sentences
  OptionReader(const YAML::Node& node, std::string where);
  void field(const char* key, bool& value, const char* meaning) override;
  void field(const char* key, int& value, int min_value, int max_value,
             const char* meaning) override;
  void field(const char* key, double& value, double min_value, double max_value,
             const char* meaning) override;
  void field(const char* key, std::string& value, const std::vector<std::string>& allowed,
             const char* meaning) override;
  void field(const char* key, std::vector<std::string>& value, const char* meaning) override;
  void field(const char* key, Eigen::Vector3d& value, double min_value, double max_value,
             const char* meaning) override;
  /// Throws if the map holds a key that no field asked for, naming the nearest known key.
  void finish() const;

 private:
  YAML::Node take(const char* key);

  YAML::Node node_;
  std::string where_;
  std::set<std::string> known_;
};

/// Checks ranges of fields that were set in code. Throws std::invalid_argument as OptionReader.
class OptionChecker : public OptionVisitor {
 public:
  explicit OptionChecker(std::string where) : where_(std::move(where)) {}
  void field(const char* key, bool& value, const char* meaning) override;
  void field(const char* key, int& value, int min_value, int max_value,
             const char* meaning) override;
  void field(const char* key, double& value, double min_value, double max_value,
             const char* meaning) override;
  void field(const char* key, std::string& value, const std::vector<std::string>& allowed,
             const char* meaning) override;
  void field(const char* key, std::vector<std::string>& value, const char* meaning) override;
  void field(const char* key, Eigen::Vector3d& value, double min_value, double max_value,
             const char* meaning) override;

 private:
  std::string where_;
};

/// Writes one Markdown table row per field: key, default, allowed, meaning.
class OptionDescriber : public OptionVisitor {
 public:
  void field(const char* key, bool& value, const char* meaning) override;
  void field(const char* key, int& value, int min_value, int max_value,
             const char* meaning) override;
  void field(const char* key, double& value, double min_value, double max_value,
             const char* meaning) override;
  void field(const char* key, std::string& value, const std::vector<std::string>& allowed,
             const char* meaning) override;
  void field(const char* key, std::vector<std::string>& value, const char* meaning) override;
  void field(const char* key, Eigen::Vector3d& value, double min_value, double max_value,
             const char* meaning) override;
  const std::string& rows() const { return rows_; }

 private:
  void row(const char* key, const std::string& value, const std::string& allowed,
           const char* meaning);

  std::string rows_;
};

/// Shows another visitor fields under keys that begin with a prefix: one section holds the fields
/// of several structs.
class PrefixedVisitor : public OptionVisitor {
 public:
  /// \param inner must outlive this
  PrefixedVisitor(std::string prefix, OptionVisitor& inner)
      : prefix_(std::move(prefix)), inner_(inner) {}
  void field(const char* key, bool& value, const char* meaning) override;
  void field(const char* key, int& value, int min_value, int max_value,
             const char* meaning) override;
  void field(const char* key, double& value, double min_value, double max_value,
             const char* meaning) override;
  void field(const char* key, std::string& value, const std::vector<std::string>& allowed,
             const char* meaning) override;
  void field(const char* key, std::vector<std::string>& value, const char* meaning) override;
  void field(const char* key, Eigen::Vector3d& value, double min_value, double max_value,
             const char* meaning) override;

 private:
  std::string prefix_;
  OptionVisitor& inner_;
};

/// Range check of all fields; for use in a struct's own validate(). Options structs have
/// `static constexpr const char* kStage` and `void visit(OptionVisitor&)`.
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
