#include <cmath>
#include <stdexcept>
#include <string>

#include "hull/camera_trust.h"
#include "hull/voting/viewing_volume.h"
#include "markerless_mocap/hull/hull_carver.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxVoxels = 64e6;

Eigen::Vector3d voxelsAlongAxes(const HullOptions& o) {
  // The small amount keeps rounding from adding a layer of voxels.
  return ((o.volume_max - o.volume_min) / o.pitch).array() - 1e-6;
}

void checkVoxels(double voxels) {
  if (voxels > kMaxVoxels)
    throw std::invalid_argument(std::string(HullOptions::kStage) + " has " +
                                std::to_string(std::llround(voxels / 1e6)) +
                                " million voxels, allowed are 64 million: make the volume smaller "
                                "or the pitch larger");
}

}  // namespace

void HullOptions::visit(OptionVisitor& v) {
  const Eigen::Vector3d min_before = volume_min, max_before = volume_max;
  v.field("volume_min", volume_min, -100, 100, "lowest corner of the explicit volume, m in world");
  v.field("volume_max", volume_max, -100, 100, "highest corner of the explicit volume, m in world");
  if (volume_min != min_before || volume_max != max_before) volume = "explicit";
  v.field("volume", volume, {"auto", "explicit"},
          "where the voxels are; auto: all that three quarters of the cameras see above the floor, "
          "and as many must see a voxel; explicit: from volume_min to volume_max, as soon as these "
          "are given");
  v.field("floor_height", floor_height, -100, 100,
          "height of the floor, m in world; the automatic volume begins there");
  v.field("cut_at_floor", cut_at_floor,
          "remove voxels below floor_height, such as reflections in the floor");
  v.field("follow", follow,
          "carve only around the last person; the whole volume while there is none");
  v.field("follow_margin", follow_margin, 0.1, 5,
          "distance from the last person up to which the next hull is carved, m");
  v.field("pitch", pitch, 0.005, 0.2, "edge length of a voxel, m");
  v.field("min_views", min_views, 2, 32, "number of cameras that must see a voxel");
  v.field("missing_votes_allowed", missing_votes_allowed, 0, 31,
          "number of cameras that may see a voxel outside their silhouette; less than min_views");
  v.field("camera_trust", camera_trust,
          "cameras that are not fully trusted, each as camera=trust, 0 to 1; a voxel is removed "
          "when the trust of the cameras that see it outside their silhouette adds up to 1 + "
          "missing_votes_allowed");
  v.field("leave_out_bad_cameras", leave_out_bad_cameras,
          "find cameras whose mask is full, empty or lacks the person, and leave them out");
  v.field(
      "bridging_votes", bridging_votes, 0, 8,
      "number of further votes that voxels between two components of a body may lack to join them");
  v.field("min_component_litres", min_component_litres, 0, 1000,
          "26-connected components below this volume are removed, litres");
  v.field(
      "color_vote_distance", color_vote_distance, 0, 442,
      "colours of neighbouring voxels closer than this are the same, distance in RGB of 0 to 255");
  v.field(
      "color_voters", color_voters, {"visible", "all"},
      "which cameras vote on the colours of two neighbouring voxels; visible: those that see "
      "both; all: those whose image both are projected into, also inside the body and behind it "
      "(Hsiao 2008, 3.1.4.2 A-1)");
}

void HullOptions::validate() const {
  checkFields(*this);
  const std::string stage = kStage;
  for (int axis = 0; volume == "explicit" && axis < 3; ++axis)
    if (volume_min[axis] >= volume_max[axis])
      throw std::invalid_argument(stage + "/volume_min is not below volume_max along " +
                                  "xyz"[axis]);
  if (missing_votes_allowed >= min_views)
    throw std::invalid_argument(
        stage + "/missing_votes_allowed is " + std::to_string(missing_votes_allowed) +
        ", allowed is less than min_views, which is " + std::to_string(min_views));
  if (volume == "explicit") checkVoxels(voxelsAlongAxes(*this).array().ceil().max(1.0).prod());
}

VoxelLattice HullOptions::lattice() const {
  VoxelLattice lattice;
  lattice.origin = volume_min;
  lattice.pitch = pitch;
  lattice.size = voxelsAlongAxes(*this).array().ceil().max(1.0).matrix().cast<int>();
  return lattice;
}

VoxelLattice HullOptions::lattice(const CameraRig& rig) const {
  if (volume == "explicit") return lattice();
  const Eigen::AlignedBox3d seen = viewingVolume(rig, min_views, floor_height);
  if (seen.isEmpty())
    throw std::invalid_argument(std::string(kStage) +
                                "/volume is auto, but most of the cameras see no place above the "
                                "floor in common: give volume_min and volume_max");
  const Eigen::Array3d low = (seen.min().array() / pitch).floor();
  const Eigen::Array3d high = (seen.max().array() / pitch).ceil();
  checkVoxels((high - low).prod());
  VoxelLattice lattice;
  lattice.origin = low * pitch;
  lattice.pitch = pitch;
  lattice.size = (high - low).matrix().cast<int>();
  return lattice;
}

std::vector<double> HullOptions::trust(const CameraRig& rig) const {
  std::vector<std::string> cameras;
  for (const Camera& camera : rig) cameras.push_back(camera.name());
  return trustIn(cameras, camera_trust);
}

}  // namespace markerless_mocap
