#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/paper.h"
#include "studies/reproduce/result_cache.h"

namespace markerless_mocap {

/// Runs a program of this package that lies beside this one. Its error stream goes to a file.
/// Throws std::runtime_error with the last line of it if the program fails.
void runProgram(const std::string& name, const std::vector<std::string>& arguments,
                const std::string& log_file);

/// The settings of a capture, for those of runs.
Json captureSettings(const Capture& capture);

/// Runs that render the captures into the cache, and where they lie.
std::vector<PaperRun> renderRuns(std::vector<Capture>* captures, const ResultCache& cache);

/// A run of mocap_offline over a capture, measured by evaluate.
struct OfflineStudy {
  std::string name;
  std::string config;                  ///< path of a configuration file; empty: the defaults
  std::vector<std::string> arguments;  ///< others of mocap_offline
  std::vector<std::string> evaluate_arguments = {"--no-images"};
};

/// The result is the JSON of `evaluate --json`, with D over time; the bag with the poses is kept
/// beside it: resultBag(). \param folder of the cache
PaperRun offlineRun(const Capture& capture, const OfflineStudy& study, const std::string& folder);
std::string resultBag(const PaperRun& run, const std::string& folder);

}  // namespace markerless_mocap
