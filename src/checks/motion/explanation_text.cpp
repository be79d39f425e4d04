#include "checks/motion/explanation_text.h"

#include <cmath>

#include "checks/text/sentence.h"

namespace markerless_mocap {
namespace {

constexpr double kDegrees = 180 / M_PI;

const char* nameOf(ExplanationKind kind) {
  switch (kind) {
    case ExplanationKind::kRotationInverted:
      return "rotation_inverted";
    case ExplanationKind::kTranslationInverted:
      return "translation_inverted";
    case ExplanationKind::kPoseInverted:
      return "pose_inverted";
    case ExplanationKind::kBodyAxes:
      return "axes_not_optical";
    case ExplanationKind::kUpsideDown:
      return "image_upside_down";
    case ExplanationKind::kMirrored:
      return "image_mirrored";
    case ExplanationKind::kExchanged:
      return "cameras_exchanged";
    case ExplanationKind::kTimeOffset:
      return "time_offset";
    case ExplanationKind::kDrift:
      return "clock_drifts";
    case ExplanationKind::kTurned:
      return "camera_turned";
    case ExplanationKind::kFocalLength:
      return "focal_length_wrong";
    case ExplanationKind::kDistortion:
      break;
  }
  return "distortion_wrong";
}

std::string remedyOf(const Explanation& e) {
  switch (e.kind) {
    case ExplanationKind::kRotationInverted:
      return "the transform must turn camera coordinates into world coordinates: give the "
             "transposed "
             "rotation (the conjugate quaternion)";
    case ExplanationKind::kTranslationInverted:
      return "the translation must be the camera's place in the world, -R^T t of the calibration's "
             "R "
             "and t: convert_calibration does this";
    case ExplanationKind::kPoseInverted:
      return "the transform was given the wrong way round: publish its inverse, camera to world";
    case ExplanationKind::kBodyAxes:
      return "the frame of camera_info must be the optical one (x right, y down, z forward): use "
             "the "
             "frame <camera>_optical, or add the rotation from body to optical axes";
    case ExplanationKind::kUpsideDown:
      return "turn the images by 180 degrees, or calibrate them as they are";
    case ExplanationKind::kMirrored:
      return "switch mirroring off in the driver";
    case ExplanationKind::kExchanged:
      return "exchange the two cameras' topics, or their calibrations";
    case ExplanationKind::kTimeOffset:
      return sentence(
          "write time_offset: %.4f for this camera into the rig file, or synchronise "
          "the clocks",
          e.amount);
    case ExplanationKind::kDrift:
      return "synchronise the clocks while recording (chrony, PTP) or trigger the cameras together";
    case ExplanationKind::kTurned:
      return "calibrate again, or let mocap_offline --self-calibrate correct small turns; fasten "
             "the "
             "camera";
    case ExplanationKind::kFocalLength:
      return "calibrate the lens again at this size; do not touch zoom, and switch autofocus off";
    case ExplanationKind::kDistortion:
      break;
  }
  return "give the lens distortion D as calibrate_rig finds it; do not give zeros for images that "
         "were not rectified, nor distortion for images that were";
}

std::string durationOf(double seconds) {
  return seconds < 2 ? sentence("%.0f ms", 1e3 * seconds) : sentence("%.2f s", seconds);
}

std::string amountOf(const Explanation& e) {
  switch (e.kind) {
    case ExplanationKind::kTimeOffset:
      return sentence("the person moves in it %s %s in the other cameras",
                      durationOf(std::abs(e.amount)).c_str(),
                      e.amount < 0 ? "later than" : "before");
    case ExplanationKind::kDrift:
      return sentence("its stamps run %.1f ms per second %s than those of the other cameras",
                      1e3 * std::abs(e.amount), e.amount < 0 ? "faster" : "slower");
    case ExplanationKind::kTurned:
      return sentence("it fits if it is turned by %.2f degrees", e.amount * kDegrees);
    case ExplanationKind::kFocalLength:
      return sentence("it fits with %.2f times the focal length", e.amount);
    case ExplanationKind::kDistortion:
      return sentence("it fits if k1 is changed by about %+.2f", e.amount);
    default:
      return "the silhouettes agree when this is undone";
  }
}

}  // namespace

Finding findingOf(const Explanation& e, const std::vector<std::string>& names) {
  Finding finding;
  finding.what = nameOf(e.kind);
  if (e.cameras.size() < names.size() || names.size() <= 2)
    for (const size_t camera : e.cameras)
      finding.camera += (finding.camera.empty() ? "" : ", ") + names[camera];
  finding.severity = Severity::kError;
  finding.evidence =
      sentence("the person is %.1f px from where the other cameras see him; ", e.before) +
      amountOf(e);
  for (size_t i = 0; i < e.amounts.size(); ++i)
    finding.evidence += sentence("%s%s %.2f", i == 0 ? " at most (" : ", ", names[i].c_str(),
                                 e.amounts[i] * kDegrees);
  if (!e.amounts.empty()) finding.evidence += ")";
  if (e.cameras.size() == 1) finding.evidence += sentence(" (%.1f px are left)", e.after);
  if (e.instead.size() == 2)
    finding.evidence += "; an exchange of " + names[e.instead[0]] + " and " + names[e.instead[1]] +
                        " would look nearly the same";
  finding.remedy = remedyOf(e);
  return finding;
}

}  // namespace markerless_mocap
