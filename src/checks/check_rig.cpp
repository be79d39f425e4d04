#include "checks/check_rig.h"

#include <algorithm>
#include <set>

#include "checks/calibration/check_calibration.h"
#include "checks/motion/check_motion.h"
#include "checks/pictures/check_pictures.h"
#include "checks/stamps/check_stamps.h"

namespace markerless_mocap {
namespace {

using Names = std::set<std::string>;

/// Findings that others bring about by themselves.
struct Consequence {
  Names causes, effects;
};

const std::vector<Consequence>& consequences() {
  static const std::vector<Consequence> all{
      {{"rotation_inverted", "translation_inverted", "pose_inverted", "axes_not_optical"},
       {"no_common_volume", "world_z_down", "world_z_not_up", "volume_cuts_person"}},
      {{"units_not_metres", "world_z_down", "world_z_not_up"}, {"volume_cuts_person"}},
      // Silhouettes from such pictures are no person's, or where he was.
      {{"image_covered", "image_dark", "image_overexposed", "image_blurred", "images_frozen",
        "camera_moved"},
       {"camera_turned", "time_offset", "clock_drifts", "focal_length_wrong", "distortion_wrong",
        "rotation_inverted", "image_mirrored", "image_upside_down", "exposure_wanders",
        "white_balance_wanders"}},
      // Nobody sees the middle of a person who is cut off.
      {{"images_cut_person"}, {"person_stays"}},
      // Another focal length bends the rays, too.
      {{"focal_length_wrong"}, {"distortion_wrong"}},
      {{"poses_identical"},
       {"camera_turned", "rotation_inverted", "pose_inverted", "translation_inverted",
        "axes_not_optical", "cameras_exchanged", "focal_length_wrong", "distortion_wrong"}},
      {{"camera_info_size", "camera_info_implausible"},
       {"no_common_volume", "focal_length_wrong", "distortion_wrong", "camera_turned"}}};
  return all;
}

bool concern(const Finding& cause, const Finding& effect) {
  return cause.camera.empty() || effect.camera.empty() ||
         cause.camera.find(effect.camera) != std::string::npos;
}

bool isConsequence(const Finding& finding, const Findings& all) {
  for (const Consequence& rule : consequences())
    if (rule.effects.count(finding.what))
      for (const Finding& cause : all)
        if (rule.causes.count(cause.what) && concern(cause, finding)) return true;
  return false;
}

/// The search may correct one thing in two steps.
bool isSaid(const Finding& finding, const Findings& said) {
  return std::any_of(said.begin(), said.end(), [&](const Finding& other) {
    return other.what == finding.what && other.camera == finding.camera;
  });
}

}  // namespace

const char* toString(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      break;
  }
  return "error";
}

Findings checkRig(const SeenRig& rig) {
  Findings all;
  checkMessages(rig, &all);
  checkStamps(rig, &all);
  checkGeometry(rig, &all);
  checkSharpness(rig, &all);
  checkLight(rig, &all);
  checkMovedCameras(rig, &all);
  checkMotion(rig, &all);
  Findings causes;
  for (const Finding& finding : all)
    if (!isConsequence(finding, all) && !isSaid(finding, causes)) causes.push_back(finding);
  std::stable_sort(causes.begin(), causes.end(), [](const Finding& a, const Finding& b) {
    return int(a.severity) > int(b.severity);
  });
  return causes;
}

std::vector<std::string> notChecked(const SeenRig& rig) {
  std::vector<std::string> out;
  const std::string motion = motionNotChecked(rig);
  if (!motion.empty()) out.push_back(motion);
  return out;
}

}  // namespace markerless_mocap
