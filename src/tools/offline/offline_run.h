#pragma once

#include <functional>
#include <optional>
#include <ostream>
#include <string>

#include "tools/common/configuration.h"
#include "tools/common/recording.h"
#include "tools/offline/run_summary.h"

namespace markerless_mocap {

/// What to do with a recording.
struct OfflineOptions {
  std::string input, output;  ///< bags
  RecordingOptions recording;
  PipelineOptions pipeline;
  std::string body_id = "person1";
  std::string urdf_template;         ///< empty: the package's own
  std::string body_file;             ///< sizes measured before; empty: none
  std::string save_body;             ///< where to write them; empty: nowhere
  std::string report_folder;         ///< empty: no report
  std::vector<std::string> remarks;  ///< that the report begins with, a sentence each
  bool masks_out = false;            ///< write the silhouettes too
  std::function<bool()> interrupted = [] { return false; };  ///< asked at every instant
};

/// The next instant of a recording that is run over. Throws as Recording::next(), and
/// std::runtime_error if the run was interrupted.
std::optional<FrameSet> nextFrameSet(const OfflineOptions& options, Recording* recording);

/// Runs over the first seconds of a recording until the body is measured, so that all of it can be
/// fitted with these sizes. Throws as runOffline().
/// \param sources gets the sizes, if they could be measured
/// \param notes where the result is told; nullptr: nowhere
void measureBody(const OfflineOptions& options, PersonResources* sources, std::ostream* notes);

/// Runs all stages over a bag and writes what they make to another; the same input gives the same
/// bytes. The output appears only if the run succeeds. Throws std::runtime_error or
/// std::invalid_argument with one sentence, also when it was interrupted or there was no instant to
/// process.
/// \param notes where progress and remarks go; nullptr: nowhere
/// \param terminal whether notes is a terminal
RunSummary runOffline(const OfflineOptions& options, std::ostream* notes, bool terminal);

}  // namespace markerless_mocap
