#include "capture/scene/studio_motion.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "motion/bvh.h"
#include "motion/clip_editing.h"
#include "motion/motion_script.h"
#include "motion/retarget.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

constexpr double kReturnSeconds = 1.0;
constexpr double kBelow = 0.3,
                 // Lower and upper bound of the volume, metres below and above the floor.
    kAbove = 3.0;

std::string motionsIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string& name : names) list += name + ", ";
  return list;
}

double apart(const HumanPose& a, const HumanPose& b) {
  double max_difference = (a.hips - b.hips).norm();
  for (size_t i = 0; i < size_t(kBoneCount); ++i)
    max_difference = std::max(max_difference, a.R_world_bone[i].angularDistance(b.R_world_bone[i]));
  return max_difference;
}

bool isBvh(const std::string& motion) {
  const std::string extension = fs::path(motion).extension();
  return extension == ".bvh" || extension == ".BVH";
}

MotionClip clipOf(const std::string& motion, const std::string& folder,
                  const HumanSkeleton& skeleton) {
  if (isBvh(motion)) return retarget(readBvh(motion), skeleton, motion);
  if (fs::path(motion).extension() == ".yaml")
    return performMotion(readMotionScript(motion), skeleton);
  const fs::path own = fs::path(folder) / (motion + ".yaml");
  if (!fs::is_regular_file(own))
    throw std::invalid_argument("there is no motion \"" + motion + "\", allowed are " +
                                motionsIn(folder) + "or path of a .yaml or .bvh file");
  return performMotion(readMotionScript(own.string()), skeleton);
}

}  // namespace

MotionClip loadMotion(const StudioOptions& options, const std::string& folder,
                      const HumanSkeleton& skeleton) {
  MotionClip clip = clipOf(options.motion, folder, skeleton);
  if (options.motion_start > 0.0) clip = cut(clip, options.motion_start, HUGE_VAL);
  // A motion bent to a circle can continue; any other starts again at its beginning.
  if (options.bend_radius != 0.0) {
    if (options.duration > clip.duration()) clip = extended(clip, options.duration);
    clip = bent(clip, options.bend_radius);
  }
  if (isBvh(options.motion)) clip = centred(onFloor(clip, skeleton));
  const double side = options.volume_half_width;
  const Eigen::AlignedBox3d volume(Eigen::Vector3d(-side, -side, -kBelow),
                                   Eigen::Vector3d(side, side, kAbove));
  const std::string excess = volumeViolation(clip, skeleton, volume);
  if (!excess.empty()) throw std::invalid_argument("motion " + options.motion + ": " + excess);
  return clip;
}

LoopedMotion::LoopedMotion(MotionClip clip) : clip_(std::move(clip)) {
  if (clip_.poses.empty()) throw std::invalid_argument("the motion has no poses");
  constexpr double kSame = 0.05;  // metres and radians
  return_seconds_ =
      apart(clip_.poses.front(), clip_.poses.back()) < kSame ? 1.0 / clip_.fps : kReturnSeconds;
}

HumanPose LoopedMotion::at(double seconds) const {
  const double since = seconds - period() * std::floor(seconds / period());
  if (since <= clip_.duration()) return clip_.at(since);
  const double fraction = (since - clip_.duration()) / return_seconds_;
  const double smooth = fraction * fraction * (3.0 - 2.0 * fraction);
  return interpolate(clip_.poses.back(), clip_.poses.front(), smooth);
}

}  // namespace markerless_mocap
