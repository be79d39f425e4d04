#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// A number, word or switch of an options struct, for programs that change options one by one while
/// a stage runs. An option of several numbers is several settings; a list of texts is none.
struct Setting {
  using Value = std::variant<bool, int, double, std::string>;

  std::string name;  ///< the option's path with _ for /, and _x, _y, _z or _min, _max
  std::string meaning;
  Value value;
  double min_value = 0.0, max_value = 0.0;  ///< allowed for numbers, inclusive
  std::vector<std::string> allowed = {};    ///< for a text; empty: any text
};

using SettingChanges = std::map<std::string, Setting::Value>;  ///< by name

/// Names of the settings of one option. \param prefix of its section; empty, or "filter_"
std::vector<std::string> settingNames(const std::string& prefix, const OptionField& field);

/// Shows only the fields and sections whose key is not in `fixed`, with the prefix of their
/// settings' names.
class SettingVisitor : public OptionVisitor {
 public:
  explicit SettingVisitor(std::set<std::string> fixed) : fixed_(std::move(fixed)) {}
  void visitField(const OptionField& field) override;
  void visitSection(const char* key, const char* meaning, const Fields& fields) override;

 protected:
  /// \param path of the sections, empty or with / at its end
  virtual void visitSetting(const std::string& path, const OptionField& field) = 0;

 private:
  std::set<std::string> fixed_;
  std::string path_;
};

/// Prefix of the names of a section's settings. \param path as of visitSetting()
std::string settingPrefix(std::string path);

class SettingLister : public SettingVisitor {
 public:
  using SettingVisitor::SettingVisitor;
  std::vector<Setting> settings;

 private:
  void visitSetting(const std::string& path, const OptionField& field) override;
};

/// Changes fields. Throws std::invalid_argument with the sentence of OptionReader if a value is not
/// allowed.
class SettingChanger : public SettingVisitor {
 public:
  SettingChanger(std::string stage, std::set<std::string> fixed, SettingChanges changes)
      : SettingVisitor(std::move(fixed)), stage_(std::move(stage)), changes_(std::move(changes)) {}
  /// Throws std::invalid_argument if there was a change of a name that is no setting.
  void finish() const;

 private:
  void visitSetting(const std::string& path, const OptionField& field) override;

  std::string stage_;
  SettingChanges changes_;  ///< those that have not been made yet
};

/// Collects the fields whose key, or whose section's key, is in `fixed`.
class FixedFields : public OptionVisitor {
 public:
  explicit FixedFields(std::set<std::string> fixed) : fixed_(std::move(fixed)) {}
  void visitField(const OptionField& field) override;
  void visitSection(const char* key, const char* meaning, const Fields& fields) override;
  /// Gives the fields the values of the same fields of another struct of this type.
  void take(const FixedFields& from) const;

 private:
  std::set<std::string> fixed_;
  std::string path_;
  bool inside_ = false;  ///< a section that is fixed as a whole
  std::vector<OptionField::Value> values_;
};

/// `options` with the fixed keys and sections of `current`.
template <class OptionsT>
OptionsT withFixed(OptionsT options, OptionsT current, const std::set<std::string>& fixed) {
  FixedFields to(fixed), from(fixed);
  options.visit(to);
  current.visit(from);
  to.take(from);
  return options;
}

/// \param fixed keys and sections that cannot be changed while a stage runs
template <class OptionsT>
std::vector<Setting> settingsOf(OptionsT options, const std::set<std::string>& fixed) {
  SettingLister lister(fixed);
  options.visit(lister);
  return lister.settings;
}

/// The options with changes, validated. Throws std::invalid_argument as SettingChanger and
/// OptionsT::validate().
template <class OptionsT>
OptionsT withChanges(OptionsT options, const std::set<std::string>& fixed,
                     const SettingChanges& changes) {
  SettingChanger changer(OptionsT::kStage, fixed, changes);
  options.visit(changer);
  changer.finish();
  options.validate();
  return options;
}

}  // namespace markerless_mocap
