#pragma once

#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Writes one line of YAML per field, its meaning as a comment above it.
class YamlWriter : public OptionVisitor {
 public:
  explicit YamlWriter(std::string indent) : indent_(std::move(indent)) {}
  void visitField(const OptionField& field) override;
  void visitSection(const char* key, const char* meaning, const Fields& fields) override;
  const std::string& lines() const { return lines_; }

 private:
  void comment(const std::string& meaning);

  std::string indent_, lines_, last_meaning_;
};

/// Writes a Markdown table, a row per field: key, default, allowed, meaning; and one for each
/// section, under a heading of the next lower level.
class TableWriter : public OptionVisitor {
 public:
  /// \param heading "## " or the like
  /// \param path the title; empty text: none below it
  TableWriter(std::string heading, std::string path, const std::string& text);
  void visitField(const OptionField& field) override;
  void visitSection(const char* key, const char* meaning, const Fields& fields) override;
  std::string page() const { return own_ + sections_; }

 private:
  std::string heading_, path_, own_, sections_;
};

}  // namespace markerless_mocap
