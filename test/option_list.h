#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/options/options.h"
#include "options/option_texts.h"

namespace markerless_mocap {

/// Lists what an options struct shows: every field with its path below the struct, and every
/// section.
class OptionList : public OptionVisitor {
 public:
  struct Entry {
    std::string path, value, meaning;
    bool is_section = false;
  };

  explicit OptionList(std::string prefix = "") : prefix_(std::move(prefix)) {}
  void visitField(const OptionField& field) override {
    entries.push_back({prefix_ + field.key, valueText(field), field.meaning});
  }
  void visitSection(const char* key, const char* meaning, const Fields& fields) override {
    entries.push_back({prefix_ + key, "", meaning, true});
    OptionList nested(prefix_ + key + "/");
    fields(nested);
    entries.insert(entries.end(), nested.entries.begin(), nested.entries.end());
  }

  std::vector<Entry> entries;

 private:
  std::string prefix_;
};

template <class OptionsT>
std::vector<OptionList::Entry> optionsOf(OptionsT options) {
  OptionList list;
  options.visit(list);
  return list.entries;
}

/// Paths and values of all fields, a line each.
template <class OptionsT>
std::string valuesOf(const OptionsT& options) {
  std::string lines;
  for (const auto& entry : optionsOf(options)) lines += entry.path + ": " + entry.value + "\n";
  return lines;
}

}  // namespace markerless_mocap
