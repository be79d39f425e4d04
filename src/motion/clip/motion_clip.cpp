#include "motion/motion_clip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {

HumanPose MotionClip::at(double seconds) const {
  if (poses.empty()) throw std::invalid_argument("the motion has no poses");
  const double place = std::clamp(seconds * fps, 0.0, double(poses.size() - 1));
  const size_t before = std::min(size_t(place), poses.size() - 1);
  const size_t after = std::min(before + 1, poses.size() - 1);
  return interpolate(poses[before], poses[after], place - std::floor(place));
}

}  // namespace markerless_mocap
