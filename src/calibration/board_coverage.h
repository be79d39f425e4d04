#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "calibration/board.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// How much is enough to calibrate a rig.
struct CoverageGoals {
  int views = 20;           ///< that differ, of each camera
  int tilted = 6;           ///< of those, by more than 20 degrees: they give the focal length
  double covered = 0.5;     ///< part of the image's cells in which a corner was seen
  int shared = 8;           ///< differing views of two cameras at the same time, to join them
  double same_time = 0.03;  ///< s: views closer than this are of one time
};

/// What one camera has seen of the board.
struct CameraCoverage {
  static constexpr int kColumns = 8, kRows = 6;
  std::string name;
  int views = 0, tilted = 0;
  std::array<bool, kColumns * kRows> cells{};  ///< row by row: whether a corner was seen there
  std::vector<int> shared;                     ///< with each camera, itself left at 0

  double covered() const;  ///< part of the cells, 0 to 1
};

/// Says what is still missing while a board is waved. A view counts if the board has moved clearly
/// in the image since every view that counted before.
class BoardCoverage {
 public:
  BoardCoverage(const Board& board, std::vector<CameraToCalibrate> cameras,
                const CoverageGoals& goals = {});

  /// Views of one time, at most one per camera. Returns whether any of them counted.
  bool add(const std::vector<BoardView>& views);
  const std::vector<CameraCoverage>& cameras() const { return coverage_; }
  const CoverageGoals& goals() const { return goals_; }
  /// What to do, the most urgent first; empty: the views suffice.
  std::vector<std::string> missing() const;
  /// One line for each camera: what it has, of what is wanted.
  std::string table() const;

 private:
  bool isNew(const BoardView& view) const;
  void count(const BoardView& view);
  std::string emptyPlaces(const CameraCoverage& camera) const;
  /// Cameras joined to the first one by shared views.
  std::vector<bool> joinedToFirst() const;

  Board board_;
  std::vector<CameraToCalibrate> cameras_;
  CoverageGoals goals_;
  std::vector<CameraCoverage> coverage_;
  std::vector<std::vector<BoardCorners>> counted_;  ///< by camera
};

/// By how much a board is tilted against the image plane, rad, as far as its corners tell without a
/// lens: from how much one direction is shortened. 0 for fewer than four corners.
double tiltOf(const Board& board, const BoardCorners& corners);

/// Mean distance of the corners that both show, pixels; infinity if there are none.
double distanceBetween(const BoardCorners& a, const BoardCorners& b);

}  // namespace markerless_mocap
