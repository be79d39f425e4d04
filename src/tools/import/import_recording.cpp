#include "tools/import/import_recording.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "tools/common/camera_table.h"

namespace markerless_mocap {
namespace {

void checkRange(const char* option, double value, double lowest, double highest) {
  if (value >= lowest && value <= highest) return;  // false for NaN
  std::ostringstream message;
  message << option << " is " << value << ", allowed is " << lowest << " to " << highest;
  throw std::invalid_argument(message.str());
}

}  // namespace

void ImportOptions::validate() const {
  world.validate();
  checkRange("fps", fps, 0.0, 1000.0);
  checkRange("start-stamp", start_stamp, 1e-3, 4e9);  // 0 is not a valid time in a bag
  checkRange("jpeg", jpeg_quality, 0, 100);
}

int64_t ImportOptions::stampOf(int frame_set, double frame_sets_per_second) const {
  return std::llround(1e9 * (start_stamp + frame_set / frame_sets_per_second));
}

void print(const ImportResult& result, std::ostream& out) {
  out << result.cameras.size() << " cameras, " << result.frame_sets << " frame sets at "
      << std::setprecision(4) << result.fps << " per second\n"
      << std::setprecision(6);
  printCameras(result.cameras, out);
  for (const std::string& remark : result.warnings) out << "note: " << remark << '\n';
}

}  // namespace markerless_mocap
