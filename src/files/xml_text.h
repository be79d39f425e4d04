#pragma once

#include <string>

namespace tinyxml2 {
class XMLDocument;
}

namespace markerless_mocap {

/// In which line a text that was parsed is no XML, and why, in plain words. Empty if it is XML and
/// has a tag.
std::string xmlFault(const tinyxml2::XMLDocument& parsed);

/// Parses what somebody has written as XML. Throws std::invalid_argument with line and reason if it
/// is none or has no tags. \param where how the sentence names the text, for example its file
void readXml(const std::string& text, const std::string& where, tinyxml2::XMLDocument* document);

}  // namespace markerless_mocap
