#include "tools/common/board_arguments.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace markerless_mocap {
namespace {

/// Calls `visit` with the option name and field of each board option.
class FieldVisitor : public OptionVisitor {
 public:
  using Visit = std::function<void(const std::string&, const OptionField&)>;
  explicit FieldVisitor(Visit visit) : visit_(std::move(visit)) {}
  void visitField(const OptionField& field) override {
    std::string name = std::string("--") + field.key;
    for (char& c : name)
      if (c == '_') c = '-';
    visit_(name, field);
  }
  void visitSection(const char*, const char*, const Fields&) override {}

 private:
  Visit visit_;
};

template <class ValueT>
bool copyAs(const OptionField& from, const OptionField& to) {
  const auto* source = std::get_if<ValueT*>(&from.value);
  if (!source) return false;
  **std::get_if<ValueT*>(&to.value) = **source;
  return true;
}

void copyField(const OptionField& from, const OptionField& to) {
  copyAs<bool>(from, to) || copyAs<int>(from, to) || copyAs<double>(from, to) ||
      copyAs<std::string>(from, to);
}

}  // namespace

void describeBoard(CLI::App& app, BoardArguments* arguments) {
  arguments->app = &app;
  app.add_option("--board", arguments->file,
                 "board file, as make_board writes it, or caliscope's charuco.toml");
  FieldVisitor visitor([&](const std::string& name, const OptionField& field) {
    const std::string meaning = std::string("board: ") + field.meaning;
    if (const auto* flag = std::get_if<bool*>(&field.value)) app.add_flag(name, **flag, meaning);
    if (const auto* number = std::get_if<int*>(&field.value))
      app.add_option(name, **number, meaning)->capture_default_str();
    if (const auto* number = std::get_if<double*>(&field.value))
      app.add_option(name, **number, meaning)->capture_default_str();
    if (const auto* words = std::get_if<std::string*>(&field.value))
      app.add_option(name, **words, meaning)->capture_default_str();
  });
  arguments->options.visit(visitor);
}

bool isBoardDescribed(const BoardArguments& arguments) {
  if (!arguments.file.empty()) return true;
  bool described = false;
  FieldVisitor visitor([&](const std::string& name, const OptionField&) {
    described |= arguments.app->get_option(name)->count() > 0;
  });
  BoardOptions copy;
  copy.visit(visitor);
  return described;
}

BoardOptions boardOf(const BoardArguments& arguments) {
  BoardOptions given = arguments.options;
  if (!arguments.file.empty()) {
    BoardOptions board = readBoard(arguments.file);
    // What the command line names replaces what the file says.
    FieldVisitor overlay([&](const std::string& name, const OptionField& field) {
      if (arguments.app->get_option(name)->count() == 0) return;
      FieldVisitor target([&](const std::string& other, const OptionField& to) {
        if (other == name) copyField(field, to);
      });
      board.visit(target);
    });
    given.visit(overlay);
    given = board;
  }
  given.validate();
  return given;
}

}  // namespace markerless_mocap
