#include "files/toml_text.h"

#include <stdexcept>
#include <utility>

namespace markerless_mocap {
namespace {

constexpr const char* kNoValue =
    "a value is none: allowed are numbers, texts in quotes, true and false, lists in [ ] and "
    "tables "
    "in { }";

/// In plain words, what the library says in those of its parser. The first that it holds counts.
std::string plainWords(const std::string& description) {
  static constexpr std::pair<const char*, const char*> kWords[] = {
      {"utf", "it has bytes that are no UTF-8 text"},
      {"redefine", "a key or table stands twice"},
      {"nested", "lists and tables nest too deep"},
      {"parsing array", "a list that begins with [ has no comma or ]"},
      {"parsing inline table", "a table that begins with { has no comma or }"},
      {"parsing table header", "a head line is not [NAME]"},
      {"string", "a text in quotes has no end, or signs that it may not hold"},
      {"representable", "a number is too large"},
      {"floating-point", "a number is not written as one"},
      {"integer", "a number is not written as one"},
      {"parsing value", kNoValue},
      {"parsing boolean", kNoValue},
      {"parsing date", kNoValue},
      {"parsing time", kNoValue},
  };
  for (const auto& [word, meaning] : kWords)
    if (description.find(word) != std::string::npos) return meaning;
  return "it is not KEY = VALUE or [NAME]";
}

}  // namespace

toml::table tomlFrom(const std::string& text, const std::string& where) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& fault) {
    throw std::invalid_argument(
        where + ", line " + std::to_string(fault.source().begin.line) +
        ": this is no TOML: " + plainWords(std::string(fault.description())));
  }
}

}  // namespace markerless_mocap
