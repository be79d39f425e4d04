#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Which figures of Hsiao 2008, 3.1.4 to make, and where.
struct EigenmapFigureOptions {
  std::string folder;  ///< made where it is missing
  std::string input;   ///< bag with hulls; empty for the test image only
  std::string topic = "/hull/points";
  double at = 0.0;     ///< seconds after the first hull; the first with voxels from there on
  int frame_sets = 1;  ///< successive hulls
};

/// Hulls with voxels of a bag, as many as wanted or there are. Throws std::runtime_error with one
/// sentence where there is no such bag, topic, grid or hull.
std::vector<VisualHull> hullsOf(const EigenmapFigureOptions& what);

/// Draws the test image (Fig. 3-12, 3-14) by the plain Laplacian with the stop on outliers, the
/// shrunk one with the stop at the origin, and that with colours too; and each hull (Fig. 3-15) by
/// the first, by the last, and by the merge tree. A file shows dimensions 1 to 3 and 4 to 6 and the
/// branches where they are. Signs and near-equal dimensions of successive hulls are turned alike.
/// \return the files' names; throws std::runtime_error where one cannot be written
std::vector<std::string> drawEigenmapFigures(const EigenmapFigureOptions& what);

}  // namespace markerless_mocap
