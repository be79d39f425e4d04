#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "markerless_mocap/evaluation/joint_error.h"
#include "markerless_mocap/evaluation/joint_track.h"

namespace markerless_mocap {

/// The ends of a body that a labeller names: head, left_hand, right_hand, left_foot, right_foot.
constexpr int kEndCount = 5;
const std::array<const char*, kEndCount>& endNames();

/// What a labeller says about one frame; as it is, it says nothing.
struct LabelledEnds {
  bool valid = false;     ///< whether it stands by the rest
  double validity = 0.0;  ///< its own estimate of how probably all five are right, 0..1
  /// Ends by endNames(), metres: the middle of the head, knuckles, balls of the feet. NaN where one
  /// is not found.
  Eigen::Matrix<double, 3, kEndCount> positions =
      Eigen::Matrix<double, 3, kEndCount>::Constant(NAN);
};

/// Names of the true points that ends are held against: head and head_top, l_hand (knuckles) and
/// l_hand_tip, l_foot (ball) and l_foot_tip, the same of the right.
std::vector<std::string> labelTruthNames();

/// One frame judged.
struct LabelVerdict {
  bool judged = false;    ///< the truth has all points; else nothing below is filled
  bool valid = false;     ///< the labeller stands by it
  bool complete = false;  ///< all five ends are found
  /// Whether each end is right: the nearest true end, left and right distinct, is the one it is
  /// named for, and that one's point or tip is at most 150 mm away (head: 250 mm).
  std::array<bool, kEndCount> end_right{};
  bool right = false;  ///< all five are
  /// Whether neither the hands nor the feet lie nearer to the true ones, in the sum of both, when
  /// they change sides. False when one of them is not found.
  bool sides_right = false;
  /// Distance to the middle of the head, knuckles or ball of the foot, mm; NaN if not found.
  std::array<double, kEndCount> error_mm{};
};

/// What the frames would be whose validity reaches a threshold, were they the valid ones.
struct ThresholdFigures {
  double threshold;
  double precision;  ///< share of them that is right; NaN if there are none
  double recall;     ///< share of the right frames, valid or not, that is among them
};

/// One end over the valid frames.
struct EndError {
  std::string name;
  double share_right;
  Spread error_mm;
};

/// A labeller over a sequence. Shares are of the judged frames unless told otherwise; NaN without
/// any. A frame in which nothing was said is not valid and not right.
struct LabelErrors {
  std::vector<LabelVerdict> verdicts;  ///< per frame of the truth
  size_t frames = 0, valid = 0;        ///< judged, and of these valid
  double share_valid, share_right, share_right_and_valid, share_wrong_but_valid;
  double share_sides_right;                    ///< of the valid frames
  std::vector<EndError> ends;                  ///< by endNames()
  Spread hands_mm, feet_mm;                    ///< left and right, over the valid frames
  Spread hands_if_right_mm, feet_if_right_mm;  ///< over those in which all five are right
  std::vector<ThresholdFigures> by_threshold;  ///< from 0 to 1; only complete frames can reach it
  /// Area under precision over recall, each threshold's step with its precision; 1 when every right
  /// frame has a higher validity than every wrong one. NaN without right frames.
  double precision_recall_area;
};

/// \param truth track with labelTruthNames() \param labels one for each of its frames; throws
///   std::invalid_argument otherwise
LabelErrors labelErrors(const JointTrack& truth, const std::vector<LabelledEnds>& labels);

}  // namespace markerless_mocap
