#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

const char* toString(PoseStatus status) {
  switch (status) {
    case PoseStatus::kLost:
      return "lost";
    case PoseStatus::kTracked:
      return "tracked";
    case PoseStatus::kReinitialized:
      return "reinitialized";
  }
  return "unknown";
}

}  // namespace markerless_mocap
