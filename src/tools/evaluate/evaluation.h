#pragma once

#include <functional>
#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/angle_error.h"
#include "evaluation/delay.h"
#include "evaluation/joint_error.h"
#include "evaluation/tracking_continuity.h"
#include "tools/evaluate/evaluation_deviation.h"
#include "tools/evaluate/evaluation_feet.h"
#include "tools/evaluate/evaluation_images.h"
#include "tools/evaluate/evaluation_parts.h"
#include "tools/evaluate/evaluation_tree.h"

namespace markerless_mocap {

/// What to judge.
struct EvaluationRequest {
  std::string results, truth;  ///< bags
  std::string body_id;         ///< empty: the only one
  double skip = 0.0;           ///< seconds of the truth to leave out at its begin
  std::string rig;             ///< file that calibrated the run's cameras; empty: the truth's bag
  std::string config;          ///< of the run, for the hull's rules; empty: defaults
  bool images = true;          ///< judge silhouettes and hull
  bool pictures = false;       ///< make overlays
};

/// Everything that is said about a result.
struct Evaluation {
  EvaluationRequest request;
  std::string body_id;
  std::vector<int64_t> stamps_ns;  ///< of the truth's frames
  std::vector<FrameStatus> statuses;
  std::vector<std::string> reasons;
  JointErrors joints;
  TrackingContinuity record;
  Delay delay;
  SummaryStatistics latency_ms;  ///< count 0 when stamps of record and capture are the same
  std::vector<ExtremityError> extremities;      ///< hand, foot
  std::map<std::string, double> tip_errors_mm;  ///< mean by name
  FeetEvaluation feet;
  std::vector<LimbLoss> limbs;
  std::vector<UncertaintyCalibration> deviations;  ///< of the parts whose error is told
  std::vector<AngleError> angles;
  ImageMetrics images;
  std::vector<EvaluatedPicture> pictures;
  std::optional<TreeEvaluation> trees;   ///< when the results have pose trees
  std::optional<PartsEvaluation> parts;  ///< when they have segmented hulls
  std::vector<std::string> notes;        ///< sentences on what could not be judged
};

/// Throws std::runtime_error or std::invalid_argument with one sentence when there is nothing to
/// judge: a bag that cannot be read, no ground truth, no results, other worlds, no overlap in time.
/// \param progress called with the share done, 0..1
Evaluation evaluate(const EvaluationRequest& request, const std::function<void(double)>& progress);

}  // namespace markerless_mocap
