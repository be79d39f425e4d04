#pragma once

#include <string>
#include <vector>

namespace markerless_mocap {

/// Adds a word to words between commas.
inline void addWord(std::string* list, const std::string& word) {
  if (!list->empty()) *list += ", ";
  *list += word;
}

/// Words between commas.
inline std::string joined(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) addWord(&list, word);
  return list;
}

/// The texts of items between commas.
template <class Items, class TextOf>
std::string joined(const Items& items, const TextOf& textOf) {
  std::string list;
  for (const auto& item : items) addWord(&list, textOf(item));
  return list;
}

}  // namespace markerless_mocap
