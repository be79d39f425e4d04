#include "checks/motion/check_framing.h"

#include "checks/text/sentence.h"

namespace markerless_mocap {
namespace {

constexpr int kFewMoments = 20;  // with a person in two cameras or more
constexpr double kMost = 0.5;    // of them
constexpr int kNeeded = 2;       // cameras that show an end of the body

/// At how many moments two cameras or more show a person, and at how many of them fewer than
/// kNeeded show where they end.
struct Cut {
  int seen = 0, cut = 0;
};

Cut cutAt(BodyEnd end, const RigSight& sight, const RigModel& model) {
  Cut out;
  for (const double moment : sight.moments) {
    int cameras = 0, whole = 0;
    for (const CameraModel& camera : model) {
      const auto inside = endsInside(sight.tracks[camera.source], camera.calibration, camera.turn,
                                     end, moment - camera.offset);
      cameras += inside.has_value();
      whole += inside.value_or(false);
    }
    if (cameras < 2) continue;
    ++out.seen;
    out.cut += whole < kNeeded;
  }
  return out;
}

void check(BodyEnd end, const char* part, const char* border, const RigSight& sight,
           const RigModel& model, Findings* findings) {
  const Cut cut = cutAt(end, sight, model);
  if (cut.seen < kFewMoments || cut.cut <= kMost * cut.seen) return;
  findings->push_back(
      {"images_cut_person", "", Severity::kWarning,
       sentence("in %.0f %% of the time the person goes beyond the %s border of the images, in all "
                "cameras or in all but one",
                100.0 * cut.cut / cut.seen, border),
       sentence("let two cameras or more show the person from head to foot: turn them, set them "
                "farther away, or let the person step back; a pose begins with %s",
                part)});
}

}  // namespace

void checkFraming(const RigSight& sight, const RigModel& model, Findings* findings) {
  check(BodyEnd::kLower, "legs that are seen", "lower", sight, model, findings);
  check(BodyEnd::kUpper, "a head that is seen", "upper", sight, model, findings);
}

}  // namespace markerless_mocap
