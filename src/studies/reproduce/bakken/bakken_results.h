#pragma once

#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// What one variant made of one capture at one resolution.
class LabelResult {
 public:
  /// Without the run everything is empty or NaN.
  LabelResult(const Results& results, const std::string& capture, int edge,
              const std::string& variant);

  size_t frames() const { return right_.size(); }
  double right() const;    ///< share of the frames
  double correct() const;  ///< share of the frames, valid or not
  /// Share of the frames with (or without) a hand above the head that are right; NaN without any.
  double rightWhere(bool raised) const;
  double raised() const;         ///< share of the frames with a hand above the head
  double valid() const;          ///< share of the frames
  double wrongButValid() const;  ///< share of the frames
  /// Errors of an extremity in the frames that are labelled right, mm: "head", "left_hand", ...
  SummaryStatistics error(const std::string& extremity) const;
  /// Mean error of hands and feet of each frame; NaN unless it is labelled right.
  std::vector<double> curve() const;
  std::vector<double> seconds() const;
  std::vector<double> numbers(const std::string& key) const;

 private:
  const Json* film_ = nullptr;
  const Json* variant_ = nullptr;
  std::vector<double> right_, valid_;
};

/// Names of the captures for which there are results, in the order of the paper.
std::vector<std::string> capturesIn(const Results& results);
/// The same of captures of other people.
std::vector<std::string> peopleIn(const Results& results);

/// Milliseconds of a published stage over the frames: "hull", "thinning", "tree", or their "sum".
SummaryStatistics stageTime(const Results& results, const std::string& capture, int edge,
                            const std::string& stage);

/// "46.8 (16.6)": mean and standard deviation; "-" without values.
std::string meanAndDeviation(const SummaryStatistics& values, int decimals = 1);

}  // namespace markerless_mocap
