#include "body/urdf/expression.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr int kMaxDepth = 100;

/// Recursive descent: sum of products of factors.
class Parser {
 public:
  Parser(const std::string& text, const std::map<std::string, double>& names)
      : text_(text), names_(names) {}

  double parse() {
    const double value = sum();
    if (peek() != '\0') refuse("cannot be understood from \"" + text_.substr(at_, 200) + "\" on");
    if (!std::isfinite(value)) refuse("has no finite value");
    return value;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    constexpr size_t kShown = 200;
    const std::string shown = text_.size() > kShown ? text_.substr(0, kShown) + "..." : text_;
    throw std::invalid_argument("URDF template: the expression ${" + shown + "} " + why);
  }

  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(char wanted) {
    if (peek() != wanted) return false;
    ++at_;
    return true;
  }

  double sum() {
    double value = product();
    while (true) {
      if (take('+'))
        value += product();
      else if (take('-'))
        value -= product();
      else
        return value;
    }
  }

  double product() {
    double value = factor();
    while (true) {
      if (take('*'))
        value *= factor();
      else if (take('/'))
        value /= factor();
      else
        return value;
    }
  }

  double factor() {
    if (++depth_ > kMaxDepth)
      refuse("has more than " + std::to_string(kMaxDepth) + " brackets or signs in each other");
    const double value = signedValue();
    --depth_;
    return value;
  }

  double signedValue() {
    if (take('-')) return -factor();
    if (take('(')) {
      const double value = sum();
      if (!take(')')) refuse("lacks a closing bracket");
      return value;
    }
    return std::isalpha(static_cast<unsigned char>(peek())) ? name() : number();
  }

  double name() {
    const size_t start = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_'))
      ++at_;
    const std::string word = text_.substr(start, at_ - start);
    const auto found = names_.find(word);
    if (found == names_.end()) refuse("has the unknown name " + word);
    return found->second;
  }

  double number() {
    double value = 0.0;  // from_chars, because strtod follows the locale
    const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (read.ec != std::errc()) refuse("lacks a number or name");
    at_ = size_t(read.ptr - text_.data());
    return value;
  }

  const std::string& text_;
  const std::map<std::string, double>& names_;
  size_t at_ = 0;
  int depth_ = 0;  // of factors in factors
};

}  // namespace

double evaluate(const std::string& expression, const std::map<std::string, double>& names) {
  return Parser(expression, names).parse();
}

}  // namespace markerless_mocap
