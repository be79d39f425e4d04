#include "segmentation/limbs/upper_arms.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace markerless_mocap {
namespace {

// Of clothed adults, in cube roots of the hull's volume.
constexpr double kShoulderBelow = 0.39;  // below the end of the head, along the trunk
constexpr double kShoulderAside = 0.37;  // from the centre line
constexpr double kHipBelow = 1.54;
constexpr double kHipAside = 0.1;
constexpr double kArmRadius = 0.16;     // of an upper arm in a hull
constexpr double kSideThickness = 0.1;  // of the trunk's side, in addition to an arm's radius
constexpr double kEnd = 0.12;           // distance over which a limb's end is averaged
constexpr double kTrunkReach = 1.3;     // length of the trunk from which its direction is estimated
constexpr double kChestDepth = 0.5;     // length of the chest
constexpr double kChestRadius = 0.65;
constexpr size_t kMinChest = 8;  // nodes

double unitOf(const VoxelGraph& voxels) {
  return voxels.pitch * std::cbrt(double(voxels.graph.nodeCount()));
}

std::vector<PartLabel> ownersOf(const VoxelGraph& voxels, const Limbs& limbs) {
  std::vector<PartLabel> owner(voxels.graph.nodeCount(), PartLabel::kTorso);
  for (int part = 1; part < kPartCount; ++part)
    for (const uint32_t node : limbs.branch[part].nodes) owner[node] = PartLabel(part);
  return owner;
}

/// Centre of a limb's cross-section at its border.
Eigen::Vector3d endOf(const VoxelGraph& voxels, const Limbs& limbs, PartLabel limb) {
  const std::vector<double>& geodesic = limbs.geodesic[size_t(limb)];
  const std::vector<uint32_t>& nodes = limbs.branch[size_t(limb)].nodes;
  double farthest = 0.0;
  for (const uint32_t node : nodes) farthest = std::max(farthest, geodesic[node]);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const uint32_t node : nodes) {
    if (geodesic[node] <= farthest - kEnd) continue;
    sum += voxels.centers[node];
    ++count;
  }
  return sum / count;
}

std::optional<Eigen::Vector3d> upTheTrunk(const VoxelGraph& voxels,
                                          const std::vector<PartLabel>& owner,
                                          const Eigen::Vector3d& neck) {
  const double reach = kTrunkReach * unitOf(voxels);
  Eigen::Vector3d down = Eigen::Vector3d::Zero();
  for (size_t node = 0; node < owner.size(); ++node) {
    const Eigen::Vector3d from = voxels.centers[node] - neck;
    if (owner[node] == PartLabel::kTorso && from.squaredNorm() < reach * reach) down += from;
  }
  if (down.squaredNorm() == 0.0) return {};
  return -down.normalized();
}

/// Direction across the trunk in which the chest is widest.
std::optional<Eigen::Vector3d> acrossTheChest(const VoxelGraph& voxels,
                                              const std::vector<PartLabel>& owner,
                                              const Eigen::Vector3d& neck,
                                              const Eigen::Vector3d& up) {
  const double unit = unitOf(voxels);
  const double radius = kChestRadius * unit;
  std::vector<Eigen::Vector3d> chest;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (size_t node = 0; node < owner.size(); ++node) {
    if (owner[node] == PartLabel::kHead) continue;
    const Eigen::Vector3d from = voxels.centers[node] - neck;
    const double above = from.dot(up);
    const Eigen::Vector3d aside = from - above * up;
    if (above > 0.0 || above < -kChestDepth * unit || aside.squaredNorm() > radius * radius)
      continue;
    chest.push_back(aside);
    mean += aside;
  }
  if (chest.size() < kMinChest) return {};
  mean /= double(chest.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& aside : chest) spread += (aside - mean) * (aside - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
}

/// A line from one point to another.
class Line {
 public:
  Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
      : from_(from), along_(to - from), scale_(1.0 / std::max(along_.squaredNorm(), 1e-12)) {}

  double squaredDistance(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d offset = point - from_;
    const double fraction = std::clamp(offset.dot(along_) * scale_, 0.0, 1.0);
    return (offset - fraction * along_).squaredNorm();
  }

 private:
  Eigen::Vector3d from_, along_;
  double scale_;
};

void addUpperArm(const VoxelGraph& voxels, const Eigen::Vector3d& end, const TrunkSide& side,
                 const std::vector<PartLabel>& owner, std::vector<uint32_t>* nodes) {
  const double unit = unitOf(voxels);
  const double radius = kArmRadius * unit;
  const Line arm(end, side.shoulder), trunk(side.shoulder, side.hip);
  for (uint32_t node = 0; node < owner.size(); ++node) {
    if (owner[node] != PartLabel::kTorso) continue;
    const double to_arm = arm.squaredDistance(voxels.centers[node]);
    if (to_arm >= radius * radius) continue;
    const double to_side = std::sqrt(trunk.squaredDistance(voxels.centers[node]));
    if (std::sqrt(to_arm) + kSideThickness * unit < to_side) nodes->push_back(node);
  }
  std::sort(nodes->begin(), nodes->end());
}

}  // namespace

std::optional<std::array<TrunkSide, 2>> findTrunkSides(const VoxelGraph& voxels,
                                                       const Limbs& limbs) {
  if (!limbs.has(PartLabel::kHead)) return {};
  const std::vector<PartLabel> owner = ownersOf(voxels, limbs);
  const Eigen::Vector3d neck = endOf(voxels, limbs, PartLabel::kHead);
  const auto up = upTheTrunk(voxels, owner, neck);
  if (!up) return {};
  const auto across = acrossTheChest(voxels, owner, neck, *up);
  if (!across) return {};
  const auto at = [&](double below, double aside) -> Eigen::Vector3d {
    return neck + unitOf(voxels) * (aside * *across - below * *up);
  };
  return std::array<TrunkSide, 2>{
      TrunkSide{at(kShoulderBelow, kShoulderAside), at(kHipBelow, kHipAside)},
      TrunkSide{at(kShoulderBelow, -kShoulderAside), at(kHipBelow, -kHipAside)}};
}

void addUpperArms(const VoxelGraph& voxels, Limbs* limbs) {
  const auto sides = findTrunkSides(voxels, *limbs);
  if (!sides) return;
  constexpr std::array<PartLabel, 2> kArms{PartLabel::kArm1, PartLabel::kArm2};
  std::array<Eigen::Vector3d, 2> end;
  std::array<double, 2> length{};  // sum of both lines for each assignment of arms to sides
  for (size_t arm = 0; arm < 2; ++arm) {
    if (!limbs->has(kArms[arm])) continue;
    end[arm] = endOf(voxels, *limbs, kArms[arm]);
    for (size_t swap = 0; swap < 2; ++swap)
      length[swap] += (end[arm] - (*sides)[arm ^ swap].shoulder).norm();
  }
  const size_t swap = length[1] < length[0] ? 1 : 0;
  for (size_t arm = 0; arm < 2; ++arm) {
    if (!limbs->has(kArms[arm])) continue;
    const std::vector<PartLabel> owner = ownersOf(voxels, *limbs);
    addUpperArm(voxels, end[arm], (*sides)[arm ^ swap], owner,
                &limbs->branch[size_t(kArms[arm])].nodes);
  }
}

}  // namespace markerless_mocap
