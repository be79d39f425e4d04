#pragma once

#include <string>

namespace markerless_mocap {

/// A text of others for messages and terminals: without control characters but new lines, and not
/// endless.
inline std::string printable(const std::string& text, size_t longest = 2000) {
  std::string shown = text.substr(0, longest);
  for (char& letter : shown)
    if ((static_cast<unsigned char>(letter) < ' ' && letter != '\n') || letter == '\x7f')
      letter = '?';
  return shown + (text.size() > longest ? " ..." : "");
}

/// The same in one line.
inline std::string printableLine(const std::string& text, size_t longest = 2000) {
  std::string line = printable(text, longest);
  for (char& letter : line)
    if (letter == '\n') letter = ' ';
  return line;
}

/// A name or word of others, such as a frame_id, in quotation marks.
inline std::string quoted(const std::string& word) {
  return '"' + printableLine(word, 80) + '"';
}

}  // namespace markerless_mocap
