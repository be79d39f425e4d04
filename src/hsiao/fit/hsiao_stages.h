#pragma once

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "hsiao/fit/hsiao_hierarchical_fitter.h"

namespace markerless_mocap::hsiao_stages {

/// The parameters and parts that the stages of a search are made of.

using Active = std::array<bool, kPartCount>;
using Parameters = std::vector<int>;

inline const Parameters kCenter = {0, 1, 2};
inline const Parameters kNeck = {3, 4, 5};
inline const Parameters kSpin = {6};
inline const Parameters kHead = {7, 8};
inline const Parameters kArms = {9, 10, 11, 12, 13, 14, 15, 16};
inline const Parameters kLegs = {17, 18, 19, 20, 21, 22};
inline const std::array<Parameters, 2> kArm = {Parameters{9, 11, 13, 15},
                                               Parameters{10, 12, 14, 16}};
inline const std::array<Parameters, 2> kLeg = {Parameters{17, 19, 21}, Parameters{18, 20, 22}};

inline constexpr Active kTorsoOnly = {true};
inline constexpr Active kTorsoHead = {true, true};
inline constexpr Active kTorsoToArms = {true, true, true, true};
inline constexpr Active kAll = {true, true, true, true, true, true};
inline constexpr Active kHeadOnly = {false, true};
inline constexpr Active kArmsOnly = {false, false, true, true};
inline constexpr Active kLegsOnly = {false, false, false, false, true, true};

/// Range of a stage around the values that earlier stages found: metres, radians.
constexpr double kFirstCenterReach = 0.2;
constexpr double kFirstNeckReach = 0.25;
constexpr double kPlaceReach = 0.1;
constexpr double kAngleReach = 0.6;

inline Parameters join(std::initializer_list<Parameters> groups) {
  Parameters all;
  for (const Parameters& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

inline bool hasArms(const HsiaoSkeletonError& e) {
  return e.has(PartLabel::kArm1) || e.has(PartLabel::kArm2);
}
inline bool hasLegs(const HsiaoSkeletonError& e) {
  return e.has(PartLabel::kLeg1) || e.has(PartLabel::kLeg2);
}

inline void narrow(HsiaoBounds& range, const HsiaoVector& v, const Parameters& parameters,
                   double reach) {
  for (const int p : parameters) {
    range.lower[p] = std::max(range.lower[p], v[p] - reach);
    range.upper[p] = std::min(range.upper[p], v[p] + reach);
  }
}

}  // namespace markerless_mocap::hsiao_stages
