#include "checks/stamps/check_stamps.h"

#include <algorithm>
#include <cmath>

#include "checks/stamps/stream_times.h"
#include "checks/text/sentence.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr size_t kFewImages = 5;       // say nothing of the spacing of fewer
constexpr double kMostMissing = 0.01;  // of a camera's images
constexpr double kMostMissingIrregular = 0.06;
constexpr double kMostRepeated = 0.02;
constexpr int kLongRepeat = 10;  // images in a row
/// Of a period. Cameras by software trigger reach a twentieth.
constexpr double kMostJitter = 0.12, kLeastJitter = 0.0015;  // s
constexpr double kReceived = 0.0005;                         // s: stamp and reception are the same
constexpr double kRateRatio = 0.02;

using Streams = std::vector<StreamTimes>;

void checkOrder(const SeenCamera& camera, const StreamTimes& times, Findings* findings) {
  const int images = int(camera.images.size());
  if (times.zero > 0)
    findings->push_back({"stamps_zero", camera.name, Severity::kError,
                         sentence("%d of %d images have the stamp 0", times.zero, images),
                         "set header.stamp in the camera's driver to the time of exposure"});
  if (times.backwards > 0)
    findings->push_back({"stamps_jump_back", camera.name, Severity::kError,
                         sentence("the stamps go back %d times, by up to %.3f s", times.backwards,
                                  times.worst_back),
                         "do not set the clock while recording (chrony in place of ntpdate), do "
                         "not loop a bag into "
                         "a recording, and have one driver only publish this topic"});
  if (times.doubled > 0)
    findings->push_back(
        {"stamps_doubled", camera.name, Severity::kWarning,
         sentence("%d of %d images have the stamp of the image before", times.doubled, images),
         "look for two drivers or two bags on the same topic"});
}

bool isIrregular(const StreamTimes& times) {
  return times.jitter >= std::max(kLeastJitter, kMostJitter * times.period);
}

void checkGaps(const SeenCamera& camera, const StreamTimes& times, Findings* findings) {
  double share = times.missing / double(times.missing + camera.images.size());
  if (isIrregular(times)) {  // single gaps mean nothing
    const double length = 1e-9 * double(times.last_ns - times.first_ns) + times.period;
    share = 1 - double(camera.images.size()) * times.period / length;
  }
  if (share <= (isIrregular(times) ? kMostMissingIrregular : kMostMissing)) return;
  findings->push_back(
      {"images_dropped", camera.name, share > 0.2 ? Severity::kError : Severity::kWarning,
       sentence("%.1f %% of the images are missing, up to %d in a row (%.1f images per second)",
                100 * share, times.longest_gap, 1.0 / times.period),
       "lower the rate or the size of the images, give the camera a USB controller or network link "
       "of its own, record to a faster disk (rosbag record --buffsize 0)"});
}

void checkSpacing(const SeenCamera& camera, const StreamTimes& times, Findings* findings) {
  if (!isIrregular(times)) return;
  const bool received = std::abs(times.delay) < kReceived && times.delay_spread < kReceived;
  const std::string by = sentence("the stamps differ by %.1f ms from even spacing (%.1f ms)",
                                  1e3 * times.jitter, 1e3 * times.period);
  if (received)
    findings->push_back({"stamps_of_reception", camera.name, Severity::kWarning,
                         by + " and are the times at which the messages were recorded",
                         "stamp images where they are captured (the driver's option for device or "
                         "trigger times), not where they are received"});
  else
    findings->push_back({"stamps_jitter", camera.name, Severity::kWarning, by,
                         "use the camera's own time or a hardware trigger; fix the exposure time, "
                         "which changes the rate of many webcams"});
}

void checkRepeats(const SeenRig& rig, size_t at, const std::vector<Repeats>& repeats,
                  Findings* findings) {
  const Repeats& here = repeats[at];
  const size_t images = rig.cameras[at].images.size();
  const double share = double(here.images) / double(std::max<size_t>(1, images));
  int alike = 0;  // a scene without noise, in which nothing moves, repeats in all cameras
  for (size_t i = 0; i < repeats.size(); ++i)
    alike += i != at && 2 * repeats[i].images > here.images;
  if ((share < kMostRepeated && here.longest < kLongRepeat) || 2 * alike > int(repeats.size()) - 1)
    return;
  findings->push_back(
      {"images_frozen", rig.cameras[at].name, Severity::kError,
       sentence("%.0f %% of the images are the same as the one before, up to %d in a row",
                100 * share, here.longest),
       "restart the camera; if it comes again, look for a driver that repeats the last image when "
       "none has come, and for a loose cable"});
}

double usualPeriod(const Streams& streams) {
  std::vector<double> periods;
  for (const StreamTimes& times : streams)
    if (times.period > 0) periods.push_back(times.period);
  return nearestQuantile(periods, 0.5);
}

void checkRate(const SeenCamera& camera, const StreamTimes& times, double usual,
               Findings* findings) {
  if (times.period == 0 || std::abs(times.period / usual - 1) < kRateRatio) return;
  findings->push_back(
      {"rate_differs", camera.name, Severity::kWarning,
       sentence("%.2f images per second, the other cameras have %.2f", 1 / times.period, 1 / usual),
       "set the same rate for all cameras; long exposure lowers the rate of many"});
}

/// Cameras whose stamps lie outside of those of most others.
void checkCommonTime(const SeenRig& rig, const Streams& streams, Findings* findings) {
  std::vector<double> firsts, lasts;
  for (const StreamTimes& times : streams)
    if (times.first_ns != 0) {
      firsts.push_back(1e-9 * double(times.first_ns));
      lasts.push_back(1e-9 * double(times.last_ns));
    }
  const double first = nearestQuantile(firsts, 0.5), last = nearestQuantile(lasts, 0.5);
  for (size_t i = 0; i < streams.size(); ++i) {
    if (streams[i].first_ns == 0) continue;
    const double from = 1e-9 * double(streams[i].first_ns), to = 1e-9 * double(streams[i].last_ns);
    const double common = std::min(to, last) - std::max(from, first);
    if (common > 0.5 * (last - first) || last <= first) continue;
    findings->push_back(
        {"clocks_apart", rig.cameras[i].name, Severity::kError,
         sentence("its stamps begin %.3f s %s those of the other cameras, which last %.1f s",
                  std::abs(from - first), from > first ? "after" : "before", last - first),
         "synchronise the computers' clocks (chrony, PTP), or write the difference as time_offset "
         "into the rig file"});
  }
}

}  // namespace

void checkStamps(const SeenRig& rig, Findings* findings) {
  Streams streams;
  std::vector<Repeats> repeats;
  for (const SeenCamera& camera : rig.cameras) {
    streams.push_back(timesOf(camera.images));
    repeats.push_back(repeatsOf(camera.images));
  }
  const double usual = usualPeriod(streams);
  for (size_t i = 0; i < streams.size(); ++i) {
    checkOrder(rig.cameras[i], streams[i], findings);
    checkRepeats(rig, i, repeats, findings);
    if (rig.cameras[i].images.size() < kFewImages) continue;
    checkGaps(rig.cameras[i], streams[i], findings);
    checkSpacing(rig.cameras[i], streams[i], findings);
    checkRate(rig.cameras[i], streams[i], usual, findings);
  }
  checkCommonTime(rig, streams, findings);
}

}  // namespace markerless_mocap
