#pragma once

#include <array>
#include <vector>

#include "checks/motion/rig_model.h"

namespace markerless_mocap {

/// Directions in which a camera sees the marks, at even times of its own clock: index * step after
/// its first image. A direction is zero where a mark is not seen.
struct SightGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double focal = 0;  ///< pixels of kModelWidth per radian
  double first = 0;  ///< s, clock of the camera, of the first direction
  std::array<std::vector<Eigen::Vector3d>, kBodyMarks> directions;
  int marks = 0;  ///< number of directions that are not zero

  int size() const { return int(directions[0].size()); }
  bool has(int mark, int index) const {
    return index >= 0 && index < size() && !directions[size_t(mark)][size_t(index)].isZero(0.0);
  }
};

/// \param step s
SightGrid sightGridOf(const PersonTrack& track, const CameraModel& model, double step);

/// A point that others see, and the square of how far their rays miss it, px^2.
struct GridPoint {
  int index = 0, mark = 0;
  Eigen::Vector3d place;
  double missed = 0;
  double sine2 = 0;  ///< square of the sine of the angle between the rays
};

/// Where two cameras see the marks if the clock of b is `shift` steps ahead of that of a. Places
/// that are behind a camera are missed by far; where the rays are nearly parallel there are none.
/// \param first index of a, and every so many steps from there
std::vector<GridPoint> pointsOf(const SightGrid& a, const SightGrid& b, int shift, int first,
                                int every);

/// How well points are met, summed.
struct GridLoss {
  double sum = 0;
  int count = 0;
};
/// \param shift steps to be added to the clock of the camera, to get that of the points
GridLoss lossOf(const SightGrid& camera, const std::vector<GridPoint>& points, int shift);

}  // namespace markerless_mocap
