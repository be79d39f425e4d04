#include "hull/selection/person_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace markerless_mocap {
namespace {

/// A silhouette that covers more of its image shows no outline to carve with.
constexpr double kFullMaskShare = 0.95;
/// A second component is a second body when it is at least this large.
constexpr double kSecondBodyShare = 0.4;
constexpr double kSecondBodyLitres = 15.0;
/// A component that is seen by no more than this share of the cameras that see another one is not
/// carved well enough to be compared with it.
constexpr double kPoorlySeenShare = 0.5;

std::string oneDecimal(double value) {
  const long tenths = std::lround(value * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

double meanViews(const Piece& piece, const CarvingPlan& plan, CameraSet voters) {
  size_t views = 0;
  for (const Cell& cell : piece.cells) {
    const CameraSet all = plan.level(0).sees_all[cell.leaf] & voters;
    views += size_t(__builtin_popcount(all)) * size_t(__builtin_popcountll(cell.voxels));
    for (CameraSet part = plan.level(0).sees_some[cell.leaf] & voters & ~all; part != 0;
         part &= part - 1)
      views += size_t(
          __builtin_popcountll(cell.voxels & plan.seen(cell.leaf, size_t(__builtin_ctz(part)))));
  }
  return double(views) / double(piece.voxels);
}

/// Whether nothing speaks against taking the component for a body.
bool isTrusted(const HullComponent& component) {
  return !component.poorly_seen && !component.suspect_ghost;
}

}  // namespace

MaskSurvey surveyMasks(const CameraRig& rig, const VotingBooth& booth) {
  MaskSurvey result;
  result.present = booth.present();
  for (size_t c = 0; c < rig.size(); ++c) {
    if ((result.present >> c & 1) == 0) continue;
    const double set = double(booth.mask(c).setPixels());
    if (set == 0) result.empty |= 1u << c;
    if (set >= kFullMaskShare * rig[c].width() * rig[c].height()) result.full |= 1u << c;
  }
  return result;
}

std::string namesOf(CameraSet cameras, const CameraRig& rig) {
  std::string names;
  for (size_t c = 0; c < rig.size(); ++c)
    if (cameras >> c & 1) names += (names.empty() ? "'" : ", '") + rig[c].name() + "'";
  return names;
}

bool refuseMasks(const MaskSurvey& masks, CameraSet usable, const CameraRig& rig, int min_views,
                 VisualHull* hull) {
  if (masks.count() < min_views) {
    hull->status = HullStatus::kNoCameras;
    hull->reason = std::to_string(masks.count()) + " of " + std::to_string(rig.size()) +
                   " cameras are present, " + std::to_string(min_views) + " are needed";
  } else if (masks.empty == masks.present) {
    hull->status = HullStatus::kEmptyMasks;
    hull->reason = "the masks of all " + std::to_string(masks.count()) + " cameras are empty";
  } else if ((masks.full & usable) != 0) {
    hull->status = HullStatus::kFullMask;
    hull->reason = "the mask of " + namesOf(masks.full, rig) +
                   " is full: nobody stands out from the background there";
  } else {
    return false;
  }
  return true;
}

std::vector<Piece> rankPieces(std::vector<Piece> pieces, const CarvingPlan& plan, CameraSet voters,
                              double min_component_litres, VisualHull* hull) {
  const double voxel_litres = std::pow(plan.lattice().pitch * 10, 3);
  std::vector<HullComponent> components;
  double most_views = 0;
  for (const Piece& piece : pieces) {
    HullComponent component;
    component.litres = double(piece.voxels) * voxel_litres;
    component.mean_views = meanViews(piece, plan, voters);
    component.suspect_ghost = piece.suspect_ghost;
    if (component.litres >= min_component_litres)
      most_views = std::max(most_views, component.mean_views);
    components.push_back(component);
  }
  for (HullComponent& component : components)
    component.poorly_seen = component.mean_views <= kPoorlySeenShare * most_views;
  std::vector<size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_partition(order.begin(), order.end(),
                        [&](size_t i) { return isTrusted(components[i]); });
  std::vector<Piece> ranked;
  for (const size_t i : order) {
    ranked.push_back(std::move(pieces[i]));
    hull->components.push_back(components[i]);
  }
  return ranked;
}

const Piece* selectPerson(const std::vector<Piece>& pieces, double min_component_litres,
                          const MaskSurvey& masks, const CameraRig& rig, VisualHull* hull) {
  const std::vector<HullComponent>& components = hull->components;
  if (components.empty() || components[0].litres < min_component_litres) {
    hull->status = HullStatus::kNobody;
    hull->reason = components.empty()
                       ? "the silhouettes meet nowhere in the volume"
                       : "the largest component has " + oneDecimal(components[0].litres) +
                             " litres, a body has at least " + oneDecimal(min_component_litres);
    if (masks.empty != 0)
      hull->reason += "; the mask of " + namesOf(masks.empty, rig) + " is empty";
    return nullptr;
  }
  if (components.size() > 1 && isTrusted(components[1]) &&
      components[1].litres >= kSecondBodyShare * components[0].litres &&
      components[1].litres >= kSecondBodyLitres) {
    hull->status = HullStatus::kSeveralBodies;
    hull->reason = "there are several bodies: components of " + oneDecimal(components[0].litres) +
                   " and " + oneDecimal(components[1].litres) + " litres";
    return nullptr;
  }
  hull->status = HullStatus::kOk;
  hull->reason.clear();
  return &pieces[0];
}

}  // namespace markerless_mocap
