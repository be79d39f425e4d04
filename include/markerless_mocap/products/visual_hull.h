#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// Votes of the cameras that one voxel and its neighbour at +x, +y, +z have the same colour
/// (Hsiao 2008, Eq. 3-13 and 3-15). `votes` of `possible` cameras; 0 of 0 where the neighbour is
/// not in the hull or no colour is known.
struct ColorVotes {
  std::array<uint8_t, 3> votes{};
  std::array<uint8_t, 3> possible{};
};

/// One voxel of the hull.
struct HullVoxel {
  uint32_t index = 0;            ///< linear index in the lattice
  uint8_t views = 0;             ///< cameras that see the voxel
  std::array<uint8_t, 3> rgb{};  ///< mean colour over the cameras; grey where none is known
  ColorVotes color_votes;
};

enum class HullStatus {
  kOk,
  kNoCameras,     ///< fewer cameras present than min_views
  kEmptyMasks,    ///< no camera sees anybody
  kFullMask,      ///< a mask is (nearly) all foreground
  kNobody,        ///< the silhouettes meet in no component that is large enough
  kSeveralBodies  ///< a second component is as large as a body
};

/// A 26-connected component of the foreground.
struct HullComponent {
  double litres = 0;
  double mean_views = 0;       ///< cameras that see a voxel of it, mean
  bool poorly_seen = false;    ///< few cameras see it, far fewer than another component
  bool suspect_ghost = false;  ///< without it the others would explain every silhouette as well
};

/// A camera whose mask was found wrong and was not obeyed.
struct LeftOutCamera {
  std::string name;
  std::string reason;  ///< "its mask is empty, the others see somebody before it"
};

/// What `visual_hull` makes of one instant. Voxels are sorted by index.
struct VisualHull {
  VoxelLattice lattice;
  std::vector<HullVoxel> voxels;  ///< the person's component(s); empty unless usable
  HullStatus status = HullStatus::kNobody;
  std::string reason;  ///< one sentence; empty when kOk
  std::vector<HullComponent>
      components;  ///< before selection: largest first, poorly seen ones and suspects last
  std::vector<LeftOutCamera> cameras_left_out;

  double litres() const {
    const double side_dm = lattice.pitch * 10.0;
    return double(voxels.size()) * side_dm * side_dm * side_dm;
  }
};

const char* toString(HullStatus status);

}  // namespace markerless_mocap
