#include "camera/timing_remarks.h"

#include <cmath>
#include <cstdio>

namespace markerless_mocap {
namespace {

constexpr double kLong = 10.0, kDay = 86400.0;  // s

std::string span(double seconds) {
  const double size = std::abs(seconds);
  char text[64];
  if (size < kLong)
    std::snprintf(text, sizeof text, "%.1f ms", 1e3 * size);
  else if (size < kDay)
    std::snprintf(text, sizeof text, "%.1f s", size);
  else
    std::snprintf(text, sizeof text, "%.1f days", size / kDay);
  return text;
}

const char* direction(double seconds) {
  return seconds > 0.0 ? "later" : "earlier";
}

}  // namespace

std::string lagRemark(const std::string& camera, const StreamTiming& timing,
                      const AssemblerOptions& options) {
  const bool followed = options.max_drift > 0.0;
  const double allowed = followed ? options.max_drift : options.tolerance;
  if (!(std::abs(timing.lag) > allowed / 2.0)) return "";
  return camera + "'s stamps are " + span(timing.lag) + ' ' + direction(timing.lag) +
         " than the others', " + (followed ? "drift is followed up to " : "allowed are ") +
         span(allowed);
}

std::string stepRemark(double tolerance, double in_step) {
  if (tolerance <= in_step) return "";
  return "the cameras are not in step: images up to " + span(tolerance) +
         " apart are one frame set, each taken at the time of its stamp";
}

std::string missRemark(const std::string& camera, const StreamTiming& timing) {
  if (!timing.nearest) return camera + " is left out, nothing comes from it";
  return camera + " is left out, its nearest stamp is " + span(*timing.nearest) + ' ' +
         direction(*timing.nearest);
}

}  // namespace markerless_mocap
