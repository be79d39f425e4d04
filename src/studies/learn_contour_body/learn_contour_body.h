#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "capture/virtual_studio.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// Whom to learn from.
struct LearnOptions {
  int people = 16;      ///< of the virtual studio: all sizes, builds and clothes
  int frame_sets = 16;  ///< of each motion
  std::vector<std::string> motions = {"melee", "lift_drop"};
  StudioFiles files;
  std::function<bool()> interrupted = [] { return false; };  ///< asked before every person
};

/// The n-th person: statures, builds and clothes are spread evenly, whatever the number of people.
CharacterOptions exampleOf(int person);

/// Films people of the virtual studio, fits the contour body to their exact masks and true joints,
/// and takes the mean. Same options, same template. Throws as VirtualStudio, on fewer than one
/// person or instant, and when interrupted. \param notes where each person's fit is told; nullptr:
/// nowhere
ShapeStatistics learnContourBody(const LearnOptions& options, std::ostream* notes);

}  // namespace markerless_mocap
