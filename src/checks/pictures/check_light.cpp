#include <algorithm>
#include <cmath>

#include "checks/pictures/check_pictures.h"
#include "checks/pictures/light_gain_track.h"
#include "checks/text/sentence.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr size_t kFewImages = 30;
constexpr double kFlicker = 0.025;  // relative standard deviation from image to image
constexpr double kWander = 0.05, kColorWander = 0.01;  // relative, 5th to 95th percentile
constexpr double kSwitch = 0.12;                       // between two images
constexpr size_t kSmooth = 9;                          // images

std::vector<double> brightnessOf(const LightTrack& track) {
  std::vector<double> values;
  for (const auto& gain : track.gains) values.push_back((gain[0] + gain[1] + gain[2]) / 3);
  return values;
}

std::vector<double> smoothed(const std::vector<double>& values) {
  std::vector<double> out;
  for (size_t i = 0; i < values.size(); ++i) {
    const size_t low = i < kSmooth / 2 ? 0 : i - kSmooth / 2;
    const size_t high = std::min(values.size(), i + kSmooth / 2 + 1);
    out.push_back(nearestQuantile(
        {values.begin() + std::ptrdiff_t(low), values.begin() + std::ptrdiff_t(high)}, 0.5));
  }
  return out;
}

double rangeOf(const std::vector<double>& values) {
  return nearestQuantile(values, 0.95) - nearestQuantile(values, 0.05);
}

/// The strongest period, as the fraction of the variance that a sine of it explains.
struct Beat {
  double hertz = 0, share = 0, amplitude = 0;
};
Beat strongestBeat(const std::vector<double>& seconds, const std::vector<double>& values) {
  const size_t n = values.size();
  const double mean = nearestQuantile(values, 0.5);
  const double length = seconds.back() - seconds.front(), rate = double(n - 1) / length;
  double variance = 0;
  for (const double value : values) variance += (value - mean) * (value - mean);
  Beat best;
  for (double hertz = 3 / length; hertz < 0.5 * rate; hertz += 0.25 / length) {
    double sine = 0, cosine = 0;
    for (size_t i = 0; i < n; ++i) {
      sine += (values[i] - mean) * std::sin(2 * M_PI * hertz * seconds[i]);
      cosine += (values[i] - mean) * std::cos(2 * M_PI * hertz * seconds[i]);
    }
    const double power = 2 * (sine * sine + cosine * cosine) / double(n);
    if (power > best.share * variance)
      best = {hertz, power / variance, std::sqrt(2 * power / double(n))};
  }
  return best;
}

/// Standard deviation of what changes from image to image.
double flickerOf(const std::vector<double>& values, const std::vector<double>& slow) {
  std::vector<double> fast;
  for (size_t i = 0; i < values.size(); ++i) fast.push_back(values[i] - slow[i]);
  return (nearestQuantile(fast, 0.84) - nearestQuantile(fast, 0.16)) / 2;
}

bool checkFlicker(const SeenCamera& camera, const std::vector<double>& seconds,
                  const std::vector<double>& values, double flicker, Findings* findings) {
  const Beat beat = strongestBeat(seconds, values);
  const bool periodic = beat.share > 0.6 && beat.amplitude > kFlicker;
  if (flicker < kFlicker && !periodic) return false;
  findings->push_back(
      {"light_flickers", camera.name, Severity::kWarning,
       periodic ? sentence("the brightness swings by +-%.1f %% at %.2f Hz, as lamps on 50 or 60 Hz "
                           "mains make it",
                           100 * beat.amplitude, beat.hertz)
                : sentence("the brightness changes by %.1f %% (standard deviation) from image to "
                           "image",
                           100 * flicker),
       "set the exposure time to a multiple of 1/100 s (50 Hz mains) or 1/120 s (60 Hz), or use "
       "lamps that do not flicker; keep silhouette/compensate_flicker on"});
  return true;
}

double largestStep(const std::vector<double>& slow) {
  double most = 0;
  for (size_t i = 2; i < slow.size(); ++i)
    most = std::max(most, std::abs(slow[i] / slow[i - 2] - 1));
  return most;
}

void checkWhiteBalance(const SeenCamera& camera, const LightTrack& track, Findings* findings) {
  double most = 0;
  for (const size_t channel : {size_t(0), size_t(2)}) {
    std::vector<double> ratios;
    for (const auto& gain : track.gains) ratios.push_back(gain[channel] / gain[1]);
    most = std::max(most, rangeOf(smoothed(ratios)));
  }
  if (most < kColorWander) return;
  findings->push_back(
      {"white_balance_wanders", camera.name, Severity::kWarning,
       sentence("red or blue of what stands still change by %.1f %% against green", 100 * most),
       "switch automatic white balance off (v4l2-ctl "
       "--set-ctrl=white_balance_automatic=0) and set one value for all cameras"});
}

/// Wandering brightness of each camera; lamps change all of them.
struct Wander {
  double range = 0, step = 0;
};

void report(const SeenRig& rig, const std::vector<Wander>& wanders, Findings* findings) {
  size_t stepped = 0;
  for (const Wander& wander : wanders) stepped += wander.step > kSwitch;
  const bool lamp = rig.cameras.size() > 1 && 2 * stepped > rig.cameras.size();
  if (lamp) {
    double most = 0;
    for (const Wander& wander : wanders) most = std::max(most, wander.step);
    findings->push_back({"light_switched", "", Severity::kWarning,
                         sentence("the brightness of %zu cameras changes at once, by up to %.0f %%",
                                  stepped, 100 * most),
                         "keep lamps as they are while recording, and shut out changing daylight"});
  }
  for (size_t i = 0; i < wanders.size(); ++i)
    if (wanders[i].range > kWander && !lamp)
      findings->push_back(
          {"exposure_wanders", rig.cameras[i].name, Severity::kWarning,
           sentence("the brightness of what stands still changes by %.0f %% over the recording",
                    100 * wanders[i].range),
           "switch automatic exposure and gain off (v4l2-ctl --set-ctrl=auto_exposure=1 and "
           "exposure_time_absolute), and shut out changing daylight"});
}

}  // namespace

void checkLight(const SeenRig& rig, Findings* findings) {
  std::vector<Wander> wanders(rig.cameras.size());
  for (size_t i = 0; i < rig.cameras.size(); ++i) {
    const SeenCamera& camera = rig.cameras[i];
    if (camera.masks_only) continue;
    const LightTrack track = lightTrackOf(camera.images);
    if (track.gains.size() < kFewImages || track.seconds.back() <= track.seconds.front()) continue;
    const std::vector<double> values = brightnessOf(track), slow = smoothed(values);
    checkWhiteBalance(camera, track, findings);
    if (checkFlicker(camera, track.seconds, values, flickerOf(values, slow), findings)) continue;
    wanders[i] = {rangeOf(slow), largestStep(slow)};
  }
  report(rig, wanders, findings);
}

}  // namespace markerless_mocap
