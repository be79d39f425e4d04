#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>

#include "tools/common/configuration.h"
#include "tools/common/recording.h"
#include "tools/offline/run_summary.h"

namespace markerless_mocap {

/// Options of a run over a recording.
struct OfflineOptions {
  std::string input, output;  ///< bags
  RecordingOptions recording;
  PipelineOptions pipeline;
  std::string body_id = "person1";
  std::string urdf_template;         ///< empty: the template of this package
  std::string body_file;             ///< shape from an earlier run; empty: none
  std::string save_body;             ///< file for the estimated shape; empty: none
  std::string prepared;              ///< folder of writePreparation(); empty: none
  std::string figures;               ///< file for ResultFigures; empty: none
  std::string report_folder;         ///< empty: no report
  bool report_images = true;         ///< the report has pictures of the cameras
  std::vector<std::string> remarks;  ///< lines at the top of the report
  bool masks_out = false;            ///< also write silhouettes and masks of the person
  bool poses_only = false;           ///< do not write hull, parts and tree
  bool check_calibration = true;     ///< say if the calibration looks wrong
  std::function<bool()> interrupted = [] { return false; };  ///< called for every frame set
};

/// The next frame set of the recording. Throws as Recording::next(), and std::runtime_error if the
/// run was interrupted.
std::optional<FrameSet> nextFrameSet(const OfflineOptions& options, Recording* recording);

/// Processes the first seconds of a recording until the shape of the body is estimated, so that the
/// whole recording can be processed with it. Throws as runOffline().
/// \param backgrounds as Pipeline::useBackgrounds()
/// \param resources receives the shape if it could be estimated
/// \param notes stream for progress and the result; nullptr: none
/// \param terminal true if `notes` is a terminal
void measureBody(const OfflineOptions& options, const std::vector<SharedBackground>& backgrounds,
                 PersonResources* resources, std::ostream* notes, bool terminal);

/// Runs all stages over a bag and writes the results to another bag. The same input gives the same
/// bytes. The output appears only if the run succeeds. Throws std::runtime_error or
/// std::invalid_argument, also if it was interrupted or if there was no frame set to process.
/// \param notes stream for progress and notes; nullptr: none
/// \param terminal true if `notes` is a terminal
RunSummary runOffline(const OfflineOptions& options, std::ostream* notes, bool terminal);

}  // namespace markerless_mocap
