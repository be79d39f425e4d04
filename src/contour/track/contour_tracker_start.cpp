// How ContourTracker starts, and starts again to check.
#include <algorithm>
#include <utility>

#include "contour/contour_tracker.h"
#include "contour/track/default_postures.h"
#include "contour/track/exchanged_sides.h"
#include "contour/track/pose_from_pose_tree.h"

namespace markerless_mocap {
namespace {

// A search costs as much as following the person over many frames. After one the next waits for
// this fraction of the time since the first, up to the last value.
constexpr double kRest = 0.2;
constexpr int64_t kLongestRest_ns = 400000000;
constexpr int64_t kCheckInterval_ns = 50000000;

// A search by colour takes longer. Of seventeen starts on the beam film five had a wrong arm or
// exchanged legs; later searches found the right pose, with a higher score. So each start is
// checked by a search, and again after twice this time, then four times and eight times this.
constexpr int64_t kColorCheckInterval_ns = 100000000;
constexpr int kColorChecks = 4;         // at most
constexpr int kColorConfirmations = 2;  // in a row are enough

constexpr RobustSchedule kFitted{10, 0.12, 0.03};  // for poses that have been fitted already

}  // namespace

std::vector<ContourPose> ContourTracker::proposals(const Frame& now) {
  std::vector<ContourPose> poses;
  const FrameProducts& made = now.products.ofThisFrame();
  const BodyPose pose = initializer_->update(now.stamp_ns, made.parts, made.hull);
  initializer_error_ = pose.reason;
  if (pose.status != PoseStatus::kLost)
    poses.push_back(converter_->poseOf(pose.T_world_body, pose.angles));
  if (const auto of_tree = poseFromPoseTree(made.tree)) poses.push_back(*of_tree);
  return poses;
}

std::vector<ContourPose> ContourTracker::completeProposals(const Frame& now,
                                                           const ContourObservation& seen) {
  std::vector<ContourPose> poses = proposals(now);
  markerless_mocap::completeProposals(hypotheses_, seen, *contour_body_,
                                      now.products.ofThisFrame().hull, poses);
  return poses;
}

std::vector<RegionFit> ContourTracker::fitsByColor(const Frame& now, const Search& search) const {
  return searchProposalsByColor(
      {observer_, hypotheses_, now.regions, now.products.ofThisFrame().hull, *contour_body_},
      search.found.seen, search.poses);
}

// Colours find the pose of a body whose stature is about right, and a pose tells the stature better
// than proposals do. So the stature comes first only if no pose of the usual body is found.
bool ContourTracker::findByColor(const Frame& now, Search& search) {
  std::vector<RegionFit> fits = fitsByColor(now, search);
  if (fits.empty() && shape_estimator_) {
    initializeStature(now, search.poses);
    fits = fitsByColor(now, search);
  }
  if (fits.empty()) return false;
  search.poses.clear();
  for (const RegionFit& one : fits) search.poses.push_back(one.fit.pose);
  initializeStature(now, search.poses, kFitted);
  search = {std::move(fits.front().found), {fits.front().fit.pose}};
  return true;
}

// Its limbs have been searched already.
ActiveTrack ContourTracker::startFound(const Frame& now, const Search& search) {
  const ContourObservation& seen = search.found.seen;
  const ContourFit fit = hypotheses_.bestFit(seen, *contour_body_, search.poses, kFitted);
  if (fit.status != ContourFitStatus::kFitted) return {};
  const ActiveTrack active = hypotheses_.startFrom(now.stamp_ns, fit);
  hypotheses_.proposeAlternative(now.stamp_ns, seen, *contour_body_,
                                 {mirrored(*contour_body_, fit.pose)});
  return active;
}

void ContourTracker::scheduleStart(const Frame& now) {
  const bool by_color = now.regions.needsColors();
  if (!searching_since_ns_) searching_since_ns_ = now.stamp_ns;
  next_start_ns_ =
      now.stamp_ns + restAfterSearch(now.stamp_ns, by_color ? 2 * kColorCheckInterval_ns : 0);
  next_check_ns_ = now.stamp_ns + kCheckInterval_ns;
  color_checks_ = color_confirmations_ = 0;
  color_check_.forget();
}

int64_t ContourTracker::restAfterSearch(int64_t stamp_ns, int64_t least_ns) const {
  const double since = double(stamp_ns - searching_since_ns_.value_or(stamp_ns));
  return std::max(least_ns, std::min(int64_t(kRest * since), kLongestRest_ns));
}

ActiveTrack ContourTracker::start(const Frame& now) {
  scheduleStart(now);
  const bool by_color = now.regions.needsColors();
  observer_.reset();
  const VisualHull& hull = now.products.forStart().hull;
  const bool somebody_there = !hull.voxels.empty();
  if (somebody_there && !somebody_there_) searching_since_ns_ = now.stamp_ns;
  somebody_there_ = somebody_there;
  Search search{observer_.observeLargest(now.regions, hull), {}};
  if (search.found.seen.usableViews() < 2) return {};
  search.poses = completeProposals(now, search.found.seen);
  const bool found = by_color && findByColor(now, search);
  if (!by_color) initializeStature(now, search.poses);
  still_contours_.weigh(search.found.seen);
  take(search.found);
  if (found) return startFound(now, search);
  return hypotheses_.start(now.stamp_ns, search.found.seen, *contour_body_, search.poses);
}

bool ContourTracker::onlyFollows(const Frame& now) const {
  return now.behind || (color_check_.isBusy() && !reported_);
}

bool ContourTracker::needsCheck(const Frame& now) const {
  // Colours are asked in another thread, and asked first until a pose has been reported.
  const bool by_color = now.regions.needsColors();
  if ((now.behind && !by_color) || now.stamp_ns < next_check_ns_ || color_check_.isBusy())
    return false;
  return !accepted_ ||
         (by_color && color_checks_ < kColorChecks && color_confirmations_ < kColorConfirmations);
}

ActiveTrack ContourTracker::check(const Frame& now, const ActiveTrack& active) {
  initializer_->reset();  // the proposal must depend on this frame only
  if (now.regions.needsColors()) return checkByColor(now, active);
  next_check_ns_ = now.stamp_ns + restAfterSearch(now.stamp_ns, kCheckInterval_ns);
  Search search{observer_.observe(now.regions), {}};
  search.poses = completeProposals(now, search.found.seen);
  still_contours_.weigh(search.found.seen);
  ActiveTrack best = hypotheses_.reinitialize(now.stamp_ns, search.found.seen, *contour_body_,
                                              search.poses, active);
  if (best.switched) take(search.found);
  return best;
}

ActiveTrack ContourTracker::checkByColor(const Frame& now, const ActiveTrack& active) {
  next_check_ns_ =
      now.stamp_ns + (kColorCheckInterval_ns << std::min(++color_checks_, kColorChecks));
  ColorQuestion question = this->question(now, active.track.fit.pose);
  if (!resources_.in_background)
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
          *contour_body_,
          pose,
          proposals(now)};
}

