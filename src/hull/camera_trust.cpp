#include "hull/camera_trust.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {
namespace {

/// -1 if it is no number.
double numberIn(const char* begin, const char* end) {
  double number = -1;
  const auto read = std::from_chars(begin, end, number);
  return read.ec == std::errc() && read.ptr == end ? number : -1;
}

}  // namespace

std::vector<double> trustIn(const std::vector<std::string>& cameras,
                            const std::vector<std::string>& entries) {
  std::vector<double> result(cameras.size(), 1.0);
  for (const std::string& entry : entries) {
    const size_t equals = entry.rfind('=');
    const bool is_pair = equals != std::string::npos;
    const auto camera = std::find(cameras.begin(), cameras.end(), entry.substr(0, equals));
    const double trust =
        is_pair ? numberIn(entry.data() + equals + 1, entry.data() + entry.size()) : -1;
    if (camera == cameras.end() || !(trust >= 0 && trust <= 1))
      throw std::invalid_argument(std::string(HullOptions::kStage) + "/camera_trust has '" + entry +
                                  "', allowed is <camera of the rig>=<0 to 1>");
    result[size_t(camera - cameras.begin())] = trust;
  }
  return result;
}

}  // namespace markerless_mocap
