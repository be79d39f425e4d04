#include "markerless_mocap/products/body_parts.h"

namespace markerless_mocap {

const char* toString(PartLabel label) {
  constexpr const char* kNames[kPartCount] = {"torso", "head", "arm 1", "arm 2", "leg 1", "leg 2"};
  return kNames[size_t(label)];
}

std::string unseenParts(const std::array<bool, kPartCount>& seen) {
  constexpr const char* kNames[kPartCount] = {"torso",     "head",     "left arm",
                                              "right arm", "left leg", "right leg"};
  std::string names;
  for (size_t part = 0; part < seen.size(); ++part)
    if (!seen[part]) names += (names.empty() ? "" : ", ") + std::string(kNames[part]);
  return names.empty() ? "" : names + " not seen";
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
