#include "markerless_mocap/camera/frame_set_assembler.h"

#include <sstream>

namespace markerless_mocap {
namespace {

template <class T>
void checkRange(const char* key, T value, T min_value, T max_value) {
  if (value >= min_value && value <= max_value) return;  // NaN fails
  std::ostringstream message;
  message << "assembler/" << key << " is " << value << ", allowed is " << min_value << " to "
          << max_value;
  throw std::invalid_argument(message.str());
}

}  // namespace

void AssemblerOptions::validate(size_t streams) const {
  if (streams == 0) throw std::invalid_argument("assembler: there are no streams to join");
  checkRange("tolerance", tolerance, 0.0, 1.0);
  checkRange("deadline", deadline, tolerance, 60.0);
  checkRange("max_jump", max_jump, deadline, 86400.0);
  checkRange("min_streams", min_streams, 1, int(streams));
  checkRange("max_pending", max_pending, 1, 1000);
}

}  // namespace markerless_mocap
