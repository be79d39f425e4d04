#pragma once

#include <string>
#include <vector>

namespace markerless_mocap {

/// kError: poses will be wrong or missing. kWarning: poses will suffer. kNote: worth knowing.
enum class Severity { kNote, kWarning, kError };
const char* toString(Severity severity);

/// One thing that is wrong with a recording.
struct Finding {
  std::string what;    ///< stable name, as in docs/checking.md: "time_offset"
  std::string camera;  ///< empty: the whole rig; of two cameras "cam0, cam1"
  Severity severity = Severity::kWarning;
  std::string evidence;  ///< a sentence with numbers and units
  std::string remedy;    ///< a sentence
};

using Findings = std::vector<Finding>;

}  // namespace markerless_mocap
