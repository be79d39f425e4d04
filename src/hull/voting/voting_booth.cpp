#include "hull/voting/voting_booth.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hull/selection/bridging.h"
#include "hull/selection/ghosts.h"
#include "hull/voting/seen_volume.h"

namespace markerless_mocap {
namespace {

/// Pieces of more than this are several bodies and are not bridged.
constexpr double kMostLitresOfOneBody = 120;

VoxelBox boundsOf(const HullOptions& options, const VoxelLattice& lattice) {
  VoxelBox box{Eigen::Vector3i::Zero(), lattice.size};
  if (!options.cut_at_floor) return box;
  // The lowest voxel whose centre is not below the floor.
  const double layers = (options.floor_height - lattice.origin.z()) / lattice.pitch - 0.5;
  box.low.z() = int(std::clamp(std::ceil(layers), 0.0, double(lattice.size.z())));
  return box;
}

}  // namespace

VotingBooth::VotingBooth(const CameraRig& rig, const HullOptions& options,
                         const VoxelLattice& lattice)
    : rig_(rig),
      options_(options),
      plan_(rig, lattice),
      bounds_(boundsOf(options, lattice)),
      masks_(rig.size()),
      volume_(lattice) {
  const std::vector<double> trust = options.trust(rig);
  const bool equal = std::all_of(trust.begin(), trust.end(), [](double t) { return t == 1; });
  unit_ = equal ? 1 : Ballot::kMostWeight;
  for (const double t : trust) weights_.push_back(uint32_t(std::lround(t * unit_)));
  if (!isSeenEnough())
    throw std::invalid_argument("no voxel of the volume is seen by " +
                                std::to_string(options_.min_views) +
                                " cameras: check volume_min, volume_max and the cameras' poses");
}

bool VotingBooth::isSeenEnough() const {
  const BlockLevel& leaves = plan_.level(0);
  for (size_t leaf = 0; leaf < leaves.sees_some.size(); ++leaf) {
    if (__builtin_popcount(leaves.sees_some[leaf]) < options_.min_views) continue;
    uint64_t counted[64] = {};
    for (size_t c = 0; c < plan_.cameras(); ++c)
      for (uint64_t left = plan_.seen(leaf, c); left != 0; left &= left - 1)
        if (++counted[__builtin_ctzll(left)] >= uint64_t(options_.min_views)) return true;
  }
  return false;
}

void VotingBooth::takeMasks(const std::vector<HullView>& views) {
  tbb::parallel_for(size_t(0), views.size(), [&](size_t c) {
    if (!views[c].mask.empty()) masks_[c].pack(views[c].mask);
  });
  present_ = 0;
  for (size_t c = 0; c < views.size(); ++c)
    if (!views[c].mask.empty()) present_ |= 1u << c;
}

const LeafVolume& VotingBooth::vote(CameraSet voters, int more_missing, const VoxelBox& window) {
  Ballot ballot;
  ballot.weights = weights_;
  for (size_t c = 0; c < masks_.size(); ++c) {
    const bool votes = (voters & present_) >> c & 1 && weights_[c] > 0;
    ballot.masks.push_back(votes ? &masks_[c] : nullptr);
  }
  int min_views = options_.min_views;
  if (options_.volume == "auto") {
    const auto voting =
        ballot.masks.size() - size_t(std::count(ballot.masks.begin(), ballot.masks.end(), nullptr));
    min_views = std::max(min_views, enoughViews(int(voting)));
  }
  // As many more cameras must see a voxel as may miss it.
  ballot.min_views = min_views + more_missing;
  ballot.limit = unit_ * uint32_t(1 + options_.missing_votes_allowed + more_missing);
  ballot.window.low = window.low.cwiseMax(bounds_.low);
  ballot.window.high = window.high.cwiseMin(bounds_.high);
  markerless_mocap::vote(plan_, ballot, &volume_);
  return volume_;
}

std::vector<Piece> VotingBooth::carve(CameraSet voters, const VoxelBox& window) {
  const VoxelLattice& lattice = plan_.lattice();
  const double voxel_litres = std::pow(lattice.pitch * 10, 3);
  const size_t least =
      std::max<size_t>(1, size_t(std::ceil(options_.min_component_litres / voxel_litres)));
  std::vector<Piece> pieces = components_.find(vote(voters, 0, window), lattice);
  markGhosts(rig_, plan_, masks_, voters & present_, &pieces);
  std::stable_partition(pieces.begin(), pieces.end(),
                        [](const Piece& piece) { return !piece.suspect_ghost; });
  double litres = 0;
  for (const Piece& piece : pieces) litres += double(piece.voxels) * voxel_litres;
  if (litres > kMostLitresOfOneBody) return pieces;
  for (int more = 1; more <= options_.bridging_votes; ++more) {
    if (pieces.size() < 2 || pieces[1].suspect_ghost || pieces[1].voxels < least) break;
    const PieceBridging bridging(lattice, [&](const VoxelBox& box) -> const LeafVolume& {
      return vote(voters, more, {box.low.cwiseMax(window.low), box.high.cwiseMin(window.high)});
    });
    pieces = bridging.bridge(std::move(pieces), least);
  }
  return pieces;
}

}  // namespace markerless_mocap
