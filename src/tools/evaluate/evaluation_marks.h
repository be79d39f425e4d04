#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "evaluation/joint_error.h"
#include "evaluation/label_error.h"
#include "pages/page.h"
#include "tools/evaluate/marked_track.h"

namespace markerless_mocap {

/// Comparison of results with marks that were set by hand in the images.
struct MarksEvaluation {
  MarkedTrack marks;
  size_t frames = 0, frames_with_pose = 0;  ///< of the marks
  SummaryStatistics D_mm;          ///< over the frames with a pose; mean over the points of a frame
  std::vector<std::string> names;  ///< points that are marked
  std::vector<SummaryStatistics> errors_mm;       ///< one for each
  size_t arms_exchanged = 0, legs_exchanged = 0;  ///< frames whose points fit better with left and
                                                  ///< right exchanged
  std::optional<LabelErrors> labels;              ///< of the pose trees; empty without
  std::string note;                               ///< why there is no pose; empty: there is
};

/// \param rig rig file of the run \param body_id as readResults()
/// Throws std::runtime_error or std::invalid_argument as readMarks(), triangulated(), readRig(), if
/// the bag has neither poses nor pose trees, or if no marked time is in it.
MarksEvaluation evaluateMarks(const std::string& results, const std::string& body_id,
                              const std::string& marks, const std::string& rig);

void printMarks(const MarksEvaluation& evaluation, std::ostream& out);
/// As JSON text.
std::string marksJson(const MarksEvaluation& evaluation);

}  // namespace markerless_mocap
