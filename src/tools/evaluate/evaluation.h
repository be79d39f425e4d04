#pragma once

#include <functional>
#include <map>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <utility>
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

/// Input of an evaluation.
struct EvaluationRequest {
  std::string results, truth;  ///< bags
  std::string body_id;         ///< empty: the only one
  double skip = 0.0;           ///< seconds to leave out at the begin of the ground truth
  std::string rig;             ///< rig file of the run; empty: the cameras of the ground truth
  std::string config;  ///< configuration of the run, for the options of the hull; empty: defaults
  bool images = true;  ///< evaluate silhouettes and hull
  bool page = false;   ///< keep what the player of a page shows; with `images` its pictures, too
};

/// All results of an evaluation.
struct Evaluation {
  EvaluationRequest request;
  std::string body_id;
  std::vector<int64_t> stamps_ns;  ///< of the frames of the ground truth
  std::vector<FrameStatus> statuses;
  std::vector<std::string> reasons;
  std::shared_ptr<const BodyModel> body;
  bool has_description = false;     ///< false: of the body only its names are valid
  std::vector<ResultFrame> frames;  ///< the result in each frame of the ground truth
  JointTrack truth;                 ///< bodyPointNames()
  ShownImages shown;                ///< empty unless a page is wanted
  JointErrors joints;
  TrackingContinuity record;
  Delay delay;
  SummaryStatistics latency_ms;             ///< count 0 if record time and capture time are equal
  std::vector<ExtremityError> extremities;  ///< hand, foot
  std::map<std::string, double> tip_errors_mm;  ///< mean per extremity
  FeetEvaluation feet;
  std::vector<LimbLoss> limbs;
  std::vector<UncertaintyCalibration> deviations;  ///< of the parts with an estimated standard
                                                   ///< deviation
  std::vector<AngleError> angles;
  ImageMetrics images;
  std::optional<TreeEvaluation> trees;   ///< empty if the results have no pose trees
  std::optional<PartsEvaluation> parts;  ///< empty if the results have no segmented hulls
  std::vector<std::string> notes;        ///< messages about what could not be evaluated
};

/// The frames with maximum, median and minimum D, with these names.
std::vector<std::pair<const char*, size_t>> representativeFrames(const std::vector<double>& D);

/// Throws std::runtime_error or std::invalid_argument if an evaluation is not possible: a bag that
/// cannot be read, no ground truth, no results, different world frames, or no overlap in time.
/// \param progress called with the fraction done, 0 to 1
Evaluation evaluate(const EvaluationRequest& request, const std::function<void(double)>& progress);

}  // namespace markerless_mocap
