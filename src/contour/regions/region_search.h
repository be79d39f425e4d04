#pragma once

#include <optional>
#include <vector>

#include "contour/regions/region_observer.h"
#include "contour/track/contour_multi_hypothesis_tracker.h"

namespace markerless_mocap {

/// A pose and what colours show around it.
struct RegionFit {
  RegionObservation found;
  ContourFit fit;
  double hull_below = 0.0;  ///< see hullBelow(), metres
  /// To compare poses of the same frame set: the pose must fit what colours found around it, the
  /// silhouettes must show the same person, and its legs must reach down as far as the hull.
  double score() const;
};

/// A frame set, and who is looked for in it with what.
struct ColorScene {
  const RegionObserver& observer;
  const ContourMultiHypothesisTracker& tracker;
  const RegionFrame& frame;
  const VisualHull& hull;
  const ContourBody& body;
};

/// Moves poses to where the colours of the frame set fit: in turn, colours around the pose show a
/// person, and the pose is fitted to that person. Then the same with other places of the limbs,
/// which the silhouettes propose.
/// \param poses may be wrong by tenths of a radian and decimetres
/// \param rival what has been found already, or null: limbs are not searched of poses that have
///   come to the same, nor where they would hardly reach its score
/// \param limb_searches at most so many poses have their limbs searched, which takes longest
/// \return different poses, best first; those that cannot be fitted are left out
std::vector<RegionFit> searchByColor(const ColorScene& scene, const std::vector<ContourPose>& poses,
                                     const RegionFit* rival = nullptr, size_t limb_searches = 2);

/// The same from the most promising of many poses. \param seen what they are judged by
std::vector<RegionFit> searchProposalsByColor(const ColorScene& scene,
                                              const ContourObservation& seen,
                                              const std::vector<ContourPose>& proposals,
                                              const RegionFit* rival = nullptr,
                                              size_t limb_searches = 2);

/// A pose moved to where the colours of the frame set fit; its limbs are not searched.
RegionFit fitByColor(const ColorScene& scene, const ContourPose& pose);

/// Other places of the limbs of a pose that was found with colours, proposed by the silhouettes.
/// \return empty if they are not better
std::optional<RegionFit> searchLimbsByColor(const ColorScene& scene, const RegionFit& first);

}  // namespace markerless_mocap
