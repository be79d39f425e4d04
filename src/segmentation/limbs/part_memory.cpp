#include "segmentation/limbs/part_memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "segmentation/limbs/limbs.h"
#include "segmentation/voxel_graph.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kMaxGap = 250'000'000;     // ns between frames
constexpr int64_t kMaxUnseen = 350'000'000;  // ns
constexpr double kReach = 0.05;              // metres that a limb moves relative to the trunk
constexpr auto kNothing = uint8_t(kPartCount);

Eigen::Vector3d middleOf(const VoxelGraph& voxels) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& center : voxels.centers) sum += center;
  return sum / double(voxels.centers.size());
}

PartLabel after(PartLabel label) {
  return PartLabel(size_t(label) + 1);
}

void exchange(Limbs* limbs, PartLabel first) {
  const auto one = size_t(first), other = one + 1;
  std::swap(limbs->branch[one], limbs->branch[other]);
  std::swap(limbs->geodesic[one], limbs->geodesic[other]);
  std::swap(limbs->whole[one], limbs->whole[other]);
  std::swap(limbs->loop[one], limbs->loop[other]);
}

}  // namespace

void PartMemory::number(int64_t stamp_ns, const VoxelGraph& voxels, Limbs* limbs) {
  if (stamp_ns <= stamp_ns_ || stamp_ns > stamp_ns_ + kMaxGap) pitch_ = 0.0;
  if (pitch_ == 0.0) return;
  for (const PartLabel first : {PartLabel::kArm1, PartLabel::kLeg1})
    if (isNumberedOtherwise(voxels, *limbs, first)) exchange(limbs, first);
}

std::array<bool, kPartCount> PartMemory::carryOver(int64_t stamp_ns, const VoxelGraph& voxels,
                                                   const Limbs& limbs,
                                                   std::vector<PartLabel>* labels) const {
  std::array<bool, kPartCount> carried{}, wanted{};
  for (int part = 1; part < kPartCount; ++part)
    wanted[part] = !limbs.has(PartLabel(part)) && stamp_ns - seen_ns_[part] <= kMaxUnseen;
  const bool any = std::any_of(wanted.begin(), wanted.end(), [](bool want) { return want; });
  if (pitch_ == 0.0 || !any) return carried;
  const Eigen::Vector3d middle = middleOf(voxels);
  for (size_t node = 0; node < labels->size(); ++node) {
    if ((*labels)[node] != PartLabel::kTorso) continue;
    const PartLabel was = nearest(placeOf(voxels.centers[node], middle));
    if (!wanted[size_t(was)]) continue;
    (*labels)[node] = was;
    carried[size_t(was)] = true;
  }
  return carried;
}

void PartMemory::keep(int64_t stamp_ns, const VoxelGraph& voxels, const Limbs& limbs,
                      const std::vector<PartLabel>& labels) {
  for (int part = 1; part < kPartCount; ++part) {
    if (limbs.has(PartLabel(part)))
      seen_ns_[part] = stamp_ns;
    else if (pitch_ == 0.0)
      seen_ns_[part] = stamp_ns - kMaxUnseen - 1;
  }
  if (pitch_ != voxels.pitch) {
    pitch_ = voxels.pitch;
    findSteps();
  }
  stamp_ns_ = stamp_ns;
  middle_ = middleOf(voxels);
  Eigen::Vector3d high = corner_ = voxels.centers.front();
  for (const Eigen::Vector3d& center : voxels.centers) {
    corner_ = corner_.cwiseMin(center);
    high = high.cwiseMax(center);
  }
  size_ = placeOf(high, middle_).array() + 1;
  label_.assign(size_t(size_.x()) * size_t(size_.y()) * size_t(size_.z()), kNothing);
  for (size_t node = 0; node < labels.size(); ++node) {
    const Eigen::Vector3i place = placeOf(voxels.centers[node], middle_);
    label_[(size_t(place.z()) * size_.y() + place.y()) * size_.x() + place.x()] =
        uint8_t(labels[node]);
  }
}

Eigen::Vector3i PartMemory::placeOf(const Eigen::Vector3d& center,
                                    const Eigen::Vector3d& middle) const {
  const Eigen::Vector3d steps = (center - middle + middle_ - corner_) / pitch_;
  return {int(std::lround(steps.x())), int(std::lround(steps.y())), int(std::lround(steps.z()))};
}

PartLabel PartMemory::nearest(const Eigen::Vector3i& place) const {
  for (const Eigen::Vector3i& step : steps_) {
    const Eigen::Vector3i at = place + step;
    if ((at.array() < 0).any() || (at.array() >= size_.array()).any()) continue;
    const uint8_t label = label_[(size_t(at.z()) * size_.y() + at.y()) * size_.x() + at.x()];
    if (label != kNothing) return PartLabel(label);
  }
  return PartLabel::kTorso;
}

bool PartMemory::isNumberedOtherwise(const VoxelGraph& voxels, const Limbs& limbs,
                                     PartLabel first) const {
  const Eigen::Vector3d middle = middleOf(voxels);
  long same = 0;
  for (const PartLabel now : {first, after(first)}) {
    for (const uint32_t node : limbs.branch[size_t(now)].nodes) {
      const PartLabel was = nearest(placeOf(voxels.centers[node], middle));
      if (was == first || was == after(first)) same += was == now ? 1 : -1;
    }
  }
  return same < 0;
}

void PartMemory::findSteps() {
  steps_.clear();
  const int reach = int(kReach / pitch_);
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k)
        if (Eigen::Vector3d(i, j, k).norm() * pitch_ <= kReach) steps_.emplace_back(i, j, k);
  std::stable_sort(steps_.begin(), steps_.end(),
                   [](const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
                     return a.squaredNorm() < b.squaredNorm();
                   });
}

}  // namespace markerless_mocap
