#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"

namespace markerless_mocap {

// A point of a foot is in contact with the floor if it is at most kContactRise_m above its rest
// height and slower than kContactSpeed_m_s, measured over kContactSpan_s around the frame, for at
// least kMinContact_s.
constexpr double kContactRise_m = 0.03;
constexpr double kContactSpeed_m_s = 0.15;
constexpr double kContactSpan_s = 0.1;
constexpr double kMinContact_s = 0.1;

/// Soles deeper below the floor than this count as a visible error, mm.
constexpr double kPenetrationLimit_mm = 10.0;

/// Consecutive frames in which a point is in contact.
struct ContactRun {
  size_t first = 0, frames = 0;
  double seconds = 0.0;  ///< from its first to its last frame
};

/// Foot skate: motion of an estimated point across the floor while the true point is in contact
/// with it.
struct FootSkate {
  ContactRun run;
  /// Maximum horizontal distance from its first position; NaN without estimate.
  double max_slide_mm;
  double path_mm_per_s;  ///< horizontal path length per time; NaN below two frames
  double true_max_slide_mm, true_path_mm_per_s;  ///< the same of the truth
};

/// Contact of one point of a foot.
struct FootContact {
  std::string name;                   ///< name of the point, for example l_foot
  std::vector<FootSkate> contacts;    ///< contacts of the truth
  std::vector<bool> truth, estimate;  ///< per frame, whether the point is in contact
  /// Fraction of the estimate's contact frames that are contact frames of the truth, and the
  /// reverse, over frames with truth and estimate; NaN without any.
  double precision, recall;
  SummaryStatistics max_slide_mm, path_mm_per_s, true_max_slide_mm,
      true_path_mm_per_s;  ///< over the contacts
};

/// \param truth, estimate tracks of the same frames
/// \param name of the point with its side
/// The rest height is the 5th percentile of the heights of both sides' points, separately for truth
/// and estimate, as the exact position of a point in the foot is a convention. The floor is assumed
/// to be level.
/// Throws std::invalid_argument unless both have the same frames.
FootContact footContact(const JointTrack& truth, const JointTrack& estimate,
                        const std::string& name);

/// A foot's sole and the floor at z = 0.
struct SoleStatistics {
  size_t frames = 0;      ///< with a sole
  double fraction_below;  ///< fraction of frames deeper than kPenetrationLimit_mm; NaN without any
  double mean_below_mm;   ///< mean depth, 0 above the floor
  double deepest_mm;      ///< maximum depth; 0 if never below
  SummaryStatistics
      standing_mm;  ///< height while the true foot is in contact; negative below the floor
};

/// \param heights_m height of the sole's lowest point above the floor per frame, metres; NaN
///   without estimate
/// \param resting per frame, whether the true foot is in contact; throws std::invalid_argument
///   unless the sizes are equal
SoleStatistics soleStatistics(const std::vector<double>& heights_m,
                              const std::vector<bool>& resting);

}  // namespace markerless_mocap
