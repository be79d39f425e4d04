#include "markerless_mocap/options/options.h"

#include "options/option_check.h"

namespace markerless_mocap {

void OptionVisitor::field(const char* key, bool& value, const char* meaning) {
  visitField({key, meaning, &value});
}

void OptionVisitor::field(const char* key, int& value, int min_value, int max_value,
                          const char* meaning) {
  visitField({key, meaning, &value, double(min_value), double(max_value)});
}

void OptionVisitor::field(const char* key, double& value, double min_value, double max_value,
                          const char* meaning) {
  visitField({key, meaning, &value, min_value, max_value});
}

void OptionVisitor::field(const char* key, Eigen::Vector3d& value, double min_value,
                          double max_value, const char* meaning) {
  visitField({key, meaning, &value, min_value, max_value});
}

void OptionVisitor::field(const char* key, std::string& value,
                          const std::vector<std::string>& allowed, const char* meaning) {
  visitField({key, meaning, &value, 0.0, 0.0, allowed});
}

void OptionVisitor::field(const char* key, std::vector<std::string>& value, const char* meaning) {
  visitField({key, meaning, &value});
}

void OptionVisitor::range(const char* key, double& min, double& max, double min_value,
                          double max_value, const char* meaning) {
  visitField({key, meaning, OptionField::Range{&min, &max}, min_value, max_value});
}

void OptionChecker::visitField(const OptionField& field) {
  checkOption(where_ + "/" + field.key, field);
}

void OptionChecker::visitSection(const char* key, const char*, const Fields& fields) {
  OptionChecker nested(where_ + "/" + key);
  fields(nested);
}

}  // namespace markerless_mocap
