#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

const char* toString(PartLabel label) {
  constexpr const char* kNames[kPartCount] = {"torso", "head", "arm 1", "arm 2", "leg 1", "leg 2"};
  return kNames[size_t(label)];
}

const char* toString(SegmentationStatus status) {
  switch (status) {
    case SegmentationStatus::kOk:
      return "ok";
    case SegmentationStatus::kPartial:
      return "partial";
    default:
      return "invalid";
  }
}

}  // namespace markerless_mocap
