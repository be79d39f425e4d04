#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

const char* toString(HullStatus status) {
  switch (status) {
    case HullStatus::kOk:
      return "ok";
    case HullStatus::kNoCameras:
      return "no cameras";
    case HullStatus::kEmptyMasks:
      return "empty masks";
    case HullStatus::kFullMask:
      return "full mask";
    case HullStatus::kNobody:
      return "nobody";
    case HullStatus::kSeveralBodies:
      return "several bodies";
  }
  return "unknown";
}

}  // namespace markerless_mocap
