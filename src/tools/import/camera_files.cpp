#include "tools/import/camera_files.h"

#include <glob.h>

#include <cstdio>
#include <regex>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr int kMaxCameraNumber = 999;

std::string withNumber(const std::smatch& conversion, int number) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "%0*d",
                conversion[1].length() ? std::stoi(conversion[1]) : 1, number);
  return conversion.prefix().str() + digits + conversion.suffix().str();
}

std::vector<std::string> filesMatching(const std::string& pattern) {
  glob_t found{};
  std::vector<std::string> files;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return files;
}

}  // namespace

std::map<int, std::vector<std::string>> filesByCamera(const std::string& pattern) {
  static const std::regex kNumber("%0?([0-9]?)d");
  std::smatch conversion;
  if (!std::regex_search(pattern, conversion, kNumber))
    throw std::runtime_error("the pattern " + pattern +
                             " has no %d or %02d for the number of the camera");
  std::map<int, std::vector<std::string>> files;
  for (int number = 0; number <= kMaxCameraNumber; ++number) {
    const auto found = filesMatching(withNumber(conversion, number));
    if (!found.empty()) files[number] = found;
  }
  if (files.empty()) throw std::runtime_error("no file matches " + pattern);
  return files;
}

}  // namespace markerless_mocap
