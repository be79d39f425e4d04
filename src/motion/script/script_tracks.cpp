#include "motion/script/script_tracks.h"

#include <array>
#include <initializer_list>

namespace markerless_mocap {
namespace {

CurveValues values(std::initializer_list<double> list) {
  CurveValues v(Eigen::Index(list.size()));
  Eigen::Index i = 0;
  for (double value : list) v[i++] = value;
  return v;
}

std::array<TrackRow, kTrackCount> makeTable() {
  std::array<TrackRow, kTrackCount> table;
  const auto row = [&](Track track, const char* name, std::initializer_list<double> neutral,
                       std::initializer_list<double> minimum,
                       std::initializer_list<double> maximum) {
    table[size_t(track)] = {name, values(neutral), values(minimum), values(maximum)};
  };
  row(Track::kDrop, "drop", {0}, {-0.05}, {0.4});
  row(Track::kShift, "shift", {0, 0}, {-0.3, -0.2}, {0.3, 0.2});
  row(Track::kPelvis, "pelvis", {0, 0, 0}, {-40, -30, -60}, {80, 30, 60});
  row(Track::kTrunk, "trunk", {0, 0, 0}, {-30, -40, -60}, {90, 40, 60});
  row(Track::kHead, "head", {0, 0, 0}, {-50, -40, -80}, {60, 40, 80});
  row(Track::kArmSwing, "arm_swing", {1}, {0}, {3});
  for (const bool left : {true, false}) {
    row(left ? Track::kLeftArm : Track::kRightArm, left ? "left_arm" : "right_arm", {2, 9, 8, 14},
        {-70, -50, -90, 0}, {200, 180, 90, 150});
    row(left ? Track::kLeftWrist : Track::kRightWrist, left ? "left_wrist" : "right_wrist", {15, 8},
        {-90, -70}, {90, 80});
    row(left ? Track::kLeftReach : Track::kRightReach, left ? "left_reach" : "right_reach",
        {0, 0.5, 0, -0.5}, {0, -1.2, -1.2, -1.2}, {1, 1.2, 1.2, 1.2});
    row(left ? Track::kLeftGrasp : Track::kRightGrasp, left ? "left_grasp" : "right_grasp",
        {0, 0.2, 0.1, 0.5}, {0, -1, -1, 0}, {1, 1, 1, 1.4});
  }
  return table;
}

const std::array<TrackRow, kTrackCount>& table() {
  static const std::array<TrackRow, kTrackCount> rows = makeTable();
  return rows;
}

}  // namespace

const TrackRow& trackRow(Track track) {
  return table()[size_t(track)];
}

std::vector<std::string> trackNames() {
  std::vector<std::string> names;
  for (const TrackRow& row : table()) names.push_back(row.name);
  return names;
}

}  // namespace markerless_mocap
