#include <sstream>

#include "calibration/board.h"

namespace markerless_mocap {
namespace {

/// Writes each field with its meaning as a comment.
class FieldWriter : public OptionVisitor {
 public:
  void visitField(const OptionField& field) override {
    text_ << "# " << field.meaning << '\n' << field.key << ": ";
    std::visit([this](auto value) { write(value); }, field.value);
    text_ << '\n';
  }
  void visitSection(const char*, const char*, const Fields&) override {}
  std::string text() const { return text_.str(); }

 private:
  void write(bool* value) { text_ << (*value ? "true" : "false"); }
  void write(int* value) { text_ << *value; }
  void write(double* value) { text_ << *value; }
  void write(std::string* value) { text_ << *value; }
  // A board has no options of these kinds.
  void write(OptionField::Range) {}
  void write(Eigen::Vector3d*) {}
  void write(std::vector<std::string>*) {}

  std::ostringstream text_;
};

}  // namespace

std::string boardText(const BoardOptions& options) {
  BoardOptions copy = options;
  FieldWriter writer;
  copy.visit(writer);
  return "# A calibration board, for make_board and calibrate_rig.\n" + writer.text();
}

}  // namespace markerless_mocap
