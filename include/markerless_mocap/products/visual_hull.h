#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// Votes of the cameras that a voxel and its neighbours at +x, +y and +z have the same colour
/// (Hsiao 2008, Eq. 3-13 and 3-15): `votes` of `possible` cameras. Both are 0 if the neighbour is
/// not in the hull or no colour is known.
struct ColorVotes {
  std::array<uint8_t, 3> votes{};
  std::array<uint8_t, 3> possible{};
};

/// One voxel of the hull.
struct HullVoxel {
  uint32_t index = 0;            ///< linear index in the lattice
  uint8_t views = 0;             ///< number of cameras that see the voxel
  std::array<uint8_t, 3> rgb{};  ///< mean colour over the cameras; grey if no colour is known
  ColorVotes color_votes;
};

enum class HullStatus {
  kOk,
  kNoCameras,     ///< fewer cameras present than min_views
  kEmptyMasks,    ///< no camera sees a person
  kFullMask,      ///< a mask is (nearly) all foreground
  kNobody,        ///< no component is large enough
  kSeveralBodies  ///< a second component is as large as a body
};

/// A 26-connected component of the foreground.
struct HullComponent {
  double litres = 0;
  double height_m = 0;         ///< from its lowest to its highest voxel
  double mean_views = 0;       ///< number of cameras that see a voxel, mean over its voxels
  bool poorly_seen = false;    ///< far fewer cameras see it than another component
  bool suspect_ghost = false;  ///< without it, the other components explain all silhouettes as well
  bool unsure = false;         ///< hardly a camera sees a person there, the background is unknown
};

/// A camera whose mask was found to be wrong and was not used.
struct LeftOutCamera {
  std::string name;
  /// For example "its mask is empty, but other cameras see a person in its view".
  std::string reason;
};

/// Result of `visual_hull` for one frame set. Voxels are sorted by index.
struct VisualHull {
  VoxelLattice lattice;
  /// Of the person's component or components; empty if there is no usable hull.
  std::vector<HullVoxel> voxels;
  HullStatus status = HullStatus::kNobody;
  std::string reason;  ///< message for the user; empty when kOk
  /// All components, largest first; poorly seen, unsure and suspected ghosts last.
  std::vector<HullComponent> components;
  std::vector<LeftOutCamera> cameras_left_out;

  double litres() const {
    const double side_dm = lattice.pitch * 10.0;
    return double(voxels.size()) * side_dm * side_dm * side_dm;
  }
};

const char* toString(HullStatus status);

}  // namespace markerless_mocap
