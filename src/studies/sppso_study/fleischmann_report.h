#pragma once

#include <string>
#include <vector>

#include "studies/sppso_study/sppso_study.h"

namespace markerless_mocap {

/// A table with the results of its variants.
struct StudiedTable {
  StudyTable table;
  std::vector<StudyResult> results;  ///< by variant
};

/// What a study found.
struct StudyReport {
  std::string about;  ///< one sentence about the film
  std::vector<StudiedTable> tables;
  std::string parameter;  ///< that the curves vary
  FitnessCurves curves;
  TimeByPart time;
};

/// Comma-separated lines, one for each run: table, variant, run, errors in mm, share of frames with
/// legs swapped, lost frames, ms per frame.
std::string studyCsv(const std::vector<StudiedTable>& tables);

/// The page with tables and graphs.
std::string studyPage(const StudyReport& report);

}  // namespace markerless_mocap
