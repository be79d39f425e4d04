#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// The ends of a body that a labeller names: head, left_hand, right_hand, left_foot, right_foot.
constexpr int kLabelledExtremityCount = 5;
const std::array<const char*, kLabelledExtremityCount>& extremityNames();

/// What a labeller says about one frame; as it is, it says nothing.
struct LabelledExtremities {
  bool valid = false;     ///< whether it stands by the rest
  double validity = 0.0;  ///< its own estimate of how probably all five are right, 0..1
  /// Ends by extremityNames(), metres: the middle of the head, knuckles, balls of the feet. NaN
  /// where one is not found.
  Eigen::Matrix<double, 3, kLabelledExtremityCount> positions =
      Eigen::Matrix<double, 3, kLabelledExtremityCount>::Constant(NAN);
  /// Points along the limb of each end, from the end upwards, metres; without columns where the
  /// labeller knows ends only.
  std::array<Eigen::Matrix3Xd, kLabelledExtremityCount> limbs;
};

/// Names of the true points that ends are held against: head and head_top, l_hand (knuckles) and
/// l_hand_tip, l_foot (ball) and l_foot_tip, the same of the right. Then those that limbs are held
/// against: wrists, elbows, ankles and knees, which may be missing.
std::vector<std::string> labelTruthNames();

/// One frame judged.
struct LabelEvaluation {
  bool judged = false;    ///< the truth has all ends; else nothing below is filled
  bool valid = false;     ///< the labeller stands by it
  bool complete = false;  ///< all five ends are found
  /// Whether head, hands and feet are what they are called, whichever side they are of: of all true
  /// ends the nearest to each is of its kind, and the two of a pair are at most 150 mm from the
  /// points or tips of two different true ones (head: 250 mm).
  bool kinds_correct = false;
  /// Whether neither the arms nor the legs fit the true ones better when they change sides. What
  /// fits is told along the limbs, since feet that cross lie nearer to each other than a skeleton's
  /// end does to them: the sum, over a pair, of the distances from hand to hand and from the true
  /// wrists and elbows to the labelled limbs; feet, ankles and knees likewise. False when an end of
  /// a pair is not found.
  bool sides_correct = false;
  /// Whether each end is right: its kind is, its pair has the right sides, and its own true point
  /// or tip is within the limit.
  std::array<bool, kLabelledExtremityCount> extremity_correct{};
  bool right = false;  ///< all five ends are
  /// Distance to the middle of the head, knuckles or ball of the foot, mm; NaN if not found.
  std::array<double, kLabelledExtremityCount> error_mm{};
};

/// What the frames would be whose validity reaches a threshold, were they the valid ones.
struct PrecisionRecallPoint {
  double threshold;
  double precision;  ///< share of them that is right; NaN if there are none
  double recall;     ///< share of the right frames, valid or not, that is among them
};

/// Complete frames whose validity lies in one tenth of 0..1. Where validity means what it says, the
/// share is the mean.
struct ReliabilityBin {
  size_t frames;
  double mean_validity, fraction_correct;
};

/// One end over the valid frames.
struct ExtremityLabelError {
  std::string name;
  double fraction_correct;
  SummaryStatistics error_mm;
};

/// A labeller over a sequence. Shares are of the judged frames unless told otherwise; NaN without
/// any. A frame in which nothing was said is not valid and not right.
struct LabelErrors {
  std::vector<LabelEvaluation> verdicts;  ///< per frame of the truth
  size_t frames = 0, valid = 0;           ///< judged, and of these valid
  double fraction_valid, fraction_correct, fraction_correct_and_valid, fraction_wrong_but_valid;
  double fraction_kinds_correct;          ///< valid or not, whatever the sides
  double fraction_sides_correct;          ///< of the valid frames
  std::vector<ExtremityLabelError> ends;  ///< by extremityNames()
  SummaryStatistics hands_mm, feet_mm;    ///< left and right, over the valid frames
  SummaryStatistics hands_if_right_mm,
      feet_if_right_mm;  ///< over those in which all five are right
  /// From 0 to 1; only complete frames can reach it.
  std::vector<PrecisionRecallPoint> by_threshold;
  std::vector<ReliabilityBin> reliability;  ///< by validity; empty tenths are left out
  /// Area under precision over recall, each threshold's step with its precision; 1 when every right
  /// frame has a higher validity than every wrong one. NaN without right frames.
  double precision_recall_area;
};

/// \param truth track with labelTruthNames() \param labels one for each of its frames; throws
///   std::invalid_argument otherwise
LabelErrors labelErrors(const JointTrack& truth, const std::vector<LabelledExtremities>& labels);

}  // namespace markerless_mocap
