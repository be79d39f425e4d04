#include "options/option_texts.h"

#include <sstream>

#include "text/joined.h"
#include "text/number_text.h"

namespace markerless_mocap {
namespace {

/// Text of bounds, which some are multiples of pi.
std::string boundText(double number) {
  std::ostringstream out;
  out << number;
  return out.str();
}

std::string quoted(const std::string& word) {
  return '"' + word + '"';
}

struct ValueText {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  std::string operator()(const double* value) const { return numberText(*value); }
  std::string operator()(const OptionField::Range& value) const {
    return "[" + numberText(*value.min) + ", " + numberText(*value.max) + "]";
  }
  std::string operator()(const Eigen::Vector3d* v) const {
    return "[" + numberText(v->x()) + ", " + numberText(v->y()) + ", " + numberText(v->z()) + "]";
  }
  std::string operator()(const std::string* value) const { return quoted(*value); }
  std::string operator()(const std::vector<std::string>* value) const {
    std::vector<std::string> words;
    for (const std::string& word : *value) words.push_back(quoted(word));
    return "[" + joined(words) + "]";
  }
};

struct AllowedText {
  const OptionField& field;
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const int*) const { return "a whole number, " + rangeText(field); }
  std::string operator()(const double*) const { return "a number, " + rangeText(field); }
  std::string operator()(const OptionField::Range&) const {
    return "[min, max], each " + rangeText(field);
  }
  std::string operator()(const Eigen::Vector3d*) const {
    return "three numbers, each " + rangeText(field);
  }
  std::string operator()(const std::string*) const {
    return field.allowed.empty() ? "a text" : "one of " + joined(field.allowed);
  }
  std::string operator()(const std::vector<std::string>*) const { return "a list of texts"; }
};

}  // namespace

std::string shortened(const std::string& text) {
  constexpr size_t kShown = 100;
  if (text.size() <= kShown) return text;
  size_t end = kShown;
  while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // within a letter of several bytes
  return text.substr(0, end) + " ...";
}

std::string valueText(const OptionField& field) {
  return std::visit(ValueText(), field.value);
}

std::string rangeText(const OptionField& field) {
  if (std::holds_alternative<int*>(field.value))
    return std::to_string(int(field.min_value)) + " to " + std::to_string(int(field.max_value));
  return boundText(field.min_value) + " to " + boundText(field.max_value);
}

std::string allowedText(const OptionField& field) {
  return std::visit(AllowedText{field}, field.value);
}

}  // namespace markerless_mocap
