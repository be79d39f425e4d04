#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "pages/page.h"

namespace markerless_mocap {

/// Reads what a page holds back from its HTML.

inline std::vector<uint8_t> bytesOfBase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<uint8_t> bytes;
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | uint32_t(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(uint8_t(bits >> count));
  }
  return bytes;
}

template <class Number>
std::vector<Number> unpacked(const std::string& base64) {
  const std::vector<uint8_t> bytes = bytesOfBase64(base64);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}
inline std::vector<float> floatsOf(const Json& base64) {
  return unpacked<float>(base64.get<std::string>());
}

/// {"title", "parts"}
inline Json contentOf(const std::string& html) {
  const std::string start = "id=\"data\">";
  const size_t begin = html.find(start) + start.size();
  return Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

/// The parts of a kind after a heading, until the next one of the same or a higher level; of the
/// whole page if the heading is empty.
inline std::vector<Json> partsUnder(const Json& content, const std::string& heading,
                                    const std::string& kind) {
  std::vector<Json> parts;
  int level = heading.empty() ? 9 : 0;
  for (const Json& part : content["parts"]) {
    const bool is_heading = part["kind"] == "heading" && !heading.empty();
    if (is_heading && level > 0 && part["level"] <= level) break;
    if (is_heading && part["text"] == heading) level = part["level"];
    if (level > 0 && part["kind"] == kind) parts.push_back(part);
  }
  return parts;
}

/// The first of them; throws std::runtime_error if there is none.
inline Json partUnder(const Json& content, const std::string& heading, const std::string& kind) {
  const std::vector<Json> parts = partsUnder(content, heading, kind);
  if (parts.empty()) throw std::runtime_error("no " + kind + " under " + heading);
  return parts.front();
}

inline Json lastUnder(const Json& content, const std::string& heading, const std::string& kind) {
  const std::vector<Json> parts = partsUnder(content, heading, kind);
  if (parts.empty()) throw std::runtime_error("no " + kind + " under " + heading);
  return parts.back();
}

inline bool hasPart(const Json& content, const std::string& heading, const std::string& kind) {
  return !partsUnder(content, heading, kind).empty();
}

/// Whether one of the texts of a page has these words.
inline bool says(const Json& content, const std::string& words) {
  for (const Json& part : content["parts"])
    for (const char* member : {"text", "caption"})
      if (part.contains(member) && part[member].get<std::string>().find(words) != std::string::npos)
        return true;
  return false;
}

}  // namespace markerless_mocap
