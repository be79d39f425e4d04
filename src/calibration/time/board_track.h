#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/start/board_pose.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// Points that move with the board, in the frame of a camera, metres: its centre, one off its
/// printed side, and one beside the centre unless the board looks the same turned.
using BoardPlace = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// The way of the board before one camera.
struct BoardTrack {
  std::vector<double> times;  ///< s, clock of the camera, ascending
  std::vector<BoardPlace> places;
  double interval = 0.0;  ///< s, median between views

  /// None where the board was not seen before and after.
  std::optional<BoardPlace> at(double time) const;
};

/// \param poses of the board in each view
BoardTrack boardTrackOf(const Board& board, size_t camera, const std::vector<BoardView>& views,
                        const std::vector<BoardPose>& poses);

/// How well the motion of the board fits one shift between two clocks.
struct ShiftFit {
  int steps = 0;      ///< of kFitStep in which both cameras see the board; 0: too few
  double gain = 0.0;  ///< natural logarithm of how many times nearer the ways come by one rigid
                      ///< motion than those of a board that does not move would
};
constexpr double kFitStep = 0.5;  ///< s

/// \param shift s, added to the clock of b
ShiftFit fitOf(const BoardTrack& a, const BoardTrack& b, double shift);

}  // namespace markerless_mocap
