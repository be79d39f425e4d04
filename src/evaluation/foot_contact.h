#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"

namespace markerless_mocap {

// A point of a foot rests on the floor while it is not higher above its lowest place than
// kContactRise_m, moves slower than kContactSpeed_m_s, measured over kContactSpan_s about the
// frame, and does so for kShortestContact_s.
constexpr double kContactRise_m = 0.03;
constexpr double kContactSpeed_m_s = 0.15;
constexpr double kContactSpan_s = 0.1;
constexpr double kShortestContact_s = 0.1;

/// Soles deeper below the floor than this are an error that is seen, mm.
constexpr double kPenetrationLimit_mm = 10.0;

/// Frames in a row in which a point rests.
struct ContactRun {
  size_t first = 0, frames = 0;
  double seconds = 0.0;  ///< from its first to its last frame
};

/// How far an estimated point travels across the floor while the true one rests on it.
struct FootSkate {
  ContactRun run;
  /// Greatest horizontal distance from where it is first; NaN without estimate.
  double max_slide_mm;
  double path_mm_per_s;  ///< horizontal way from frame to frame by its time; NaN below two frames
  double true_max_slide_mm, true_path_mm_per_s;  ///< the same of the truth
};

/// Contact of one point of a foot.
struct FootContact {
  std::string name;                   ///< of the point, as l_foot
  std::vector<FootSkate> contacts;    ///< by the truth
  std::vector<bool> truth, estimate;  ///< per frame, whether it rests
  /// Share of the estimate's contact frames that are the truth's too, and the other way round, over
  /// frames with truth and estimate; NaN without any.
  double precision, recall;
  SummaryStatistics max_slide_mm, path_mm_per_s, true_max_slide_mm,
      true_path_mm_per_s;  ///< over the contacts
};

/// \param truth, estimate tracks of the same frames \param name of the point with its side; the
///   lowest place is that of both sides' points, of either track its own (5th percentile of the
///   heights), since where in the flesh a point sits is a convention. The floor is level.
/// Throws std::invalid_argument unless both have the same frames.
FootContact footContact(const JointTrack& truth, const JointTrack& estimate,
                        const std::string& name);

/// A foot's sole and the floor at z = 0.
struct SoleStatistics {
  size_t frames = 0;              ///< with a sole
  double fraction_below;          ///< of them deeper than kPenetrationLimit_mm; NaN without any
  double mean_below_mm;           ///< mean depth, counting 0 above the floor
  double deepest_mm;              ///< 0 if never below
  SummaryStatistics standing_mm;  ///< height while the true foot rests, below the floor negative
};

/// \param heights_m of the sole's lowest point above the floor per frame, NaN without estimate
/// \param resting whether the true foot rests; throws std::invalid_argument unless as many
SoleStatistics soleStatistics(const std::vector<double>& heights_m,
                              const std::vector<bool>& resting);

}  // namespace markerless_mocap
