#include "checks/text/sentence.h"

#include <cstdarg>
#include <cstdio>

namespace markerless_mocap {

std::string sentence(const char* format, ...) {
  char text[600];
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

}  // namespace markerless_mocap
