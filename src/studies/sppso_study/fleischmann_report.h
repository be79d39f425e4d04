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

/// Results of a study.
struct StudyReport {
  std::string about;  ///< one line of text about the sequence
  std::vector<StudiedTable> tables;
  std::string parameter;  ///< the parameter that varies in the curves
  FitnessCurves curves;
  TimeByPart time;
};

/// Comma-separated values, one line per run: table, variant, run, errors in mm, fraction of frames
/// with swapped legs, lost frames, ms per frame.
std::string studyCsv(const std::vector<StudiedTable>& tables);

/// HTML page with tables and plots.
std::string studyPage(const StudyReport& report);

}  // namespace markerless_mocap
