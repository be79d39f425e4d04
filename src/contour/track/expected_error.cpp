#include "contour/track/expected_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace markerless_mocap {
namespace {

// Standard deviation of a length over people of one stature, as a fraction, see ShapeStatistics.
constexpr double kLengthDeviation = 0.05;

// A body of the right shape overlaps the silhouettes by 0.93 or more, by 0.88 in loose clothes at
// the least; one that is wrong by some 7 cm overlaps by 0.84.
constexpr double kUsualOverlap = 0.90, kErrorPerOverlap_m = 1.0;

/// The length before the end of each part: along it the end is found by the length alone, as
/// outlines look the same there.
constexpr std::array<BodyLength::Id, kPartCount> kLastLengths{
    BodyLength::kTorso,   BodyLength::kHead,  BodyLength::kForearm,
    BodyLength::kForearm, BodyLength::kShank, BodyLength::kShank};

}  // namespace

void widenExpectedErrors(const TrackedBody& body, const PersonOptions& person, BodyPose& pose) {
  const double of_overlap =
      kErrorPerOverlap_m * std::max(0.0, kUsualOverlap - pose.silhouette_overlap);
  const double of_length =
      body.shape_estimated ? 0.0
                           : std::hypot(kLengthDeviation, person.stature_sigma / person.stature);
  for (size_t part = 0; part < kPartCount; ++part)
    pose.part_sigma_m[part] =
        std::hypot(pose.part_sigma_m[part],
                   std::hypot(of_overlap, of_length * body.shape[kLastLengths[part]]));
}

}  // namespace markerless_mocap
