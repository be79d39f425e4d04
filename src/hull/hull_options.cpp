#include <cmath>
#include <stdexcept>
#include <string>

#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxVoxels = 64e6;

Eigen::Vector3d voxelsAlongAxes(const HullOptions& o) {
  // The small amount keeps rounding from adding a layer of voxels.
  return ((o.volume_max - o.volume_min) / o.pitch).array() - 1e-6;
}

}  // namespace

void HullOptions::visit(OptionVisitor& v) {
  v.field("volume_min", volume_min, -100, 100, "lowest corner of the volume, m in world");
  v.field("volume_max", volume_max, -100, 100, "highest corner of the volume, m in world");
  v.field("pitch", pitch, 0.005, 0.2, "edge of a voxel, m");
  v.field("min_views", min_views, 2, 32, "cameras that must see a voxel");
  v.field("missing_votes_allowed", missing_votes_allowed, 0, 31,
          "cameras that see a voxel and may have it outside their silhouette; below min_views");
  v.field("bridging_votes", bridging_votes, 0, 8,
          "further votes that voxels between two pieces of a body may lack to join them");
  v.field("min_component_litres", min_component_litres, 0, 1000,
          "smaller 26-connected components are dropped, litres");
  v.field("color_vote_distance", color_vote_distance, 0, 442,
          "colours of neighbouring voxels closer than this are the same, RGB distance in 0-255");
}

void HullOptions::validate() const {
  checkFields(*this);
  const std::string stage = kStage;
  for (int axis = 0; axis < 3; ++axis)
    if (volume_min[axis] >= volume_max[axis])
      throw std::invalid_argument(stage + "/volume_min is not below volume_max along " +
                                  "xyz"[axis]);
  if (missing_votes_allowed >= min_views)
    throw std::invalid_argument(
        stage + "/missing_votes_allowed is " + std::to_string(missing_votes_allowed) +
        ", allowed is less than min_views, which is " + std::to_string(min_views));
  const double voxels = voxelsAlongAxes(*this).array().ceil().max(1.0).prod();
  if (voxels > kMaxVoxels)
    throw std::invalid_argument(stage + " has " + std::to_string(std::llround(voxels / 1e6)) +
                                " million voxels, allowed are 64 million: make the volume smaller "
                                "or the pitch larger");
}

VoxelLattice HullOptions::lattice() const {
  VoxelLattice lattice;
  lattice.origin = volume_min;
  lattice.pitch = pitch;
  lattice.size = voxelsAlongAxes(*this).array().ceil().max(1.0).matrix().cast<int>();
  return lattice;
}

const char* toString(HullStatus status) {
  switch (status) {
    case HullStatus::kOk:
      return "ok";
    case HullStatus::kNoCameras:
      return "no cameras";
    case HullStatus::kEmptyMasks:
      return "empty masks";
    case HullStatus::kFullMask:
      return "full mask";
    case HullStatus::kNobody:
      return "nobody";
    case HullStatus::kSeveralBodies:
      return "several bodies";
  }
  return "unknown";
}

}  // namespace markerless_mocap
