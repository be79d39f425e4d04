#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "capture/virtual_studio.h"
#include "contour/shape_estimation.h"

namespace markerless_mocap {

/// Options of the learning.
struct LearnOptions {
  int people = 16;      ///< people of the virtual studio, of different stature, build and clothes
  int frame_sets = 16;  ///< frames per motion
  std::vector<std::string> motions = {"melee", "lift_drop"};
  StudioFiles files;
  std::function<bool()> interrupted = [] { return false; };  ///< called before every person
};

/// The n-th person: statures, builds and clothes are evenly distributed for any number of people.
CharacterOptions exampleOf(int person);

/// Renders people in the virtual studio, fits the contour body to their exact masks and true
/// joints, and computes the shape statistics. The same options give the same result. Throws as
/// VirtualStudio, if there is no person or frame, and if interrupted. \param notes stream for the
/// result of each person; nullptr: none
ShapeStatistics learnContourBody(const LearnOptions& options, std::ostream* notes);

}  // namespace markerless_mocap
