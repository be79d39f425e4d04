#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/options/options.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Settings of the visual hull stage.
struct HullOptions {
  static constexpr const char* kStage = "visual_hull";
  /// lowest corner of the explicit volume, m in world
  Eigen::Vector3d volume_min = Eigen::Vector3d::Zero();
  /// highest corner of the explicit volume, m in world
  Eigen::Vector3d volume_max = Eigen::Vector3d::Zero();
  /// where the voxels are; auto: all that three quarters of the cameras see above the floor, and as
  /// many must see a voxel; explicit: from volume_min to volume_max, as soon as these are given
  std::string volume = "auto";
  /// height of the floor, m in world; the automatic volume begins there
  double floor_height = 0.0;
  /// remove voxels below floor_height, such as reflections in the floor
  bool cut_at_floor = false;
  /// carve only around the last person; the whole volume while there is none
  bool follow = false;
  /// distance from the last person up to which the next hull is carved, m
  double follow_margin = 0.6;
  /// edge length of a voxel, m
  double pitch = 0.03;
  /// number of cameras that must see a voxel
  int min_views = 2;
  /// number of cameras that may see a voxel outside their silhouette; less than min_views
  int missing_votes_allowed = 0;
  /// cameras that are not fully trusted, each as camera=trust, 0 to 1; a voxel is removed when the
  /// trust of the cameras that see it outside their silhouette adds up to 1 + missing_votes_allowed
  std::vector<std::string> camera_trust;
  /// find cameras whose mask is full, empty or lacks the person, and leave them out
  bool leave_out_bad_cameras = true;
  /// number of further votes that voxels between two components of a body may lack to join them
  int bridging_votes = 2;
  /// 26-connected components below this volume are removed, litres
  double min_component_litres = 1.0;
  /// colours of neighbouring voxels closer than this are the same, distance in RGB of 0 to 255
  double color_vote_distance = 40.0;
  /// which cameras vote on the colours of two neighbouring voxels; visible: those that see both;
  /// all: those whose image both are projected into, also inside the body and behind it (Hsiao
  /// 2008, 3.1.4.2 A-1)
  std::string color_voters = "visible";

  /// A visitor that changes volume_min or volume_max makes the volume explicit.
  void visit(OptionVisitor& v);
  /// Throws std::invalid_argument naming key, value and allowed range; also for an explicit volume
  /// that is empty or has more than 64 million voxels.
  void validate() const;
  /// The lattice that covers the explicit volume; reaches beyond volume_max by less than a voxel.
  VoxelLattice lattice() const;
  /// The lattice for a rig: lattice(), or where `volume` is auto the box of all that most of the
  /// cameras see above the floor, on multiples of the pitch, so that a voxel keeps its place when
  /// the rig changes. Throws std::invalid_argument if there is no such box or it is too large.
  VoxelLattice lattice(const CameraRig& rig) const;
  /// Trust in each camera of the rig, 0 to 1. Throws std::invalid_argument on an entry of
  /// camera_trust that is not <camera>=<number> with a camera of the rig and a number of 0 to 1.
  std::vector<double> trust(const CameraRig& rig) const;
};

/// What one camera adds to a frame set. Both mats are empty if the camera's frame is missing.
struct HullView {
  /// CV_8UC1, size of the camera; each pixel that is not 0 may be person (255 is, 128 is unknown).
  /// A mask of which more than a quarter is unknown does not vote.
  cv::Mat mask;
  cv::Mat image;  ///< CV_8UC3 BGR or CV_8UC1, may be empty: no colour from this camera
};

/// A hull whose voxels have been found, but not been listed: that takes longer than to find them.
struct HullDraft {
  struct Found;
  VisualHull hull;                     ///< without voxels
  std::shared_ptr<const Found> found;  ///< what HullCarver::complete() lists; null: there are none
};

/// Carves the visual hull of one rig in one volume by voxel voting (Hsiao 2008, 3.1.3; Bakken &
/// Hilton 2012, 3.2).
///
/// A voxel is foreground under two conditions. At least `min_views` cameras see it; in an automatic
/// volume also three quarters of the cameras that have a mask. And the cameras that have it outside
/// their silhouette have together less trust than 1 + `missing_votes_allowed`. If all cameras have
/// trust 1, these are at most `missing_votes_allowed` cameras. A camera does not vote on a voxel
/// that it does not see (behind the camera or outside its image). A camera with trust 0 never
/// votes.
///
/// A gap in a silhouette may cut the body into several components. They are joined by voxels that
/// lack up to `bridging_votes` more votes. A camera is left out and reported if its mask is full,
/// or if it is empty or lacks a person on whom the other cameras agree.
class HullCarver {
 public:
  /// Computes the projection of each voxel into each camera. Throws std::invalid_argument if there
  /// are fewer than 2 or more than 32 cameras, two cameras of one name, `min_views` above the
  /// number of cameras, more than 512 million pairs of voxel and camera, or a volume in which no
  /// voxel is seen by `min_views` cameras.
  HullCarver(CameraRig rig, const HullOptions& options);
  ~HullCarver();
  HullCarver(HullCarver&&) noexcept;
  HullCarver& operator=(HullCarver&&) noexcept;

  /// Carves one frame set. Of several bodies the person is the one that is where the person of the
  /// last frame set was, or else the only one that is upright; without one the hull has none.
  /// Depends on earlier calls by this, and if `follow` is on. Not thread-safe.
  /// \param views one per camera of the rig, in the rig's order; throws std::invalid_argument on a
  ///   wrong count, size or type
  VisualHull carve(const std::vector<HullView>& views);

  /// carve() in two parts, where the voxels of most frame sets are not needed: draft() for each
  /// frame set, as carve(), and complete() for some of them, at any time. One thread may complete
  /// while another one drafts.
  HullDraft draft(const std::vector<HullView>& views);
  VisualHull complete(HullDraft draft);

  const CameraRig& rig() const;
  const VoxelLattice& lattice() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace markerless_mocap
