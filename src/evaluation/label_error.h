#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "evaluation/joint_track.h"

namespace markerless_mocap {

/// Extremities that a labelling method names: head, left_hand, right_hand, left_foot, right_foot.
constexpr int kLabelledExtremityCount = 5;
const std::array<const char*, kLabelledExtremityCount>& extremityNames();

/// Labels of one frame. By default there are none.
struct LabelledExtremities {
  bool valid = false;     ///< whether the method reports the labels as valid
  double validity = 0.0;  ///< its estimated probability that all five are correct, 0 to 1
  /// Positions by extremityNames(), metres: centre of the head, knuckles, balls of the feet. NaN if
  /// not found.
  Eigen::Matrix<double, 3, kLabelledExtremityCount> positions =
      Eigen::Matrix<double, 3, kLabelledExtremityCount>::Constant(NAN);
  /// Points along the limb of each extremity, from the extremity upwards, metres; no columns if the
  /// method gives extremities only.
  std::array<Eigen::Matrix3Xd, kLabelledExtremityCount> limbs;
};

/// Names of the true points with which extremities are compared: head and head_top, l_hand
/// (knuckles) and l_hand_tip, l_foot (ball) and l_foot_tip, the same of the right. Then those with
/// which limbs are compared, which may be missing: wrists, elbows, ankles and knees.
std::vector<std::string> labelTruthNames();

/// Evaluation of one frame.
struct LabelEvaluation {
  bool evaluated =
      false;  ///< whether the truth has all extremities; if not, the other fields are not set
  bool valid = false;     ///< reported as valid
  bool complete = false;  ///< all five extremities are found
  /// Whether head, hands and feet are of the kind of their label, on either side: the true
  /// extremity nearest to each is of its kind, and the two of a pair are within 150 mm of the
  /// points or tips of two different true ones (head: 250 mm).
  bool kinds_correct = false;
  /// Whether neither the arms nor the legs fit the true ones better after an exchange of sides. The
  /// limbs are compared along their length, as crossed feet are nearer to each other than a
  /// skeleton's extremity is to them. The measure is the sum over a pair of the distances from
  /// labelled hand to true hand and from the true wrists and elbows to the labelled limbs; the same
  /// with feet, ankles and knees. False if an extremity of a pair is not found.
  bool sides_correct = false;
  /// Whether each extremity is correct: its kind is correct, its pair has the correct sides, and
  /// its own true point or tip is within the limit.
  std::array<bool, kLabelledExtremityCount> extremity_correct{};
  bool right = false;  ///< all five extremities are correct
  /// Distance from the centre of the head, knuckles or ball of the foot, mm; NaN if not found.
  std::array<double, kLabelledExtremityCount> error_mm{};
};

/// Precision and recall if frames count as valid from a threshold of validity on.
struct PrecisionRecallPoint {
  double threshold;
  double precision;  ///< fraction of these frames that is correct; NaN without any
  double recall;     ///< fraction of all correct frames that is among them
};

/// Complete frames whose validity lies in one tenth of 0 to 1. If validity is calibrated, both
/// values are equal.
struct ReliabilityBin {
  size_t frames;
  double mean_validity, fraction_correct;
};

/// Errors of one extremity over the valid frames.
struct ExtremityLabelError {
  std::string name;
  double fraction_correct;
  SummaryStatistics error_mm;
};

/// Evaluation of a labelling method over a sequence. Fractions are of the evaluated frames unless
/// noted; NaN without any. A frame without labels is not valid and not correct.
struct LabelErrors {
  std::vector<LabelEvaluation> verdicts;  ///< per frame of the truth
  size_t frames = 0, valid = 0;  ///< number of evaluated frames, and of valid ones among them
  double fraction_valid, fraction_correct, fraction_correct_and_valid, fraction_wrong_but_valid;
  double fraction_kinds_correct;          ///< valid or not, on either side
  double fraction_sides_correct;          ///< of the valid frames
  std::vector<ExtremityLabelError> ends;  ///< by extremityNames()
  SummaryStatistics hands_mm, feet_mm;    ///< left and right together, over the valid frames
  SummaryStatistics hands_if_correct_mm,
      feet_if_correct_mm;  ///< over valid frames in which all five are correct
  /// By threshold from 0 to 1; only complete frames count.
  std::vector<PrecisionRecallPoint> by_threshold;
  std::vector<ReliabilityBin> reliability;  ///< by validity; empty bins are left out
  /// Area under the curve of precision over recall (average precision); 1 if all correct frames
  /// have a higher validity than all wrong ones. NaN without correct frames.
  double precision_recall_area;
};

/// \param truth track with labelTruthNames()
/// \param labels one for each of its frames; throws std::invalid_argument otherwise
LabelErrors labelErrors(const JointTrack& truth, const std::vector<LabelledExtremities>& labels);

}  // namespace markerless_mocap
