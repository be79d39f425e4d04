// How ContourTracker checks the pose that it follows.
#include <algorithm>
#include <utility>

#include "contour/contour_tracker.h"
#include "contour/regions/placed_contour_body.h"
#include "contour/track/exchanged_sides.h"
#include "contour/track/limbs_in_doubt.h"
#include "contour/track/pose_from_pose_tree.h"
#include "contour/track/pose_report.h"
#include "region/things_beside.h"

namespace markerless_mocap {
namespace {

// Of a person whom nothing hides, 95 % of the fits are better.
constexpr double kUsualQuality = 0.94;

constexpr double kJustNow = 1e-3;  // seconds, of a prediction that is a fit to the same frame set

}  // namespace

bool ContourTracker::needsCheck(const Frame& now, const ContourFit& fit) const {
  if (goes_back_) return false;
  // Colours are asked in another thread, and asked first until a pose has been reported.
  const bool by_color = now.regions.needsColors();
  if ((!by_color && now.behind && now.behind()) || !starts_.isCheckDue(now.stamp_ns) ||
      color_check_.isBusy())
    return false;
  return !trust_.isAccepted() || trust_.isDoubted(now.stamp_ns, fit) ||
         (by_color && starts_.wantsColorChecks());
}

ActiveTrack ContourTracker::check(const Frame& now, const ActiveTrack& active) {
  proposals_.reset();
  if (now.regions.needsColors()) return checkByColor(now, active);
  starts_.checkBegins(now.stamp_ns);
  Search search{observer_.observe(now.regions), {}};
  search.poses = completeProposals(now, search.found.seen);
  contradicted_.leaveOut(search.found.seen);
  ActiveTrack best = hypotheses_.reinitialize(now.stamp_ns, search.found.seen, person_.body(),
                                              search.poses, active);
  if (best.switched) trust_.take(search.found);
  if (best.agreed) trust_.agree(best.track.fit);
  return best;
}

ActiveTrack ContourTracker::checkByColor(const Frame& now, const ActiveTrack& active) {
  starts_.colorCheckBegins(now.stamp_ns);
  ColorQuestion question = this->question(now, active.track.fit.pose);
  if (!person_.resources().in_background)
    return settle(now, active, answered(completed(std::move(question))));
  question.frame = question.frame.clone();  // the messages end with this frame
  color_check_.ask(std::move(question), reported_ ? ColorCheck::kBeside : ColorCheck::kAwaited);
  return active;
}

ColorQuestion ContourTracker::question(const Frame& now, const ContourPose& pose) {
  return {observer_.withoutColors(),
          hypotheses_,
          now.regions,
          now.products.ofThisFrame().hull,
          person_.body(),
          pose,
          proposals(now)};
}

// What was right some frames ago proposes a pose of this frame; colours decide between both.
ActiveTrack ContourTracker::takeCheck(const Frame& now, const ActiveTrack& active) {
  const std::optional<ColorCheck::Answer> answer = color_check_.answer();
  if (!answer || !answer->found) return active;
  const ContourPose& pose = active.track.fit.pose;
  if (!limbsDiffer(person_.body(), answer->found->fit.pose, answer->asked))
    return settle(now, active, RegionFit{{}, active.track.fit});
  const ContourPose rival = broughtForward(answer->found->fit.pose, answer->asked, pose);
  return settle(now, active,
                preferred({observer_.withoutColors(), hypotheses_, now.regions,
                           now.products.newestHull(), person_.body()},
                          pose, rival));
}

ActiveTrack ContourTracker::settle(const Frame& now, const ActiveTrack& active,
                                   const std::optional<RegionFit>& found) {
  if (!found) return active;
  if (!limbsDiffer(person_.body(), found->fit.pose, active.track.fit.pose)) {
    hypotheses_.confirm();
    starts_.confirm();
    return active;
  }
  starts_.contradict(now.stamp_ns);
  observer_.reset();
  trust_.take(found->found);
  const bool is_same = isSameBody(person_.body(), found->fit.pose, active.track.fit.pose);
  ActiveTrack replaced = hypotheses_.startFrom(now.stamp_ns, found->fit);
  if (is_same) hypotheses_.confirm();  // but for a limb
  return replaced;
}

// A limb that colours follow in a wrong place is contradicted by silhouettes, or silhouettes show
// it elsewhere.
void ContourTracker::searchLimbs(const Frame& now, RegionObservation& found, ActiveTrack& active) {
  const double least = *std::min_element(found.limb_agreement.begin(), found.limb_agreement.end());
  const bool doubtful = isFresh(now) || least < kMinLimbAgreement;
  if (!doubtful) limb_search_.beImpatient();
  if (!doubtful || !limb_search_.isDue(now.stamp_ns) || !now.regions.needsColors()) return;
  auto better = searchLimbsByColor(
      {observer_, hypotheses_, now.regions, now.products.newestHull(), person_.body()},
      {found, active.track.fit});
  limb_search_.done(now.stamp_ns, better.has_value());
  if (!better) return;
  found = std::move(better->found);
  active = hypotheses_.startFrom(now.stamp_ns, better->fit);
}

void ContourTracker::searchLimbsInDoubt(const Frame& now, ActiveTrack& active) {
  if (now.doubted_masks.empty() || !search_in_doubt_.isDue(now.stamp_ns)) return;
  search_in_doubt_.done(now.stamp_ns);
  const CameraRig& rig = observer_.rig();
  const ContourBody& body = person_.body();
  const ContourFit& fit = active.track.fit;
  ContourObservation seen = observer_.observe(
      withoutThingsBeside(now.doubted_masks, {}, rig, placedBody(body, fit.pose), kJustNow).masks);
  shift(now, seen);
  contradicted_.leaveOut(seen);
  const auto found = findLimbsInDoubt(hypotheses_, seen, rig, body, fit);
  if (found) active = hypotheses_.startFrom(now.stamp_ns, *found);
}

// A valid pose tree is nearly always right, so it becomes the alternative if it contradicts a pose
// that fits poorly. While the pose is uncertain, an invalid tree and exchanged sides are tried,
// too.
void ContourTracker::reconsider(const Frame& now, const ContourObservation& seen,
                                const ContourTrackingResult& track) {
  const bool uncertain = isFresh(now) || track.status == ContourTrackingStatus::kLimbLost;
  const bool doubtful = uncertain || qualityOf(track.fit) < kUsualQuality;
  if (!doubtful || !reconsideration_.isDue(now.stamp_ns) || hypotheses_.hasAlternative()) return;
  reconsideration_.done(now.stamp_ns);
  const ContourBody& body = person_.body();
  std::vector<ContourPose> others;
  const PoseTree& tree = now.products.ofThisFrame().tree;
  const auto of_tree = poseFromPoseTree(tree);
  if (of_tree && (uncertain || tree.valid()) && limbsDiffer(body, track.fit.pose, *of_tree))
    others.push_back(*of_tree);
  if (isFresh(now)) {
    others.push_back(mirrored(body, track.fit.pose));
    others.push_back(withLegsSwapped(body, track.fit.pose));
  }
  if (others.empty()) return;
  hypotheses_.proposeAlternative(now.stamp_ns, seen, body, others);
}

}  // namespace markerless_mocap
