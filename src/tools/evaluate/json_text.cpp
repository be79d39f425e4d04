#include "tools/evaluate/json_text.h"

#include <cmath>
#include <cstdio>

namespace markerless_mocap {

std::string JsonObject::number(double value) {
  if (!std::isfinite(value)) return "null";
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string JsonObject::quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", c);
      out += escape;
    } else {
      out += c;
    }
  }
  return out + '"';
}

void JsonObject::put(const std::string& key, std::string value) {
  if (!members_.empty()) members_ += ",\n";
  members_ += quoted(key) + ": " + value;
}

void JsonObject::add(const std::string& key, double value) {
  put(key, number(value));
}

void JsonObject::add(const std::string& key, size_t value) {
  put(key, std::to_string(value));
}

void JsonObject::add(const std::string& key, const std::string& value) {
  put(key, quoted(value));
}

void JsonObject::add(const std::string& key, const JsonObject& value) {
  put(key, value.text());
}

void JsonObject::addList(const std::string& key, const std::string& values) {
  put(key, "[" + values + "]");
}

std::string JsonObject::text(int indent) const {
  const std::string space(indent, ' ');
  std::string out = space + "{\n" + space + ' ';
  for (const char c : members_) {
    out += c;
    if (c == '\n') out += space + ' ';
  }
  return out + '\n' + space + '}';
}

}  // namespace markerless_mocap
