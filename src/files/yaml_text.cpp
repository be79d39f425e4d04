#include "files/yaml_text.h"

#include <map>
#include <stdexcept>

namespace markerless_mocap {
namespace {

/// In plain words, what the library says in those of its parser.
std::string plainWords(const std::string& message) {
  static const std::map<std::string, const char*> kWords = {
      {"bad file", "it nests deeper than the 500 levels that are allowed"},
      {"bad conversion", "a value is missing or not of the kind that is allowed"},
      {"end of sequence flow not found", "a list that begins with [ has no comma or ]"},
      {"end of map flow not found", "a map that begins with { has no comma or }"},
      {"illegal map value",
       "a colon is where no key can be: lines of one map begin in one column, and texts with a "
       "colon need quotes"},
      {"illegal block entry", "the - of a list is where no list can begin"},
      {"illegal EOF in scalar", "a text in quotes has no end"},
      {"unknown token", "a value begins with a sign that none can begin with, unless in quotes"},
      {"end of map not found", "a line belongs to no map: those of one map begin in one column"},
      {"end of sequence not found", "a line belongs to no list: those of one begin in one column"},
  };
  const auto found = kWords.find(message);
  return found == kWords.end() ? message : found->second;
}

}  // namespace

std::string sentenceOf(const YAML::Exception& fault) {
  if (fault.mark.is_null()) return plainWords(fault.msg);
  return plainWords(fault.msg) + " (line " + std::to_string(fault.mark.line + 1) + ", column " +
         std::to_string(fault.mark.column + 1) + ")";
}

YAML::Node yamlFrom(const std::string& text, const std::string& where) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& fault) {
    throw std::invalid_argument(where + " is no YAML: " + sentenceOf(fault));
  }
}

std::vector<YAML::Node> yamlDocumentsFrom(const std::string& text, const std::string& where) {
  try {
    return YAML::LoadAll(text);
  } catch (const YAML::Exception& fault) {
    throw std::invalid_argument(where + " is no YAML: " + sentenceOf(fault));
  }
}

}  // namespace markerless_mocap
