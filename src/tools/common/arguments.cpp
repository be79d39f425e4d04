#include "tools/common/arguments.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cfloat>
#include <climits>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>

#include "text/number_text.h"
#include "text/printable.h"

namespace markerless_mocap {
namespace {

bool isFinite(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0' && std::isfinite(value);
}

bool isWhole(const std::string& text, long long least, long long most) {
  char* end = nullptr;
  errno = 0;
  const long long value = std::strtoll(text.c_str(), &end, 10);
  return end != text.c_str() && *end == '\0' && errno == 0 && value >= least && value <= most;
}

struct NumberRange {
  double least = -HUGE_VAL, most = HUGE_VAL;
  std::string words;
};

/// \param check of the library, such as "POSITIVE" or "INT in [5 - 100]"
NumberRange rangeOf(const std::string& check) {
  if (check == "POSITIVE") return {DBL_MIN, HUGE_VAL, " above 0"};
  if (check == "NONNEGATIVE") return {0.0, HUGE_VAL, " from 0"};
  NumberRange range;
  const size_t open = check.find('[');
  if (open != std::string::npos &&
      std::sscanf(check.c_str() + open, "[%lf - %lf]", &range.least, &range.most) == 2)
    range.words = ", " + numberText(range.least) + " to " + numberText(range.most);
  return range;
}

/// What an option of numbers takes if this is not among it; empty if it is, or for other options.
std::string allowedInPlaceOf(const std::string& text, const CLI::Option& option) {
  const std::string type = option.get_type_name();  // such as INT, or INT:INT in [5 - 100]
  const size_t colon = type.find(':');
  const std::string kind = type.substr(0, colon);
  const NumberRange range =
      colon == std::string::npos ? NumberRange() : rangeOf(type.substr(colon + 1));
  const double value = std::strtod(text.c_str(), nullptr);
  const bool outside = value < range.least || value > range.most;
  if (kind == "FLOAT" && (!isFinite(text) || outside)) return "finite numbers" + range.words;
  if (kind == "UINT" && (!isWhole(text, 0, LLONG_MAX) || outside))
    return "whole numbers" + (range.words.empty() ? " from 0" : range.words);
  if (kind == "INT" && (!isWhole(text, INT_MIN, INT_MAX) || outside))
    return "whole numbers" + (range.words.empty() ? " of up to nine digits" : range.words);
  return "";
}

/// The first number among the arguments that cannot be used, as a sentence; empty if there is none.
std::string faultyNumberIn(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& text : option->results())
      if (const std::string allowed = allowedInPlaceOf(text, *option); !allowed.empty())
        return option->get_name() + " is '" + text + "', allowed are " + allowed;
  for (const CLI::App* command : app.get_subcommands())
    if (const std::string fault = faultyNumberIn(*command); !fault.empty()) return fault;
  return "";
}

/// An option that is given too often, or a switch with a value; empty if there is none.
std::string miscountedIn(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string> texts = option->results();
    const bool is_switch = option->get_items_expected_max() == 0;
    for (const std::string& text : texts)
      if (is_switch && text != "true" && text != "false")
        return option->get_name() + " is given the value '" + text + "', allowed is none";
    if (texts.size() > 1 && option->get_items_expected_max() <= 1)
      return option->get_name() + " is given " + std::to_string(texts.size()) +
             " times, allowed is once";
  }
  for (const CLI::App* command : app.get_subcommands())
    if (const std::string fault = miscountedIn(*command); !fault.empty()) return fault;
  return "";
}

/// A positional argument is not one.
bool isOption(const std::string& text, const CLI::App& app) {
  return text.rfind("--", 0) == 0 || (text.rfind('-', 0) == 0 && app.get_option_no_throw(text));
}

/// An option that has taken the next option for its value; empty if there is none.
std::string valuelessIn(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) continue;
    for (const std::string& text : option->results())
      if (isOption(text, app))
        return option->get_name() + " is given without its value, allowed is one, before " + text;
  }
  for (const CLI::App* command : app.get_subcommands())
    if (const std::string fault = valuelessIn(*command); !fault.empty()) return fault;
  return "";
}

/// In place of the library's words, if they can be bettered.
std::string faultIn(const CLI::App& app, const CLI::ParseError& error) {
  if (const std::string fault = valuelessIn(app); !fault.empty()) return fault;
  if (const std::string fault = faultyNumberIn(app); !fault.empty()) return fault;
  if (const std::string fault = miscountedIn(app); !fault.empty()) return fault;
  const std::string words = error.what();  // such as "--rig: 1 required TEXT missing"
  const std::string missing = ": 1 required ";
  if (const size_t at = words.find(missing); at != std::string::npos)
    return words.substr(0, at) + " is given without its value, allowed is one";
  return words;
}

int refuse(const CLI::App& app, const std::string& fault, int code) {
  std::cerr << app.get_name() << ": " << printable(fault)
            << "\nRun with --help for more information.\n";
  return code;
}

}  // namespace

std::optional<int> parseArguments(CLI::App& app, int argc, char** argv) {
  constexpr auto kRefused = int(CLI::ExitCodes::ConversionError);
  try {
    app.parse(argc, argv);
    if (const std::string fault = valuelessIn(app); !fault.empty())
      return refuse(app, fault, kRefused);
    if (const std::string fault = faultyNumberIn(app); !fault.empty())
      return refuse(app, fault, kRefused);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // prints the help
    return refuse(app, faultIn(app, error), error.get_exit_code());
  }
}

}  // namespace markerless_mocap
