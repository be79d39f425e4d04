#include "tools/common/arguments.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "tools/common/run_tool.h"

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

/// What an option of numbers takes if this is not among it; empty if it is, or for other options.
std::string allowedInPlaceOf(const std::string& text, const CLI::Option& option) {
  const std::string type = option.get_type_name();  // such as INT, or INT:INT in [5 - 100]
  const size_t colon = type.find(':');
  const std::string kind = type.substr(0, colon);
  const std::string check = colon == std::string::npos ? "" : " (" + type.substr(colon + 1) + ")";
  if (kind == "FLOAT" && !isFinite(text)) return "finite numbers" + check;
  if (kind == "UINT" && !isWhole(text, 0, LLONG_MAX)) return "whole numbers from 0" + check;
  if (kind == "INT" && !isWhole(text, INT_MIN, INT_MAX))
    return "whole numbers of up to nine digits" + check;
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

int refuse(const CLI::App& app, const std::string& fault, int code) {
  std::cerr << app.get_name() << ": " << printable(fault)
            << "\nRun with --help for more information.\n";
  return code;
}

}  // namespace

std::optional<int> parseArguments(CLI::App& app, int argc, char** argv) {
  constexpr auto kNumberRefused = int(CLI::ExitCodes::ConversionError);
  try {
    app.parse(argc, argv);
    if (const std::string fault = faultyNumberIn(app); !fault.empty())
      return refuse(app, fault, kNumberRefused);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // prints the help
    const std::string fault = faultyNumberIn(app);
    return refuse(app, fault.empty() ? error.what() : fault, error.get_exit_code());
  }
}

}  // namespace markerless_mocap
