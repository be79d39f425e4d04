#pragma once

#include <string>
#include <vector>

namespace markerless_mocap {

/// A nodelet of this package to run in this process.
struct HostedStage {
  std::string name;  ///< resolved
  std::string type;  ///< "markerless_mocap/visual_hull"
};

/// Runs stages until ROS is shut down. With the argument --retry, a stage that refuses its
/// parameters is told once, stays an error in /diagnostics, and is tried again every few seconds: a
/// launch file that started the process again would repeat the sentence all the time.
/// \return the process' exit code; 1 if a stage refuses its parameters
int runStages(const std::vector<HostedStage>& stages, const std::vector<std::string>& arguments);

}  // namespace markerless_mocap
