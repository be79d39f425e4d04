#pragma once

#include <functional>
#include <ostream>

#include "studies/reproduce/paper.h"
#include "studies/reproduce/result_cache.h"

namespace markerless_mocap {

/// How runs are executed.
struct RunListOptions {
  int at_once = 2;
  bool again = false;             ///< also what is in the cache
  std::ostream* notes = nullptr;  ///< for progress and remaining time; nullptr: none
  bool terminal = false;          ///< true if `notes` is a terminal: a bar is redrawn there
  std::function<bool()> interrupted = [] { return false; };
};

/// Executes what the cache lacks, `alone` runs last. Throws std::runtime_error with the first
/// failure after all others are done, if interrupted, and std::invalid_argument if two runs have
/// the same name.
Results executeRuns(const std::vector<PaperRun>& runs, const ResultCache& cache,
                    const RunListOptions& options);

}  // namespace markerless_mocap
