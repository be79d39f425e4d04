#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Named points of one person over time, in the world frame.
struct JointTrack {
  std::vector<std::string> names;
  std::vector<int64_t> stamps_ns;  ///< ascending
  /// [frame](3 x names), metres; a column with a NaN is missing.
  std::vector<Eigen::Matrix3Xd> positions;

  size_t frames() const { return stamps_ns.size(); }
  /// Column of a name; -1 if it is not there.
  int indexOf(const std::string& name) const;
  /// Appends a frame. Throws std::invalid_argument unless it has one column per name and is later
  /// than the last frame.
  void add(int64_t stamp_ns, Eigen::Matrix3Xd points);
  /// The same track with these names only, in this order; names that it does not have become
  /// missing points.
  JointTrack select(const std::vector<std::string>& wanted) const;
};

/// The name of the same point on the other side, l_wrist for r_wrist; the name itself if it has no
/// side.
std::string otherSide(const std::string& name);

/// Median time between frames, ns; 0 below two frames.
int64_t frameTime(const std::vector<int64_t>& stamps_ns);

/// For each wanted stamp the index of the nearest given one within `tolerance_ns`, or -1. A given
/// stamp is used only for the wanted stamp nearest to it. Both lists are ascending.
std::vector<int> matchStamps(const std::vector<int64_t>& wanted_ns,
                             const std::vector<int64_t>& given_ns, int64_t tolerance_ns);

/// Stamps closer than this fraction of the frame time belong to one frame.
constexpr double kStampTolerance = 0.45;

/// The estimate with the stamps and names of the truth. Each frame is the one with the nearest
/// stamp within kStampTolerance of the truth's frame time; other frames are missing.
JointTrack alignedTo(const JointTrack& truth, const JointTrack& estimate);

}  // namespace markerless_mocap
