// How ContourTracker starts.
#include <utility>

#include "contour/contour_tracker.h"
#include "contour/measure/likely_stature.h"
#include "contour/track/default_postures.h"
#include "contour/track/exchanged_sides.h"

namespace markerless_mocap {
namespace {

constexpr RobustSchedule kFitted{10, 0.12, 0.03};  // for poses that have been fitted already

// Of the best pose that colours find, of a body whose stature is about right, 0.86 and more, and
// beside a chair 0.77. One that is too small by a quarter fits head and trunk, with folded legs:
// 0.7.
constexpr double kPoorQuality = 0.8;

std::vector<ContourPose> posesOf(const std::vector<RegionFit>& fits) {
  std::vector<ContourPose> poses;
  for (const RegionFit& one : fits) poses.push_back(one.fit.pose);
  return poses;
}

}  // namespace

bool ContourTracker::restsFromSearching(const TrackerInput& now) const {
  if (!starts_.rests(now.stamp_ns)) return false;
  return starts_.isSomebodyThere() || now.products.newestHull().voxels.empty();
}

std::vector<ContourPose> ContourTracker::proposals(const Frame& now) {
  return proposals_.of(now.stamp_ns, now.products.ofThisFrame(), person_.converter());
}

std::vector<ContourPose> ContourTracker::completeProposals(const Frame& now,
                                                           const ContourObservation& seen) {
  std::vector<ContourPose> poses = proposals(now);
  markerless_mocap::completeProposals(hypotheses_, seen, person_.body(),
                                      now.products.ofThisFrame().hull, poses);
  return poses;
}

std::vector<RegionFit> ContourTracker::fitsByColor(const Frame& now, const Search& search) const {
  return searchProposalsByColor(
      {observer_, hypotheses_, now.regions, now.products.ofThisFrame().hull, person_.body()},
      search.found.seen, search.poses);
}

// Masks do not tell the stature of somebody who sits: their furniture belongs to them. The best
// pose tells which stature is better; its limbs are searched once, as that takes longest.
bool ContourTracker::findOtherStature(const Frame& now, std::vector<RegionFit>& fits) {
  if (!person_.isBeingMeasured() || qualityOf(fits.front().fit) >= kPoorQuality) return false;
  RegionFit best = fits.front();
  const auto search = [&](const ContourBody& body, size_t limb_searches) {
    return searchByColor(
        {observer_, hypotheses_, now.regions, now.products.ofThisFrame().hull, body},
        {best.fit.pose}, nullptr, limb_searches);
  };
  const auto score_of = [&](double stature) {
    std::vector<RegionFit> others = search(person_.meanBody(stature), 0);
    const double score = others.empty() ? 0.0 : others.front().score();
    if (score > best.score()) best = std::move(others.front());
    return score;
  };
  const double before = person_.stature();
  const double stature = betterStature({before, best.score()}, score_of).stature;
  if (stature == before) return false;
  person_.setStature(stature);
  bodyHasChanged();
  fits = search(person_.body(), 1);
  if (fits.empty()) fits = {std::move(best)};
  return true;
}

// Colours find the pose of a body whose stature is about right, and a pose tells the stature better
// than proposals do. So the stature comes first only if no pose of the usual body is found.
bool ContourTracker::findByColor(const Frame& now, Search& search) {
  std::vector<RegionFit> fits = fitsByColor(now, search);
  if (fits.empty() && person_.isBeingMeasured()) {
    initializeStature(now, search.poses);
    fits = fitsByColor(now, search);
  }
  if (fits.empty()) return false;
  if (!findOtherStature(now, fits)) initializeStature(now, posesOf(fits), kFitted);
  search = {std::move(fits.front().found), {fits.front().fit.pose}};
  return true;
}

// Its limbs have been searched already.
ActiveTrack ContourTracker::startFound(const Frame& now, const Search& search) {
  const ContourObservation& seen = search.found.seen;
  const ContourFit fit = hypotheses_.bestFit(seen, person_.body(), search.poses, kFitted);
  if (fit.status != ContourFitStatus::kFitted) return {};
  ActiveTrack active = hypotheses_.startFrom(now.stamp_ns, fit);
  hypotheses_.proposeAlternative(now.stamp_ns, seen, person_.body(),
                                 {mirrored(person_.body(), fit.pose)});
  return active;
}

// The shape estimate converges only from nearby, so it starts with the stature of best quality.
void ContourTracker::initializeStature(const Frame& now, const std::vector<ContourPose>& poses,
                                       const RobustSchedule& schedule) {
  if (!person_.isBeingMeasured() || poses.empty()) return;
  const ContourObservation seen = now.regions.needsColors()
                                      ? observer_.observeRoughly(now.regions.masks)
                                      : observer_.observe(now.regions.masks);
  person_.setStature(likelyStature(person_.options().stature, [&](double stature) {
    return qualityOf(hypotheses_.bestFit(seen, person_.meanBody(stature), poses, schedule));
  }));
  bodyHasChanged();
}

ActiveTrack ContourTracker::start(const Frame& now) {
  const bool by_color = now.regions.needsColors();
  starts_.startBegins(now.stamp_ns, by_color);
  color_check_.forget();
  observer_.reset();
  const VisualHull& hull = now.products.forStart().hull;
  starts_.noteHull(now.stamp_ns, !hull.voxels.empty());
  Search search{observer_.observeLargest(now.regions, hull), {}};
  if (search.found.seen.usableViews() < 2) return {};
  search.poses = completeProposals(now, search.found.seen);
  const bool found = by_color && findByColor(now, search);
  if (!by_color) initializeStature(now, search.poses);
  trust_.take(search.found);
  if (found) return startFound(now, search);
  return hypotheses_.start(now.stamp_ns, search.found.seen, person_.body(), search.poses);
}

}  // namespace markerless_mocap
