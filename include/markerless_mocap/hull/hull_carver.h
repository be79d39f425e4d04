#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/hull/visual_hull.h"
#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the visual hull stage.
struct HullOptions {
  static constexpr const char* kStage = "visual_hull";
  Eigen::Vector3d volume_min{-1.5, -1.5, 0.0};
  Eigen::Vector3d volume_max{1.5, 1.5, 2.2};
  double pitch = 0.03;
  int min_views = 2;
  int missing_votes_allowed = 0;
  int bridging_votes = 2;
  double min_component_litres = 1.0;
  double color_vote_distance = 40.0;

  void visit(OptionVisitor& v);
  /// Throws std::invalid_argument naming key, value and allowed range; also for an empty volume or
  /// one of more than 64 million voxels.
  void validate() const;
  /// The lattice that covers the volume; reaches beyond volume_max by less than a voxel.
  VoxelLattice lattice() const;
};

/// One camera's share of an instant. Empty mats: the camera is missing at this instant.
struct HullView {
  cv::Mat mask;   ///< CV_8UC1, 0 | 255, size of the camera
  cv::Mat image;  ///< CV_8UC3 BGR or CV_8UC1, may be empty: no colour from this camera
};

struct Voter;

/// Carves the visual hull of one rig in one volume (Hsiao 2008, 3.1.3; Bakken & Hilton 2012, 3.2).
/// A voxel is foreground when at least `min_views` cameras see it and all but
/// `missing_votes_allowed` of those have it in their silhouette. A camera that does not see a voxel
/// (behind it, or outside its image) has no vote. Where a silhouette with a gap has cut the body in
/// pieces, they are joined by voxels that lack up to `bridging_votes` more votes.
class HullCarver {
 public:
  /// Builds the projection table. Throws std::invalid_argument: fewer than 2 or more than 32
  /// cameras, two cameras of one name, `min_views` above the number of cameras, a projection table
  /// of more than 512 million entries, or a volume of which no voxel is seen by `min_views`.
  HullCarver(CameraRig rig, const HullOptions& options);

  /// \param views one per camera of the rig, in its order; throws std::invalid_argument on a wrong
  ///   count, size or type
  VisualHull carve(const std::vector<HullView>& views) const;

  const CameraRig& rig() const { return rig_; }
  const VoxelLattice& lattice() const { return lattice_; }

 private:
  void checkRig() const;
  void buildProjectionTable();
  void checkViews(const std::vector<HullView>& views) const;
  /// Components of the foreground, largest first, pieces of one body joined.
  std::vector<std::vector<uint32_t>> carvePieces(const std::vector<Voter>& voters) const;
  /// Fills the hull's voxels: indices, views, colours and colour votes.
  void describeVoxels(const std::vector<HullView>& views, const std::vector<uint32_t>& person,
                      VisualHull* hull) const;

  CameraRig rig_;
  HullOptions options_;
  VoxelLattice lattice_;
  /// [camera][voxel] pixel offset y * width + x, or -1 where the camera does not see the voxel.
  std::vector<std::vector<int32_t>> pixel_of_voxel_;
};

}  // namespace markerless_mocap
