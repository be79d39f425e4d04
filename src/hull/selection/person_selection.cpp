#include "hull/selection/person_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace markerless_mocap {
namespace {

/// A silhouette that covers more of its image has no outline to carve with.
constexpr double kFullMaskFraction = 0.95;
/// Of several bodies, the last person's has at least the first fraction of the last person's
/// voxels, and at least the second one of what all of them have.
constexpr double kStayedFraction = 0.3, kPlainFraction = 0.8;
/// A component is poorly seen if the number of cameras that see it is at most this fraction of the
/// number that see another component. Its size is then not comparable.
constexpr double kPoorlySeenFraction = 0.5;
/// Of several bodies, the only one that is at least as high as the first value, while all others
/// are lower than the second one, is the person: sun on the floor, a box and a dog are not. Who
/// sits or kneels is about 1.2 m high.
constexpr double kUpright_m = 1.0, kLow_m = 0.8;

std::string oneDecimal(double value) {
  const long tenths = std::lround(value * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

double meanViews(const VoxelComponent& component, const ProjectionTable& table, CameraSet voters) {
  size_t views = 0;
  for (const BrickVoxels& cell : component.cells) {
    const CameraSet all = table.level(0).sees_all[cell.brick] & voters;
    views += size_t(__builtin_popcount(all)) * size_t(__builtin_popcountll(cell.voxels));
    for (CameraSet part = table.level(0).sees_some[cell.brick] & voters & ~all; part != 0;
         part &= part - 1)
      views += size_t(
          __builtin_popcountll(cell.voxels & table.seen(cell.brick, size_t(__builtin_ctz(part)))));
  }
  return double(views) / double(component.voxels);
}

/// Whether the component may be a body.
bool isTrusted(const HullComponent& component) {
  return !component.poorly_seen && !component.suspect_ghost && !component.unsure;
}

/// How many of the ranked components are as large as a body, at least 1.
size_t numberOfBodies(const std::vector<HullComponent>& ranked) {
  size_t bodies = 1;
  while (bodies < ranked.size() && isTrusted(ranked[bodies]) &&
         ranked[bodies].litres >= kSecondBodyFraction * ranked[0].litres &&
         ranked[bodies].litres >= kSecondBodyLitres)
    ++bodies;
  return bodies;
}

/// Which of the first `bodies` components is the last person; null if that is not plain.
const VoxelComponent* sameAsLast(const std::vector<VoxelComponent>& components, size_t bodies,
                                 const VoxelComponent* last) {
  if (last == nullptr) return nullptr;
  std::vector<size_t> common;
  for (size_t i = 0; i < bodies; ++i) common.push_back(commonVoxels(components[i], *last));
  const size_t best = size_t(std::max_element(common.begin(), common.end()) - common.begin());
  const size_t all = std::accumulate(common.begin(), common.end(), size_t(0));
  const bool stayed = double(common[best]) >= kStayedFraction * double(last->voxels);
  return stayed && double(common[best]) >= kPlainFraction * double(all) ? &components[best]
                                                                        : nullptr;
}

/// Which of the first `bodies` components is the only one that is upright; null if that is not
/// plain.
const VoxelComponent* onlyUpright(const std::vector<VoxelComponent>& components, size_t bodies,
                                  const std::vector<HullComponent>& summaries) {
  const VoxelComponent* upright = nullptr;
  for (size_t i = 0; i < bodies; ++i) {
    if (summaries[i].height_m < kLow_m) continue;
    if (summaries[i].height_m < kUpright_m || upright != nullptr) return nullptr;
    upright = &components[i];
  }
  return upright;
}

}  // namespace

MaskSummary summariseMasks(const CameraRig& rig, const VoxelVoting& voting) {
  MaskSummary result;
  result.present = voting.present();
  for (size_t c = 0; c < rig.size(); ++c) {
    if ((result.present >> c & 1) == 0) continue;
    const double set = double(voting.mask(c).setPixels());
    if (set == 0) result.empty |= 1u << c;
    if (set >= kFullMaskFraction * rig[c].width() * rig[c].height()) result.full |= 1u << c;
  }
  return result;
}

std::string namesOf(CameraSet cameras, const CameraRig& rig) {
  std::string names;
  for (size_t c = 0; c < rig.size(); ++c)
    if (cameras >> c & 1) names += (names.empty() ? "'" : ", '") + rig[c].name() + "'";
  return names;
}

bool rejectMasks(const MaskSummary& masks, CameraSet usable, const CameraRig& rig, int min_views,
                 VisualHull* hull) {
  if (masks.count() < min_views) {
    hull->status = HullStatus::kNoCameras;
    hull->reason = std::to_string(masks.count()) + " of " + std::to_string(rig.size()) +
                   " cameras are present, " + std::to_string(min_views) + " are needed";
  } else if (masks.empty == masks.present) {
    hull->status = HullStatus::kEmptyMasks;
    hull->reason = "the masks of all " + std::to_string(masks.count()) +
                   " cameras are empty: nobody is there, or "
                   "somebody has stood still since the background "
                   "was learned and has to move to be seen";
  } else if ((masks.full & usable) != 0) {
    hull->status = HullStatus::kFullMask;
    hull->reason = "the mask of " + namesOf(masks.full, rig) +
                   " is full: no person can be separated from the background";
  } else {
    return false;
  }
  return true;
}

std::vector<VoxelComponent> rankComponents(std::vector<VoxelComponent> components,
                                           const ProjectionTable& table, CameraSet voters,
                                           double min_component_litres, VisualHull* hull) {
  const double voxel_litres = std::pow(table.lattice().pitch * 10, 3);
  std::vector<HullComponent> summaries;
  double max_views = 0;
  for (const VoxelComponent& component : components) {
    HullComponent summary;
    summary.litres = double(component.voxels) * voxel_litres;
    summary.mean_views = meanViews(component, table, voters);
    const VoxelBox box = boxOf(component, table.lattice());
    summary.height_m = table.lattice().pitch * (box.high.z() - box.low.z());
    summary.suspect_ghost = component.suspect_ghost;
    summary.unsure = component.unsure;
    if (summary.litres >= min_component_litres) max_views = std::max(max_views, summary.mean_views);
    summaries.push_back(summary);
  }
  for (HullComponent& summary : summaries)
    summary.poorly_seen = summary.mean_views <= kPoorlySeenFraction * max_views;
  std::vector<size_t> order(components.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_partition(order.begin(), order.end(),
                        [&](size_t i) { return isTrusted(summaries[i]); });
  std::vector<VoxelComponent> ranked;
  for (const size_t i : order) {
    ranked.push_back(std::move(components[i]));
    hull->components.push_back(summaries[i]);
  }
  return ranked;
}

const VoxelComponent* selectPerson(const std::vector<VoxelComponent>& components,
                                   double min_component_litres, const MaskSummary& masks,
                                   const CameraRig& rig, const VoxelComponent* last,
                                   VisualHull* hull) {
  const std::vector<HullComponent>& summaries = hull->components;
  if (summaries.empty() || summaries[0].litres < min_component_litres) {
    hull->status = HullStatus::kNobody;
    hull->reason = summaries.empty()
                       ? "the silhouettes meet nowhere in the volume"
                       : "the largest component has " + oneDecimal(summaries[0].litres) +
                             " litres, a body has at least " + oneDecimal(min_component_litres);
    if (masks.empty != 0)
      hull->reason += "; the mask of " + namesOf(masks.empty, rig) + " is empty";
    return nullptr;
  }
  const size_t bodies = numberOfBodies(summaries);
  const VoxelComponent* person =
      bodies > 1 ? sameAsLast(components, bodies, last) : &components.front();
  if (person == nullptr) person = onlyUpright(components, bodies, summaries);
  if (person == nullptr) {
    hull->status = HullStatus::kSeveralBodies;
    hull->reason = "there are several bodies: components of " + oneDecimal(summaries[0].litres) +
                   " and " + oneDecimal(summaries[1].litres) + " litres";
    return nullptr;
  }
  hull->status = HullStatus::kOk;
  hull->reason.clear();
  return person;
}

}  // namespace markerless_mocap
