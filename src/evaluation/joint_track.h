#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Named points of one person over time, in the world.
struct JointTrack {
  std::vector<std::string> names;
  std::vector<int64_t> stamps_ns;  ///< ascending
  /// [frame](3 x names), metres; a column with a NaN is missing.
  std::vector<Eigen::Matrix3Xd> positions;

  size_t frames() const { return stamps_ns.size(); }
  /// Column of a name; -1 if there is none.
  int indexOf(const std::string& name) const;
  /// Appends a frame. Throws std::invalid_argument unless it has a column for each name and is
  /// later than the last one.
  void add(int64_t stamp_ns, Eigen::Matrix3Xd points);
  /// The same track with these names only, in this order; what it does not have is missing.
  JointTrack select(const std::vector<std::string>& wanted) const;
};

/// Median of the time between frames, ns; 0 below two frames.
int64_t frameTime(const std::vector<int64_t>& stamps_ns);

/// For each wanted stamp the index of the nearest given one, at most `tolerance_ns` away; -1 where
/// there is none. A given stamp serves the nearest wanted one only. Both lists ascend.
std::vector<int> matchStamps(const std::vector<int64_t>& wanted_ns,
                             const std::vector<int64_t>& given_ns, int64_t tolerance_ns);

/// Stamps of one frame, in any clock, lie closer than this share of the frame time.
constexpr double kStampTolerance = 0.45;

/// The estimate at the stamps and with the names of the truth: nearest stamps within
/// kStampTolerance of the truth's frame time, missing elsewhere.
JointTrack alignedTo(const JointTrack& truth, const JointTrack& estimate);

}  // namespace markerless_mocap
