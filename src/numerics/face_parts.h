#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace markerless_mocap {

/// The largest part of a lattice's cells that hangs together by faces; the first of equal ones.
/// \param cells distinct, each coordinate 0 to 2^20
/// \returns their places in the list, ascending
std::vector<size_t> largestFacePart(const std::vector<Eigen::Vector3i>& cells);

}  // namespace markerless_mocap
