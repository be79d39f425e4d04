#include "fuzz_target.h"
#include "markerless_mocap/camera/rig_file.h"

using namespace markerless_mocap;

namespace {

void check(bool holds) {
  if (!holds) throw std::logic_error("a rig does not come back from its own text");
}

// A rig that was accepted can be written, read again, and be used.
void useRig(const std::vector<CameraCalibration>& rig) {
  const auto again = rigFromText(rigText(rig), "again");
  check(again.size() == rig.size());
  for (const CameraCalibration& calibration : again)
    Camera(calibration).project(Eigen::Vector3d(0.3, -0.2, 1.1));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  refusesOrReads([&] { useRig(rigFromText(textOf(data, size), "fuzz")); });
  return 0;
}
