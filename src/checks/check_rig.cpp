#include "checks/check_rig.h"

#include <algorithm>
#include <set>

#include "checks/calibration/check_calibration.h"
#include "checks/motion/check_motion.h"
#include "checks/pictures/check_pictures.h"
#include "checks/stamps/check_stamps.h"

namespace markerless_mocap {
namespace {

/// Findings that a wrong pose brings about by itself.
bool isConsequence(const Finding& finding, const Findings& all) {
  static const std::set<std::string> causes{"rotation_inverted", "translation_inverted",
                                            "pose_inverted", "axes_not_optical"};
  static const std::set<std::string> effects{"no_common_volume", "world_z_down", "world_z_not_up",
                                             "volume_cuts_person"};
  if (effects.count(finding.what) == 0) return false;
  return std::any_of(all.begin(), all.end(), [&](const Finding& other) {
    return (causes.count(other.what) > 0 &&
            (other.camera.empty() || other.camera == finding.camera)) ||
           (finding.what == "volume_cuts_person" &&
            (other.what == "units_not_metres" || other.what.rfind("world_z", 0) == 0));
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
    if (!isConsequence(finding, all)) causes.push_back(finding);
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
