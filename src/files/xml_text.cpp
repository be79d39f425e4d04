#include "files/xml_text.h"

#include <tinyxml2.h>

#include <stdexcept>

namespace markerless_mocap {
namespace {

const char* plainWords(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "a tag has no end, or that of another";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "tags nest too deep";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "text stands where a tag belongs";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "an attribute is not NAME=\"VALUE\", or stands twice";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "a comment has no end -->";
    default:
      return "a tag or attribute is not complete";
  }
}

}  // namespace

std::string xmlFault(const tinyxml2::XMLDocument& parsed) {
  const tinyxml2::XMLError error = parsed.ErrorID();
  if (error == tinyxml2::XML_ERROR_EMPTY_DOCUMENT || (!parsed.Error() && !parsed.RootElement()))
    return "the text is empty or has no tags";
  if (!parsed.Error()) return "";
  return "the text is no XML from line " + std::to_string(parsed.ErrorLineNum()) +
         " on: " + plainWords(error);
}

void readXml(const std::string& text, const std::string& where, tinyxml2::XMLDocument* document) {
  document->Parse(text.data(), text.size());
  const std::string fault = xmlFault(*document);
  if (!fault.empty()) throw std::invalid_argument(where + ": " + fault);
}

}  // namespace markerless_mocap