// What was right some frames ago proposes a pose of this frame; colours decide between both.
ActiveTrack ContourTracker::takeCheck(const Frame& now, const ActiveTrack& active) {
  const std::optional<ColorCheck::Answer> answer = color_check_.answer();
  if (!answer || !answer->found) return active;
  const ContourPose& pose = active.track.fit.pose;
  if (!limbsDiffer(*contour_body_, answer->found->fit.pose, answer->asked))
    return settle(now, active, RegionFit{{}, active.track.fit});
  const ContourPose rival = broughtForward(answer->found->fit.pose, answer->asked, pose);
  return settle(now, active,
                preferred({observer_.withoutColors(), hypotheses_, now.regions,
                           now.products.newestHull(), *contour_body_},
                          pose, rival));
}

ActiveTrack ContourTracker::settle(const Frame& now, const ActiveTrack& active,
                                   const std::optional<RegionFit>& found) {
  if (!found) return active;
  if (!limbsDiffer(*contour_body_, found->fit.pose, active.track.fit.pose)) {
    hypotheses_.confirm();
    ++color_confirmations_;
    return active;
  }
  color_confirmations_ = 0;
  observer_.reset();
  take(found->found);
  return hypotheses_.startFrom(now.stamp_ns, found->fit);
}

}  // namespace markerless_mocap
