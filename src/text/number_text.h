#pragma once

#include <array>
#include <charconv>
#include <string>

namespace markerless_mocap {

/// The shortest text that is read as the same number.
inline std::string numberText(double number) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

/// Numbers between commas.
template <class Numbers>
std::string numbersText(const Numbers& numbers) {
  std::string out;
  for (const double number : numbers) out += (out.empty() ? "" : ", ") + numberText(number);
  return out;
}

}  // namespace markerless_mocap
