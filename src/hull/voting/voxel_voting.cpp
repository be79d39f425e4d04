#include "hull/voting/voxel_voting.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hull/selection/bridging.h"
#include "hull/selection/ghosts.h"
#include "hull/voting/viewing_volume.h"

namespace markerless_mocap {
namespace {

/// Components of more than this in total are several bodies and are not bridged.
constexpr double kMaxLitresOfOneBody = 120;

VoxelBox boundsOf(const HullOptions& options, const VoxelLattice& lattice) {
  VoxelBox box{Eigen::Vector3i::Zero(), lattice.size};
  if (!options.cut_at_floor) return box;
  // The first layer whose centres are not below the floor.
  const double layers = (options.floor_height - lattice.origin.z()) / lattice.pitch - 0.5;
  box.low.z() = int(std::clamp(std::ceil(layers), 0.0, double(lattice.size.z())));
  return box;
}

}  // namespace

VoxelVoting::VoxelVoting(const CameraRig& rig, const HullOptions& options,
                         const VoxelLattice& lattice)
    : rig_(rig),
      options_(options),
      table_(rig, lattice),
      bounds_(boundsOf(options, lattice)),
      masks_(rig.size()),
      volume_(lattice) {
  const std::vector<double> trust = options.trust(rig);
  const bool equal = std::all_of(trust.begin(), trust.end(), [](double t) { return t == 1; });
  unit_ = equal ? 1 : VoteRule::kMaxWeight;
  for (const double t : trust) weights_.push_back(uint32_t(std::lround(t * unit_)));
  if (!isSeenEnough())
    throw std::invalid_argument("no voxel of the volume is seen by " +
                                std::to_string(options_.min_views) +
                                " cameras: check volume_min, volume_max and the cameras' poses");
}

bool VoxelVoting::isSeenEnough() const {
  const BlockLevel& bricks = table_.level(0);
  for (size_t brick = 0; brick < bricks.sees_some.size(); ++brick) {
    if (__builtin_popcount(bricks.sees_some[brick]) < options_.min_views) continue;
    uint64_t counted[64] = {};
    for (size_t c = 0; c < table_.cameras(); ++c)
      for (uint64_t left = table_.seen(brick, c); left != 0; left &= left - 1)
        if (++counted[__builtin_ctzll(left)] >= uint64_t(options_.min_views)) return true;
  }
  return false;
}

void VoxelVoting::setMasks(const std::vector<HullView>& views) {
  tbb::parallel_for(size_t(0), views.size(), [&](size_t c) {
    if (!views[c].mask.empty()) masks_[c].pack(views[c].mask);
  });
  present_ = 0;
  for (size_t c = 0; c < views.size(); ++c)
    if (!views[c].mask.empty()) present_ |= 1u << c;
}

const BrickVolume& VoxelVoting::vote(CameraSet voters, int more_missing, const VoxelBox& window) {
  VoteRule rule;
  rule.weights = weights_;
  for (size_t c = 0; c < masks_.size(); ++c) {
    const bool votes = (voters & present_) >> c & 1 && weights_[c] > 0;
    rule.masks.push_back(votes ? &masks_[c] : nullptr);
  }
  int min_views = options_.min_views;
  if (options_.volume == "auto") {
    const auto voting =
        rule.masks.size() - size_t(std::count(rule.masks.begin(), rule.masks.end(), nullptr));
    min_views = std::max(min_views, minViewsOf(int(voting)));
  }
  // The number of cameras that must see a voxel grows by the number of votes that may be missing.
  rule.min_views = min_views + more_missing;
  rule.limit = unit_ * uint32_t(1 + options_.missing_votes_allowed + more_missing);
  rule.window.low = window.low.cwiseMax(bounds_.low);
  rule.window.high = window.high.cwiseMin(bounds_.high);
  markerless_mocap::vote(table_, rule, &volume_);
  return volume_;
}

std::vector<VoxelComponent> VoxelVoting::carve(CameraSet voters, const VoxelBox& window) {
  const VoxelLattice& lattice = table_.lattice();
  const double voxel_litres = std::pow(lattice.pitch * 10, 3);
  const size_t min_voxels =
      std::max<size_t>(1, size_t(std::ceil(options_.min_component_litres / voxel_litres)));
  std::vector<VoxelComponent> components = components_.find(vote(voters, 0, window), lattice);
  markGhosts(rig_, table_, masks_, voters & present_, &components);
  std::stable_partition(components.begin(), components.end(),
                        [](const VoxelComponent& component) { return !component.suspect_ghost; });
  double litres = 0;
  for (const VoxelComponent& component : components)
    litres += double(component.voxels) * voxel_litres;
  if (litres > kMaxLitresOfOneBody) return components;
  for (int more = 1; more <= options_.bridging_votes; ++more) {
    if (components.size() < 2 || components[1].suspect_ghost || components[1].voxels < min_voxels)
      break;
    const ComponentBridging bridging(lattice, [&](const VoxelBox& box) -> const BrickVolume& {
      return vote(voters, more, {box.low.cwiseMax(window.low), box.high.cwiseMin(window.high)});
    });
    components = bridging.bridge(std::move(components), min_voxels);
  }
  return components;
}

}  // namespace markerless_mocap
