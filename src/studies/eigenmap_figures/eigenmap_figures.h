#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Which figures of Hsiao 2008, 3.1.4 to draw, and the folder for them.
struct EigenmapFigureOptions {
  std::string folder;  ///< created if it does not exist
  std::string input;   ///< bag with hulls; empty for the test image only
  std::string topic = "/hull/points";
  double at = 0.0;     ///< seconds after the first hull: start with the next hull with voxels
  int frame_sets = 1;  ///< number of successive hulls
};

/// Reads up to frame_sets hulls with voxels from a bag. Throws std::runtime_error if the bag, the
/// topic, the grid or a hull is missing.
std::vector<VisualHull> hullsOf(const EigenmapFigureOptions& what);

/// Draws the test image (Fig. 3-12, 3-14) with the plain Laplacian and termination by outliers,
/// with the modified one and termination at the origin, and with the modified one and colours;
/// draws each hull (Fig. 3-15) with the first and the last of these and with the merge tree. Each
/// file shows dimensions 1 to 3, dimensions 4 to 6, and the branches in space. Signs and order of
/// nearly equal dimensions are aligned between successive hulls.
/// \return the file names; throws std::runtime_error if a file cannot be written
std::vector<std::string> drawEigenmapFigures(const EigenmapFigureOptions& what);

}  // namespace markerless_mocap
