#include "options/option_check.h"

#include <algorithm>
#include <stdexcept>

#include "options/option_texts.h"

namespace markerless_mocap {
namespace {

/// Whether a field's value is allowed; false for NaN.
struct IsAllowed {
  const OptionField& field;
  bool within(double value) const { return value >= field.min_value && value <= field.max_value; }
  bool operator()(const bool*) const { return true; }
  bool operator()(const int* value) const { return within(*value); }
  bool operator()(const double* value) const { return within(*value); }
  bool operator()(const OptionField::Range& value) const {
    return within(*value.min) && within(*value.max);
  }
  bool operator()(const Eigen::Vector3d* v) const {
    return within(v->x()) && within(v->y()) && within(v->z());
  }
  bool operator()(const std::string* value) const {
    const auto& allowed = field.allowed;
    return allowed.empty() || std::find(allowed.begin(), allowed.end(), *value) != allowed.end();
  }
  bool operator()(const std::vector<std::string>*) const { return true; }
};

/// What is allowed for a value that has the right type.
std::string allowedOf(const OptionField& field) {
  const bool number =
      std::holds_alternative<int*>(field.value) || std::holds_alternative<double*>(field.value);
  return number ? rangeText(field) : allowedText(field);
}

}  // namespace

void throwNotAllowed(const std::string& path, const std::string& value,
                     const std::string& allowed) {
  throw std::invalid_argument(shortened(path) + " is " + shortened(value) + ", allowed is " +
                              allowed);
}

void checkOption(const std::string& path, const OptionField& field) {
  if (!std::visit(IsAllowed{field}, field.value))
    throwNotAllowed(path, valueText(field), allowedOf(field));
  if (const auto* range = std::get_if<OptionField::Range>(&field.value);
      range && *range->min > *range->max)
    throwNotAllowed(path, valueText(field), "[min, max] with a min that is not greater than max");
}

}  // namespace markerless_mocap
